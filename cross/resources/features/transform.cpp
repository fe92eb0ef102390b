// Trees moved, turned, scaled, cut and made coarser.
#include "features/roots.hpp"

#include "osem/transform.hpp"

extern "C" {
auto transform_roots =
    roots_of(&osem::translate, &osem::crop, &osem::reorient, &osem::coarsen, &osem::enlarged, &osem::reduced);
}
