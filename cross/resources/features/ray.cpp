// Segments and rays.
#include "features/roots.hpp"

#include "osem/ray.hpp"

extern "C" {
auto ray_roots = roots_of(&osem::ray, &osem::first_hit);
}
