// A plane of an octree as a picture.
#ifndef OSEM_HOST_SLICE_HPP
#define OSEM_HOST_SLICE_HPP

#include <cstdint>

#include "osem/octree.hpp"
#include "picture/image.hpp"

namespace osem::host {

constexpr int slice_most_pixels = 2048;
constexpr int slice_least_pixels = 256;

/// The layer of cells [cell, cell + 1) along `axis`: white, black and boundary (steel blue) leaves, a pixel a
/// leaf at the tree's depth. Where that is more than slice_most_pixels a pixel is the mean of its cells;
/// where it is less than slice_least_pixels a leaf is a square of a whole number of pixels. Axis x shows y to
/// the right and z upwards, axis y x and z, axis z x and y.
Image slice(const Octree& tree, Axis axis, std::int32_t cell);

} // namespace osem::host

#endif
