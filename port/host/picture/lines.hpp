// Samples as a line drawing, hidden lines removed.
#ifndef OSEM_HOST_LINES_HPP
#define OSEM_HOST_LINES_HPP

#include "picture/image.hpp"
#include "picture/samples.hpp"

namespace osem::host {

/// Which lines are drawn: around every visible face, or only where the surface bends or ends in front of
/// another.
enum class Lines { leaves, outline };

/// Black lines on white, a pixel wide, between samples that met different faces: what is hidden was not met,
/// so it is not drawn. `per_pixel` samples a side are averaged into a pixel.
Image draw_lines(const Samples& samples, Lines lines, int per_pixel);

} // namespace osem::host

#endif
