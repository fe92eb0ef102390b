// Slices by looking at the cells of a grid one by one.
#ifndef OSEM_SUPPORT_SLICES_HPP
#define OSEM_SUPPORT_SLICES_HPP

#include <cstdint>
#include <vector>

#include "osem/slice.hpp"
#include "support/dense_grid.hpp"

namespace osem::tests {

using Row = std::vector<Colour>; ///< of pixels
using Rows = std::vector<Row>;

/// The axes of the rows and across them, as the header states them.
constexpr int slice_along[3] = {1, 0, 0};
constexpr int slice_across[3] = {2, 2, 1};

/// All pixels of a slice, in the layer of cells that holds it.
Rows expected_rows(const DenseGrid& grid, const Slice& slice);

/// The maximal runs of a row, by comparing each pixel with the one before it; white ones if wanted.
std::vector<PixelRun> runs_of(const Row& row, int number, bool white);

/// The bits of a row's bitmap.
std::vector<std::uint8_t> bits_of(const Row& row, bool inner);

} // namespace osem::tests

#endif
