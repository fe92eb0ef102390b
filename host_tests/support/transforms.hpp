// What the transforms of trees have to give: cells of dense grids moved, counted and looked up one by one.
#ifndef OSEM_SUPPORT_TRANSFORMS_HPP
#define OSEM_SUPPORT_TRANSFORMS_HPP

#include <cstdint>
#include <random>

#include "osem/transform.hpp"
#include "support/dense_grid.hpp"

namespace osem::tests {

constexpr CellBox whole_root = {Point{{0, 0, 0}}, Point{{root_side, root_side, root_side}}};

Point minus(const Point& a, const Point& b);
Point plus(const Point& a, const Point& b);
bool holds(const CellBox& box, const Point& cell);

/// The placed grid at a depth at which it is exact.
DenseGrid placed(const DenseGrid& grid, const Placement& placement, int depth);
/// The smallest depth, the grid's or a greater one, whose cells the vector and the box have as steps.
int exact_depth(const DenseGrid& grid, const Placement& placement);
/// Whether a cell that is not white is moved out of the root.
bool leaves_root(const DenseGrid& grid, const Point& by);

/// Every cell at the place of its image.
DenseGrid reoriented(const DenseGrid& grid, const Symmetry& symmetry);

/// By the numbers of an octant's white, black and boundary cells.
DenseGrid coarse(const DenseGrid& grid, int depth, Coarse mode);

DenseGrid enlarged_grid(const DenseGrid& grid, const Octant& octant);
DenseGrid reduced_grid(const DenseGrid& grid, const Octant& octant);

/// Vectors and boxes in steps of root_side / 2^bits; a vector has at most so many of them along an axis.
Point random_vector(std::mt19937& random, int bits, std::int32_t most);
CellBox random_box(std::mt19937& random, int bits);

} // namespace osem::tests

#endif
