// Where the picture is taken from.
#ifndef OSEM_HOST_CAMERA_HPP
#define OSEM_HOST_CAMERA_HPP

#include <optional>
#include <string_view>

#include "osem/octree.hpp"
#include "picture/vector.hpp"

namespace osem::host {

/// Where the viewer stands, in degrees: azimuth from the x axis towards the y axis, elevation from the xy
/// plane towards the z axis.
struct View {
    double azimuth;
    double elevation;
};

/// A view by name (iso, front, back, left, right, top, bottom) or as "azimuth,elevation" with an elevation
/// from -90 to 90; none when it is neither.
std::optional<View> parse_view(std::string_view text);

/// An orthographic camera over a square grid of samples. Depth, like every length in the picture, counts in
/// samples, so that slopes are plain numbers.
struct Camera {
    Vector right;   ///< unit vectors of the picture: columns grow to the right,
    Vector down;    ///< rows grow downwards,
    Vector forward; ///< depth grows away from the viewer
    Vector start;   ///< the centre of sample (0, 0), in front of the root
    double step;    ///< distance between samples
    int samples;    ///< a side

    Vector origin(int column, int row) const { return start + (column * step * right + row * step * down); }
};

/// Points the camera at what the tree holds, with a margin; at the whole root when it holds nothing.
Camera aim(const View& view, const Octree& tree, int samples);

} // namespace osem::host

#endif
