// The sum of these ranges may leave 64 bits.
#include "osem/bounded.hpp"

using Widest = osem::Bounded<0, INT64_MAX>;
auto sum(Widest a, osem::Bounded<0, 1> b) { return a + b; }
