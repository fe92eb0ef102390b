// Slices as runs and as bitmaps.
#include "features/roots.hpp"

#include "osem/slice.hpp"

extern "C" {
auto slice_roots =
    roots_of(&osem::RunSlicing::begin, &osem::RunSlicing::step, &osem::RunSlicing::finish,
             &osem::BitmapSlicing::begin, &osem::BitmapSlicing::step, &osem::BitmapSlicing::finish);
}
