// There is no integer in an empty range.
#include "osem/bounded.hpp"

auto least() { return osem::Bounded<1, 0>::claim(0); }
