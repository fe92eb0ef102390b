// The difference of these ranges may leave 64 bits.
#include "osem/bounded.hpp"

using Widest = osem::Bounded<INT64_MIN, 0>;
auto difference(Widest a, osem::Bounded<0, 1> b) { return a - b; }
