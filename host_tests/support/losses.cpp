#include "support/losses.hpp"

#include <algorithm>

namespace osem::tests {

namespace {

Losses both(const Losses& a, const Losses& b) {
    Losses sum(a.size() + b.size() - 1, UINT64_MAX);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) sum[i + j] = std::min(sum[i + j], a[i] + b[j]);
    }
    return sum;
}

// Of the octant that holds `count` cells from `first`, when its own node is kept for nothing.
Losses least_below(const DenseGrid& grid, std::size_t first, std::size_t count) {
    Losses losses = {0};
    for (std::size_t k = 0; k < 8; ++k) {
        const std::size_t part = count / 8;
        const std::size_t at = first + k * part;
        if (grid.uniform_colour(at, part)) continue;
        Losses child = least_below(grid, at, part);
        std::uint64_t known = 0;
        for (std::size_t cell = at; cell < at + part; ++cell) {
            known += grid[cell] != Colour::boundary ? 1U : 0U;
        }
        child.insert(child.begin(), known);
        losses = both(losses, child);
    }
    return losses;
}

} // namespace

Losses least_losses(const DenseGrid& grid) {
    Losses losses = {0};
    if (!grid.uniform_colour(0, grid.size())) losses = least_below(grid, 0, grid.size());
    for (std::size_t n = 1; n < losses.size(); ++n) losses[n] = std::min(losses[n], losses[n - 1]);
    for (std::uint64_t& loss : losses) loss *= volume_at(grid.depth());
    return losses;
}

} // namespace osem::tests
