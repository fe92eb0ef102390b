// Moments, surface and Euler characteristic.
#include "features/roots.hpp"

#include "osem/measure.hpp"

extern "C" {
auto measures_roots = roots_of(&osem::moments, &osem::measure_surface);
}
