// The leaf nearest to a point or a box.
//
// Depth first, nearest child first, pruned by the best distance so far: Samet, "Foundations of
// Multidimensional and Metric Data Structures" (2006), 4.1; without its priority queue, so the stack is all
// the memory needed.
#ifndef OSEM_NEAREST_HPP
#define OSEM_NEAREST_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/query.hpp"
#include "osem/status.hpp"

namespace osem {

/// Outcome of a search for the nearest leaf.
struct NearestOutcome {
    Status status;
    bool found;             ///< else no leaf of the colours is within the bound
    Leaf leaf;              ///< without meaning when none was found
    std::uint64_t distance; ///< to the closed leaf, squared; below 2^62; 0 when they touch or overlap
    std::uint32_t visited;  ///< nodes visited
};

/// The leaf nearest to a closed box among those whose colour is in a set: the least Euclidean distance
/// between a point of the box and one of the closed leaf, exact as its square. Of several the first in Morton
/// order. A box with low = high is a point; one with high = low + (1, 1, 1) a cell.
///
/// Leaves farther than `within`, a squared distance, are not looked for; UINT64_MAX sets no bound. Status:
/// ok; coordinate_out_of_range when a bound of the box is outside [-2^29, 2^29]; box_empty when low > high
/// along an axis. Cost: O(nodes visited); a node is visited only if its octant may hold a leaf that comes
/// before the best known then. Stack: one node and one byte a level.
NearestOutcome nearest_leaf(const Octree& tree, const CellBox& from, std::uint8_t colours = solid_colours,
                            std::uint64_t within = UINT64_MAX);

/// The leaf nearest to a lattice point.
inline NearestOutcome nearest_leaf(const Octree& tree, const Point& from,
                                   std::uint8_t colours = solid_colours, std::uint64_t within = UINT64_MAX) {
    return nearest_leaf(tree, CellBox{from, from}, colours, within);
}

} // namespace osem

#endif
