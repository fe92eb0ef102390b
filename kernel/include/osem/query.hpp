// What can be asked of a tree where it lies, in RAM or in flash. A firmware that only asks compiles
// src/query/query.cpp and no other source.
//
// A query goes down from the root, choosing children by comparing coordinates with the octants' middles;
// see Samet, "The Design and Analysis of Spatial Data Structures" (1990), on point and window queries.
#ifndef OSEM_QUERY_HPP
#define OSEM_QUERY_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"

namespace osem {

/// The bit of a colour in a set of colours.
constexpr std::uint8_t colour_bit(Colour colour) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(colour));
}

/// The colours of all that may be solid.
constexpr std::uint8_t solid_colours = colour_bit(Colour::black) | colour_bit(Colour::boundary);

/// Outcome of a point query.
struct PointOutcome {
    Status status;
    Leaf leaf;             ///< the leaf that holds the point's cell; when not ok the root octant, as boundary
    std::uint32_t visited; ///< nodes visited, at most the tree's depth
};

/// The leaf that holds the cell [x, x + 1) x [y, y + 1) x [z, z + 1). Status: ok; point_off_root when a
/// coordinate is outside [0, 2^20). Cost: O(depth) nodes.
PointOutcome leaf_at(const Octree& tree, const Point& cell);

/// A box of cells in lattice units: those from `low` on and below `high` along each axis.
struct CellBox {
    Point low;
    Point high;
};

/// Outcome of a box query.
struct BoxOutcome {
    Status status;
    std::uint8_t colours; ///< bit c is set when a cell of the box lies in a leaf of colour c; 0 when not ok
    /// No cell of the box is black or boundary, yet the closed box has a point in common with a closed black
    /// or boundary leaf: they share a face, an edge or a corner, or a part of one.
    bool touches;
    std::uint32_t visited; ///< nodes visited

    /// Whether a cell of the box has the colour. Grey is the colour of no cell.
    constexpr bool holds(Colour colour) const { return (colours & colour_bit(colour)) != 0; }
    /// Whether all cells of the box have the colour.
    constexpr bool all(Colour colour) const { return colours == colour_bit(colour); }
    /// Whether the box holds cells of more than one colour.
    constexpr bool mixed() const { return (colours & (colours - 1U)) != 0; }
    /// Whether the box keeps clear of all that may be solid: it is white throughout and touches nothing.
    constexpr bool clear() const { return all(Colour::white) && !touches; }
};

/// Which colours a box of cells holds and whether it touches the solid; exact, for boxes of any size. In a
/// tree of conservative leaves all(white) says that the box's interior is outside the solid, all(black) that
/// the box is inside it.
///
/// Status: ok; point_off_root when a bound is outside [0, 2^20] (such a box is refused, not clipped);
/// box_empty when low >= high along an axis. Cost: O(nodes visited), which are at most those whose octant has
/// a cell in the box grown by one cell on each side; the walk ends as soon as the answer cannot change.
/// Stack: one pointer and one byte a level.
BoxOutcome colours_in(const Octree& tree, const CellBox& box);

} // namespace osem

#endif
