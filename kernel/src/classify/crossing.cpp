#include "classify/crossing.hpp"

#include "geometry/plane.hpp"
#include "geometry/sight.hpp"

namespace osem {

namespace {

// The side of a plane on which q moved by (e, e^2, e^3) lies: the first of the value and the three
// derivatives that is not 0. Precondition: the normal is not null.
int side_of_reference(const Plane& plane, const Point& q) {
    int side = plane.at(q).sign();
    for (int axis = 0; side == 0; ++axis) side = plane.normal(axis).sign();
    return side;
}

} // namespace

std::int32_t crossing(const Solid& solid, std::uint32_t face, const Point& from, Axis axis,
                      std::int32_t length) {
    // Seen along the axis the path is a point, and the face lies across the path's line as often as its rings
    // wind around it.
    const std::int32_t winding =
        winding_of_rings(solid, solid.first_ring(face), solid.end_ring(face), Sight(from, axis));
    if (winding == 0) return 0;

    const Plane plane(solid, face); // not null: rings on a line wind around nothing
    Point to = from;
    to.at[axis] += length;
    if (side_of_reference(plane, from) == side_of_reference(plane, to)) return 0;
    // Leaving through a face seen counter-clockwise from ahead lowers the number. (x, z) is left-handed as
    // seen along y.
    return axis == axis_y ? winding : -winding;
}

} // namespace osem
