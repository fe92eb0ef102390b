// A wider range does not fit in a narrower one.
#include "osem/bounded.hpp"

osem::Bounded<0, 5> narrowed(osem::Bounded<0, 6> wide) { return wide; }
