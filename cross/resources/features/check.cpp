// Checking solids that come from elsewhere.
#include "features/roots.hpp"

#include "osem/solid.hpp"

extern "C" {
auto check_roots = roots_of(&osem::check);
}
