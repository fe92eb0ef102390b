// A slice of an octree as a picture.
#ifndef OSEM_HOST_SLICE_HPP
#define OSEM_HOST_SLICE_HPP

#include "osem/slice.hpp"
#include "picture/image.hpp"

namespace osem::host {

constexpr int slice_most_pixels = 2048;
constexpr int slice_least_pixels = 256;

/// The kernel's slice in white, black and steel blue (boundary), rows upwards. Where it has more than
/// slice_most_pixels a side a pixel of the picture is the mean of the slice's; where it has fewer than
/// slice_least_pixels one of the slice's is a square of a whole number of pixels. Precondition: the slice is
/// one of the tree.
Image draw_slice(const Octree& tree, const Slice& slice);

} // namespace osem::host

#endif
