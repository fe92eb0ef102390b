// From samples to colours.
#ifndef OSEM_HOST_SHADE_HPP
#define OSEM_HOST_SHADE_HPP

#include <vector>

#include "picture/image.hpp"
#include "picture/samples.hpp"
#include "picture/surface.hpp"

namespace osem::host {

/// Shades samples and averages each 2 by 2 of them into a pixel; with `steps` their rims have faint lines.
Image shade(const Samples& samples, const std::vector<Slope>& slopes, bool steps);

} // namespace osem::host

#endif
