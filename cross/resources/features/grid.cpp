// Conversion by grids.
#include "features/roots.hpp"

#include "osem/grid_convert.hpp"

extern "C" {
auto grid_roots =
    roots_of(&osem::GridConversion::begin, &osem::GridConversion::step, &osem::GridConversion::finish);
}
