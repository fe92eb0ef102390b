// The surface that the leaves are samples of, estimated for shading.
#ifndef OSEM_HOST_SURFACE_HPP
#define OSEM_HOST_SURFACE_HPP

#include <vector>

#include "picture/camera.hpp"
#include "picture/samples.hpp"

namespace osem::host {

/// A plane in picture space: depth grows by `across` a column and by `along` a row.
struct Slope {
    float across;
    float along;
};

/// The slope of the surface at every sample (0, 0 where there is none). Leaves are steps of one leaf; a plane
/// is fitted to the depths around each sample, in the widest window that a plane fits within what steps
/// explain, so that edges stay edges. Where leaves are large in the picture their own faces are shown.
std::vector<Slope> surface_slopes(const Samples& samples, const Camera& camera);

} // namespace osem::host

#endif
