// A plane value has no room left for another factor.
#include "osem/lattice.hpp"

auto cubed(osem::PlaneValue value, osem::VertexDifference d) { return value * d; }
