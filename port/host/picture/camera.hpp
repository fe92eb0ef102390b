// Where the picture is taken from.
#ifndef OSEM_HOST_CAMERA_HPP
#define OSEM_HOST_CAMERA_HPP

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/quantize.hpp"
#include "osem/octree.hpp"
#include "osem/ray.hpp"
#include "picture/samples.hpp"
#include "picture/vector.hpp"

namespace osem::host {

/// Where the viewer stands, in degrees: azimuth from the x axis towards the y axis, elevation from the xy
/// plane towards the z axis.
struct View {
    double azimuth;
    double elevation;
};

struct NamedView {
    std::string name; ///< as it was asked for
    View view;
};

/// Views with commas between them, each by name (iso, front, back, left, right, top, bottom) or as
/// "azimuth,elevation" with an elevation from -90 to 90; none when one of them is neither.
std::optional<std::vector<NamedView>> parse_views(std::string_view text);

/// What is drawn; it is only viewed.
using Subject = std::variant<const Octree*, const IntegerSolid*>;

/// An orthographic camera over a square grid of samples. Depth, like every length in the picture, counts in
/// samples, so that slopes are plain numbers.
struct Camera {
    Vector right;   ///< unit vectors of the picture: columns grow to the right,
    Vector down;    ///< rows grow downwards,
    Vector forward; ///< depth grows away from the viewer
    Vector start;   ///< the centre of sample (0, 0), in front of the root
    double step;    ///< distance between samples
    int samples;    ///< a side

    /// The ray through a sample. Its start is rounded to a lattice point; all rays have one direction, so
    /// they are parallel, and end behind the root.
    Segment segment(int column, int row) const;
    /// From the start of a ray to its end, four root sides, rounded to lattice units.
    Point direction() const;
    /// In root sides.
    double ray_length() const;
    /// Column and row at which a lattice point is seen.
    std::pair<double, double> place_of(const Point& point) const;
    /// The slope of a plane with the given normal, limited where it is seen edge on.
    Slope slope_of(const Vector& normal) const;
};

/// Points the camera at what the subjects hold together, with a margin; at the whole root when they hold
/// nothing.
Camera aim(const View& view, const std::vector<Subject>& subjects, int samples);

} // namespace osem::host

#endif
