// A bounded integer gives up its range only by value().
#include "osem/bounded.hpp"

int plain(osem::Bounded<0, 5> bounded) { return bounded; }
