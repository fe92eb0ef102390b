// Broken solids and what check must say of them.
#ifndef OSEM_VECTORS_REFUSALS_HPP
#define OSEM_VECTORS_REFUSALS_HPP

#include "vector_file.hpp"

namespace vectors {

void add_refusals(VectorFile& file);

} // namespace vectors

#endif
