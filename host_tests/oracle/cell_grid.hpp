// The exact truth about every cell of a window, and the comparison of a tree's leaves with it.
#ifndef OSEM_ORACLE_CELL_GRID_HPP
#define OSEM_ORACLE_CELL_GRID_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "exact_solid.hpp"
#include "osem/boolean.hpp"
#include "osem/convert.hpp"
#include "osem/octree.hpp"

namespace oracle {

/// What is true of one cell at full depth.
struct Cell {
    bool met = false; ///< the surface shares a point with the open cell
    int winding = 0;  ///< around the centre: moved by (e, e^2, e^3) when met
};

/// All cells of one depth in a window octant. The window is divided by eight only while the surface meets the
/// open octant: where it does not, one winding number holds throughout, for the octant is connected.
class CellGrid {
  public:
    CellGrid(const ExactSolid& solid, const osem::Octant& window, int depth);

    const osem::Octant& window() const { return window_; }
    int depth() const { return depth_; }
    std::size_t size() const { return cells_.size(); }
    const Cell& operator[](std::size_t index) const { return cells_[index]; }

  private:
    void fill(const ExactSolid& solid, const osem::Octant& octant);

    osem::Octant window_;
    int depth_;
    std::vector<Cell> cells_;
};

/// The colour that a cell must have.
osem::Colour colour_of(const Cell& cell, osem::LeafRule leaves, osem::WindingRule winding);

/// Kleene's three-valued logic on the colours of cells.
osem::Colour combined(osem::Operator op, osem::Colour a, osem::Colour b);

struct Report {
    std::uint64_t leaves = 0;
    std::uint64_t cells = 0; ///< cells compared, each in its leaf
    std::uint64_t wrong_leaves = 0;
    std::string first; ///< the first wrong leaf in words, or what else is wrong
    bool good() const { return first.empty(); }
};

using CellColour = std::function<osem::Colour(std::size_t cell)>;

/// Compares every leaf of a tree with the expected colours of all of its cells: inside the window those of
/// `expected`, outside of it white. Also: the leaves tile the root, and none is smaller than `depth` allows.
Report compare(const osem::Octree& tree, const osem::Octant& window, int depth, const CellColour& expected);

/// compare, for the tree of one converted solid.
Report compare(const osem::Octree& tree, const CellGrid& grid, const osem::ConvertOptions& options);

const char* name_of(osem::Colour colour);
const char* name_of(osem::LeafRule rule);
const char* name_of(osem::WindingRule rule);
const char* name_of(osem::Operator op);
std::string in_words(const osem::Octant& octant);

} // namespace oracle

#endif
