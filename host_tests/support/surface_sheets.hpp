// Counts of the surface of cells as a 2-manifold, taken around each point of the lattice of cells.
#ifndef OSEM_SUPPORT_SURFACE_SHEETS_HPP
#define OSEM_SUPPORT_SURFACE_SHEETS_HPP

#include <cstdint>

#include "support/dense_grid.hpp"

namespace osem::tests {

/// Where four squares meet in an edge, the two of one cell belong together. So the squares around a point
/// form cycles: its sheets.
struct SheetCounts {
    std::int64_t euler = 0;     ///< sheets - edges (cut ones twice) + squares
    std::uint32_t vertices = 0; ///< sheets in which the surface bends along three edges or more
};

/// Of a grid of white and black cells; what lies outside is white.
SheetCounts count_sheets(const DenseGrid& solid);

} // namespace osem::tests

#endif
