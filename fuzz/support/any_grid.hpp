// Grids out of choices.
#ifndef OSEM_FUZZ_ANY_GRID_HPP
#define OSEM_FUZZ_ANY_GRID_HPP

#include "support/choices.hpp"
#include "support/dense_grid.hpp"

namespace osem::fuzz {

/// A grid of blocks of all sizes, a byte a block.
tests::DenseGrid any_grid(int depth, Choices& choices);

/// A point of the root: often a corner of a cell of side root_side >> bits, or one off it.
Point any_cell(int bits, Choices& choices);

} // namespace osem::fuzz

#endif
