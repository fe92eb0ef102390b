// A model of octrees that knows nothing of nodes: a colour for each of the 8^depth cells.
#ifndef OSEM_SUPPORT_DENSE_GRID_HPP
#define OSEM_SUPPORT_DENSE_GRID_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "osem/boolean.hpp"
#include "osem/octree.hpp"
#include "osem/tree_builder.hpp"

namespace osem::tests {

/// Cells in Morton order: those of an octant are a range, those of its children the eighths of the range.
class DenseGrid {
  public:
    explicit DenseGrid(int depth, Colour fill = Colour::white)
        : depth_(depth), cells_(std::size_t{1} << (3 * depth), fill) {}

    int depth() const { return depth_; }
    std::size_t size() const { return cells_.size(); }
    std::int32_t cell_side() const { return root_side >> depth_; }
    Colour operator[](std::size_t cell) const { return cells_[cell]; }
    Colour& operator[](std::size_t cell) { return cells_[cell]; }

    /// The minimum corner of a cell on the lattice.
    Point corner(std::size_t cell) const;

    /// The colour of the cell that holds a lattice point of the root.
    Colour at(const Point& point) const;

    /// The colour of `count` cells in a row, if it is one.
    std::optional<Colour> uniform_colour(std::size_t first, std::size_t count) const;

    /// Cells of side 1 in the cells of a colour.
    std::uint64_t volume(Colour colour) const;

    friend bool operator==(const DenseGrid& a, const DenseGrid& b) {
        return a.depth_ == b.depth_ && a.cells_ == b.cells_;
    }

  private:
    int depth_;
    std::vector<Colour> cells_;
};

/// A grid of a colour a cell, given the cell's minimum corner and side.
template <class ColourOfCell>
DenseGrid make_grid(int depth, const ColourOfCell& colour_of_cell) {
    DenseGrid grid(depth);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        grid[cell] = colour_of_cell(grid.corner(cell), grid.cell_side());
    }
    return grid;
}

extern const std::vector<Colour> two_colours;   ///< white and black
extern const std::vector<Colour> three_colours; ///< and boundary

/// A grid of random blocks of all sizes, the same for the same seed on every machine.
DenseGrid random_grid(int depth, std::uint32_t seed, const std::vector<Colour>& palette);

/// A random grid of depth 1 to 4 and of two or three colours, all chosen by the seed.
DenseGrid grid_of(std::uint32_t seed);

/// The same colours on smaller cells.
DenseGrid refined(const DenseGrid& grid, int depth);

/// Kleene's connectives cell by cell, on the truth values 0, 1/2 and 1.
Colour combine_colours(Operator op, Colour a, Colour b);
Colour complement_colour(Colour a);
DenseGrid combined(Operator op, const DenseGrid& a, const DenseGrid& b);
DenseGrid complemented(const DenseGrid& a);

/// The bytes may, must of the canonical tree's nodes in preorder.
using Masks = std::vector<std::pair<std::uint8_t, std::uint8_t>>;
Masks preorder_masks(const DenseGrid& grid);

/// FNV-1a, 64 bits, of those bytes: what the tree's digest has to be.
std::uint64_t expected_digest(const Masks& masks);
std::uint64_t expected_digest(const DenseGrid& grid);

/// Builds the tree of a grid, opening only the octants of more than one colour.
TreeOutcome plant(const DenseGrid& grid, NodePool* pool, bool count_only = false);
/// Builds it from all its cells, opening every octant, and leaves the folding to the builder.
TreeOutcome plant_by_cells(const DenseGrid& grid, NodePool* pool);

/// A planted tree that has to fit.
Octree planted(const DenseGrid& grid, NodePool& pool);

/// Reads a tree back by asking for the leaf of every cell.
DenseGrid expand(const Octree& tree, int depth);

} // namespace osem::tests

#endif
