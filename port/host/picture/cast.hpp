// Rays from the camera to the first face they meet. A ray is rounded once, to a segment between lattice
// points; what it meets is then decided in integers.
#ifndef OSEM_HOST_CAST_HPP
#define OSEM_HOST_CAST_HPP

#include "console/progress.hpp"
#include "mesh/quantize.hpp"
#include "osem/octree.hpp"
#include "picture/camera.hpp"
#include "picture/samples.hpp"

namespace osem::host {

/// The leaves that the camera's rays meet first, by the kernel's walk along segments.
Samples cast(const Octree& tree, const Camera& camera, Progress& progress);

/// The faces of a checked solid that the camera's rays meet first. Which faces a ray meets is decided by the
/// signs of determinants, which of them is first by comparing fractions, all in 128 bits; a ray through an
/// edge belongs to one of the faces beside it. Only the faces whose outline surrounds a ray are asked, so the
/// cost is that of the pixels they cover.
Samples cast(const IntegerSolid& solid, const Camera& camera, Progress& progress);

} // namespace osem::host

#endif
