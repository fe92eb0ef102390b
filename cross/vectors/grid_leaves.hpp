// The leaves of a grid of cells, as a record holds them.
#ifndef OSEM_VECTORS_GRID_LEAVES_HPP
#define OSEM_VECTORS_GRID_LEAVES_HPP

#include <vector>

#include "bytes.hpp"
#include "format.hpp"
#include "support/dense_grid.hpp"

namespace vectors {

inline void collect_leaves(const osem::tests::DenseGrid& grid, std::size_t first, std::size_t cells,
                           int level, std::vector<std::uint8_t>& leaves) {
    if (const auto colour = grid.uniform_colour(first, cells)) {
        leaves.push_back(osem::cross::encoded(level, *colour));
        return;
    }
    for (std::size_t k = 0; k < 8; ++k) {
        collect_leaves(grid, first + k * (cells / 8), cells / 8, level + 1, leaves);
    }
}

/// u8 depth, u32 leaves, the leaves in Morton order.
inline void put_grid(Bytes& body, const osem::tests::DenseGrid& grid) {
    std::vector<std::uint8_t> leaves;
    collect_leaves(grid, 0, grid.size(), 0, leaves);
    body.u8(static_cast<std::uint64_t>(grid.depth()));
    body.u32(leaves.size());
    for (const std::uint8_t leaf : leaves) body.u8(leaf);
}

} // namespace vectors

#endif
