// The tree that a solid has, octant by octant, from exact geometry alone.
#ifndef OSEM_FUZZ_EXACT_TREE_HPP
#define OSEM_FUZZ_EXACT_TREE_HPP

#include "osem/convert.hpp"
#include "support/dense_grid.hpp"
#include "support/exact.hpp"

namespace osem::fuzz {

/// The bytes of the tree's nodes in preorder. An octant that no face meets has one winding number throughout,
/// as it is connected: that of its centre.
tests::Masks exact_masks(const ExactSolid& solid, const ConvertOptions& options);

/// Whether a winding number is inside.
bool is_inside(WindingRule rule, int winding);

} // namespace osem::fuzz

#endif
