#include "osem/classify.hpp"

#include "geometry/projection.hpp"

namespace osem {

namespace {

struct Box {
    Point lo;
    Point hi;
    explicit Box(const Octant& octant) : lo(octant.corner), hi(octant.corner) {
        for (std::int32_t& coordinate : hi.at) coordinate += octant.side();
    }
};

// One bit for each side of the box that a point lies on or behind; 0 means strictly inside. A bit common to
// all points of a set says that their hull misses the open box.
unsigned outcode(const Point& p, const Box& box) {
    unsigned code = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (p.at[axis] <= box.lo.at[axis]) code |= 1U << (2 * axis);
        if (p.at[axis] >= box.hi.at[axis]) code |= 2U << (2 * axis);
    }
    return code;
}

// What one pass over a face's corners tells stages 1 and 3.
struct CornerSurvey {
    unsigned common = ~0U;        // outcode bits common to all corners
    bool strictly_inside = false; // some corner is in the open box

    CornerSurvey(const Solid& solid, const std::uint32_t* corner, const std::uint32_t* end, const Box& box) {
        for (; corner != end; ++corner) {
            const unsigned code = outcode(solid.vertices[*corner], box);
            common &= code;
            strictly_inside |= code == 0;
        }
    }
};

bool all_in_closed(const Solid& solid, const std::uint32_t* corner, const std::uint32_t* end,
                   const Box& box) {
    for (; corner != end; ++corner) {
        const Point& p = solid.vertices[*corner];
        for (int axis = 0; axis < 3; ++axis) {
            if (p.at[axis] < box.lo.at[axis] || p.at[axis] > box.hi.at[axis]) return false;
        }
    }
    return true;
}

// The box corner at which the plane's value is greatest (towards > 0) or least (towards < 0).
Point extreme_corner(const Plane& plane, const Box& box, int towards) {
    Point corner = box.lo;
    for (int axis = 0; axis < 3; ++axis) {
        if (plane.normal(axis).sign() == towards) corner.at[axis] = box.hi.at[axis];
    }
    return corner;
}

bool plane_meets(const Plane& plane, const Box& box) {
    return plane.at(extreme_corner(plane, box, -1)).value() < 0 &&
           plane.at(extreme_corner(plane, box, 1)).value() > 0;
}

// Does the line a -> b, seen along an axis, pass through the open square of the box? The orientation of a
// square's point grows with v where the line runs towards u, and with u where it runs against v.
bool line_meets_square(const Point& a, const Point& b, const Box& box, int along) {
    const Projection p(along);
    const int du = difference(b, a, p.u).sign();
    const int dv = difference(b, a, p.v).sign();
    if (du == 0 && dv == 0) return true; // a null axis separates nothing
    Point least = box.lo;
    Point greatest = box.lo;
    (du > 0 ? greatest : least).at[p.v] = box.hi.at[p.v];
    (dv < 0 ? greatest : least).at[p.u] = box.hi.at[p.u];
    return orientation(a, b, least, p).value() < 0 && orientation(a, b, greatest, p).value() > 0;
}

// Closed segment against open box by separating axes: the box's axes (the outcodes' common bits) and their
// cross products with the edge. They suffice, because the Minkowski difference of the two has no other face
// normals.
bool any_edge_meets(const Solid& solid, std::uint32_t face, const Box& box) {
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        const Point* a = &solid.vertices[ring.corners[ring.count - 1]];
        unsigned a_code = outcode(*a, box);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const Point* b = &solid.vertices[ring.corners[i]];
            const unsigned b_code = outcode(*b, box);
            if ((a_code & b_code) == 0 && line_meets_square(*a, *b, box, 0) &&
                line_meets_square(*a, *b, box, 1) && line_meets_square(*a, *b, box, 2)) {
                return true;
            }
            a = b;
            a_code = b_code;
        }
    }
    return false;
}

