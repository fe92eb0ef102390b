// Conversion of a solid that was checked before it was put into flash.
#include "features/roots.hpp"

#include "osem/convert.hpp"

extern "C" {
auto conversion_roots =
    roots_of(&osem::Conversion::begin, &osem::Conversion::step, &osem::Conversion::finish);
}
