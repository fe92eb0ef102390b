// The surface that the leaves are samples of, estimated for shading.
#ifndef OSEM_HOST_SURFACE_HPP
#define OSEM_HOST_SURFACE_HPP

#include <vector>

#include "picture/samples.hpp"

namespace osem::host {

/// The slope of the surface at every sample (0, 0 where there is none). Leaves are steps of one leaf; a plane
/// is fitted to the depths around each sample, in the widest window that a plane fits within what steps
/// explain, so that edges stay edges. Where leaves are large in the picture their own faces are shown.
std::vector<Slope> surface_slopes(const Samples& samples);

} // namespace osem::host

#endif
