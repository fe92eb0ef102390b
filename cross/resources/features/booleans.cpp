// Booleans on trees in a pool.
#include "features/roots.hpp"

#include "osem/boolean.hpp"

extern "C" {
auto booleans_roots =
    roots_of(&osem::Combination::begin, &osem::Combination::step, &osem::Combination::finish);
}