// A point of the section of plane and open box, as seen along the plane's dominant axis.
struct SectionPoint {
    Point corner;
    Nudge nudge;
};

// Seen along the dominant axis the slope is at most 1, so over one of the square's four corners the plane
// passes within the box's closed height: from the corner where it is lowest (below the top) to the one where
// it is highest (above the bottom) two steps along sides lead, each of which climbs at most one side. That
// corner belongs to the closure of the section; an infinitesimal move into the square, and off the top or
// bottom if the plane passes exactly there, takes it inside.
SectionPoint point_of_section(const Plane& plane, const Box& box, Axis dominant) {
    const Projection p(dominant);
    SectionPoint section = {box.lo, Nudge{1, 1, true}};
    for (unsigned k = 0; k < 4; ++k) {
        const bool high_u = (k & 1U) != 0;
        const bool high_v = (k & 2U) != 0;
        section.corner.at[p.u] = high_u ? box.hi.at[p.u] : box.lo.at[p.u];
        section.corner.at[p.v] = high_v ? box.hi.at[p.v] : box.lo.at[p.v];
        section.nudge = Nudge{high_u ? -1 : 1, high_v ? -1 : 1, true};
        Point top = section.corner;
        top.at[dominant] = box.hi.at[dominant];
        const int bottom_side = plane.at(section.corner).sign();
        const int top_side = plane.at(top).sign();
        if (bottom_side * top_side > 0) continue;
        // At a tie the leading move must give the end on the plane the side opposite to the other end.
        if (bottom_side == 0) section.nudge.u_leads = plane.normal(p.u).sign() * section.nudge.u == -top_side;
        if (top_side == 0) section.nudge.u_leads = plane.normal(p.u).sign() * section.nudge.u == -bottom_side;
        break;
    }
    return section;
}

// Stages 4 and 5 once no edge meets the open octant: the section lies wholly on one side of every ring, so
// one point of it decides for all of them.
Decision decide_by_section(const Solid& solid, std::uint32_t face, const Plane& plane, const Box& box) {
    const Axis dominant = plane.dominant_axis();
    const Projection projection(dominant);
    const SectionPoint point = point_of_section(plane, box, dominant);
    const std::uint32_t outer = solid.first_ring(face);
    const std::int32_t outer_winding =
        ring_winding(solid, solid.ring(outer), point.corner, projection, point.nudge);
    std::int32_t winding = outer_winding;
    for (std::uint32_t hole = outer + 1; hole < solid.end_ring(face); ++hole) {
        winding += ring_winding(solid, solid.ring(hole), point.corner, projection, point.nudge);
    }
    const bool decided_by_outer = solid.end_ring(face) == outer + 1 || (outer_winding == 0 && winding == 0);
    return Decision{decided_by_outer ? Stage::section : Stage::holes, winding != 0};
}

} // namespace

Decision classify(const CheckedSolid& checked, std::uint32_t face, const Octant& octant) {
    const Solid& solid = checked.view();
    const Box box(octant);
    const std::uint32_t* first = solid.corners + solid.first_corner(solid.first_ring(face));
    const std::uint32_t* end = solid.corners + solid.first_corner(solid.end_ring(face));
    const CornerSurvey survey(solid, first, end, box);
    if (survey.common != 0) return {Stage::minimax, false};

    const Plane plane(solid, face);
    const bool has_area = !plane.is_null();
    if (has_area && !plane_meets(plane, box)) return {Stage::plane, false};

    // A triangle within the closed octant whose plane meets the open one has its inner points there. (A
    // longer ring may run back on itself and have none.)
    if (survey.strictly_inside || (end - first == 3 && all_in_closed(solid, first, end, box))) {
        return {Stage::vertices, true};
    }

    if (any_edge_meets(solid, face, box)) return {Stage::section, true};
    if (!has_area) return {Stage::section, false};
    return decide_by_section(solid, face, plane, box);
}

} // namespace osem
