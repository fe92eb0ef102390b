// An integer without a range has to be claimed.
#include "osem/bounded.hpp"

osem::Bounded<0, 5> bounded(int value) { return value; }
