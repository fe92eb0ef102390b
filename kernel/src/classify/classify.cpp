#include "osem/classify.hpp"

#include "classify/box.hpp"
#include "geometry/plane.hpp"
#include "geometry/sight.hpp"

namespace osem {

namespace {

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
            strictly_inside = code == 0;
            if (strictly_inside) return; // which says all
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

// The diagonal of a box from the corner at which the plane's value is least to the one at which it is
// greatest.
struct Diagonal {
    Point from;
    Point to;

    Diagonal(const Plane& plane, const Box& box) : from(box.lo), to(box.hi) {
        for (int axis = 0; axis < 3; ++axis) {
            if (plane.normal(axis).sign() >= 0) continue;
            from.at[axis] = box.hi.at[axis];
            to.at[axis] = box.lo.at[axis];
        }
    }

    std::int32_t along(int axis) const { return to.at[axis] - from.at[axis]; }
};

bool plane_meets(const Plane& plane, const Diagonal& diagonal) {
    return plane.at(diagonal.from).sign() < 0 && plane.at(diagonal.to).sign() > 0;
}

// How far a point is ahead of the box's centre along an axis, doubled.
auto ahead_of_centre(const Point& p, const Box& box, int axis) {
    return difference(p, box.lo, axis) + difference(p, box.hi, axis);
}

// Does the line a -> b, seen along each axis, pass through the open rectangle of the box? It does when it
// passes the centre at less than the reach of the rectangle's corners; both sides are doubled, so that the
// centre is on the lattice, and carry the line's length.
bool line_meets_rectangles(const Point& a, const Point& b, const Box& box) {
    for (int u = 0; u < 3; ++u) {
        const int v = u == 2 ? 0 : u + 1;
        const auto du = difference(b, a, u);
        const auto dv = difference(b, a, v);
        const auto reach =
            difference(box.hi, box.lo, v) * magnitude(du) + difference(box.hi, box.lo, u) * magnitude(dv);
        if (reach.value() == 0) continue; // a null axis separates nothing
        const auto passes = du * ahead_of_centre(a, box, v) - dv * ahead_of_centre(a, box, u);
        if (magnitude(passes).value() >= reach.value()) return false;
    }
    return true;
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
            if ((a_code & b_code) == 0 && line_meets_rectangles(*a, *b, box)) return true;
            a = b;
            a_code = b_code;
        }
    }
    return false;
}

// How far the diagonal goes along an axis for a unit along z.
int lean(const Diagonal& diagonal, int axis) {
    const std::int32_t up = diagonal.along(axis_z);
    const std::int32_t way = (diagonal.along(axis) < 0) == (up < 0) ? 1 : -1;
    return diagonal.along(axis) == way * up ? way : 2 * way;
}

// Stages 4 and 5 once no edge meets the open octant: the section of plane and octant lies wholly on one side
// of every ring, so one point of it decides for all of them. The diagonal passes through the plane in the
// open octant, and what winds around the diagonal winds around that point.
Decision decide_by_section(const Solid& solid, std::uint32_t face, const Diagonal& diagonal) {
    const Sight sight(diagonal.from, axis_z, lean(diagonal, axis_x), lean(diagonal, axis_y));
    const std::uint32_t outer = solid.first_ring(face);
    const std::uint32_t end = solid.end_ring(face);
    const std::int32_t outer_winding = winding_of_rings(solid, outer, outer + 1, sight);
    const std::int32_t winding = outer_winding + winding_of_rings(solid, outer + 1, end, sight);
    const bool decided_by_outer = end == outer + 1 || (outer_winding == 0 && winding == 0);
    return Decision{decided_by_outer ? Stage::section : Stage::holes, winding != 0};
}

} // namespace

Decision classify(const CheckedSolid& checked, std::uint32_t face, const Octant& octant) {
    return classify_box(checked.view(), face, box_of(octant));
}

Decision classify_box(const Solid& solid, std::uint32_t face, const Box& box) {
    const std::uint32_t* first = solid.corners + solid.first_corner(solid.first_ring(face));
    const std::uint32_t* end = solid.corners + solid.first_corner(solid.end_ring(face));
    const CornerSurvey survey(solid, first, end, box);
    if (survey.common != 0) return {Stage::minimax, false};
    if (survey.strictly_inside) return {Stage::vertices, true}; // the plane passes through that corner

    const Plane plane(solid, first, end);
    const Diagonal diagonal(plane, box);
    const bool has_area = !plane.is_null();
    if (has_area && !plane_meets(plane, diagonal)) return {Stage::plane, false};

    // A triangle within the closed octant whose plane meets the open one has its inner points there. (A
    // longer ring may run back on itself and have none.)
    if (end - first == 3 && all_in_closed(solid, first, end, box)) return {Stage::vertices, true};

    if (any_edge_meets(solid, face, box)) return {Stage::section, true};
    if (!has_area) return {Stage::section, false};
    return decide_by_section(solid, face, diagonal);
}

} // namespace osem
