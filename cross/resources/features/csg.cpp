// Expressions over solids, trees and streams.
#include "features/roots.hpp"

#include "osem/csg.hpp"

extern "C" {
auto csg_roots =
    roots_of(&osem::CsgConversion::begin, &osem::CsgConversion::step, &osem::CsgConversion::finish);
}
