// The product of these ranges may leave 64 bits.
#include "osem/bounded.hpp"

using Wide = osem::Bounded<0, (std::int64_t{1} << 32)>;
auto product(Wide a, Wide b) { return a * b; }
