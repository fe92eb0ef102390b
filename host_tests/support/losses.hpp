// The least that a tree loses when it is coarsened to a number of nodes, by dynamic programming over all ways
// to prune it.
#ifndef OSEM_SUPPORT_LOSSES_HPP
#define OSEM_SUPPORT_LOSSES_HPP

#include <cstdint>
#include <vector>

#include "support/dense_grid.hpp"

namespace osem::tests {

/// The least number of known cells that a part of a tree loses with at most n nodes, at index n.
using Losses = std::vector<std::uint64_t>;

/// In cells of side 1, the top node not counted; as many entries as the tree has nodes, the last one 0.
Losses least_losses(const DenseGrid& grid);

} // namespace osem::tests

#endif
