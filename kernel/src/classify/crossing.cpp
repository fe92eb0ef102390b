#include "classify/crossing.hpp"

#include "geometry/projection.hpp"

namespace osem {

namespace {

// The side of a plane on which q moved by (e, e^2, e^3) lies: the first of the value and the three
// derivatives that is not 0. Not 0 when the normal is not null.
int side_of_reference(const Plane& plane, const Point& q) {
    int side = plane.at(q).sign();
    for (int axis = 0; side == 0 && axis < 3; ++axis) side = plane.normal(axis).sign();
    return side;
}

} // namespace

std::int32_t crossing(const Solid& solid, std::uint32_t face, const Point& from, Axis axis,
                      std::int32_t length) {
    // Seen along the axis, the path is a point, moved most along the lower of the two axes left. The rings
    // wind around it as often as the face lies across the line of the path.
    const Projection projection(axis);
    std::int32_t winding = 0;
    for (std::uint32_t ring = solid.first_ring(face); ring < solid.end_ring(face); ++ring) {
        winding += ring_winding(solid, solid.ring(ring), from, projection, Nudge{1, 1, true});
    }
    if (winding == 0) return 0;

    const Plane plane(solid, face);
    Point to = from;
    to.at[axis] += length;
    if (side_of_reference(plane, from) == side_of_reference(plane, to)) return 0;
    // Leaving through a face seen counter-clockwise from ahead lowers the number. (x, z) is left-handed as
    // seen along y.
    return axis == axis_y ? winding : -winding;
}

} // namespace osem
