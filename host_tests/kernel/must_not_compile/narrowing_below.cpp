// Nor does one that reaches further down.
#include "osem/bounded.hpp"

osem::Bounded<0, 5> narrowed(osem::Bounded<-1, 5> wide) { return wide; }
