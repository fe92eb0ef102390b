// Conversion by grids on several threads.
#ifndef OSEM_HOST_OCTANTS_APART_HPP
#define OSEM_HOST_OCTANTS_APART_HPP

#include "commands/conversion.hpp"

namespace osem::host {

/// The eight children of the root are converted apart, each by one thread of so many, and joined: the tree is
/// the one that a single thread makes, node for node at the same places of the pool. Precondition: the depth
/// is greater than 1.
Converted convert_octants_apart(const CheckedSolid& solid, const ConvertOptions& options, unsigned threads,
                                Progress& progress);

} // namespace osem::host

#endif
