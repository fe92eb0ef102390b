// The surface of an octree's solid.
#include "features/roots.hpp"

#include "osem/boundary.hpp"

extern "C" {
auto boundary_roots =
    roots_of(&osem::Boundary::begin, &osem::Boundary::step, &osem::Boundary::finish, &osem::Boundary::emit);
}
