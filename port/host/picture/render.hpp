// An octree as a shaded picture.
#ifndef OSEM_HOST_RENDER_HPP
#define OSEM_HOST_RENDER_HPP

#include "console/progress.hpp"
#include "osem/octree.hpp"
#include "picture/camera.hpp"
#include "picture/image.hpp"

namespace osem::host {

/// Renders a square picture of `size` pixels a side, four rays a pixel. Boundary leaves are steel blue, black
/// ones warm grey. Memory: about 130 bytes a pixel.
Image render(const Octree& tree, const View& view, int size, Progress& progress);

} // namespace osem::host

#endif
