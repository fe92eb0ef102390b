// Steps of the reference point through, beside and along faces.
#include <CGAL/intersections.h>

#include <cmath>
#include <stdexcept>

#include "exact.hpp"
#include "exact_face.hpp"
#include "face_case.hpp"
#include "random.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using oracle::Exact;
using oracle::FacePieces;
using oracle::Point3;

constexpr unsigned faces = 13000;
constexpr int steps_a_face = 8;

struct Step {
    osem::Point from;
    osem::Axis axis;
    std::int32_t length;

    osem::Point to() const {
        osem::Point end = from;
        end.at[axis] += length;
        return end;
    }
    bool is_allowed() const { return length > 0 && is_query(from) && is_query(to()); }
};

// Moved by (e, e^2, e^3) with e = 2^-100, which does for an infinitesimal (see exact_solid.hpp).
Point3 moved(const osem::Point& p) {
    return {oracle::FT(p.x()) + oracle::FT(std::ldexp(1.0, -100)),
            oracle::FT(p.y()) + oracle::FT(std::ldexp(1.0, -200)),
            oracle::FT(p.z()) + oracle::FT(std::ldexp(1.0, -300))};
}

osem::Point middle(const osem::Point& a, const osem::Point& b) {
    osem::Point m = a;
    for (int axis = 0; axis < 3; ++axis) m.at[axis] += (b.at[axis] - a.at[axis]) / 2;
    return m;
}

// At a corner, in the middle of an edge, or on the way to a third corner, which often is inside the face; or
// beside that.
osem::Point random_target(Random& random, const oracle::Polygon& corners) {
    const int n = static_cast<int>(corners.size());
    const auto at = static_cast<std::size_t>(random.below(n));
    osem::Point target = corners[at];
    const int kind = random.below(4);
    if (kind > 0) target = middle(target, corners[(at + 1) % corners.size()]);
    if (kind > 1) target = middle(target, corners[static_cast<std::size_t>(random.below(n))]);
    if (random.below(3) == 0) target.at[random.below(3)] += random.between(-1, 1);
    return target;
}

// Off an octant corner, as conversions step; or so that it starts, ends or passes at a target.
Step random_step(Random& random, const oracle::FaceCase& near, const oracle::Polygon& corners) {
    const auto axis = static_cast<osem::Axis>(random.below(3));
    if (random.below(3) == 0) {
        const std::vector<osem::Octant> octants = near.octants();
        const osem::Octant& octant =
            octants[static_cast<std::size_t>(random.below(static_cast<int>(octants.size())))];
        Step step{octant.corner, axis, std::max(1, octant.side() >> random.below(2))};
        if (random.below(8) == 0) step = {{{-1, octant.corner.y(), octant.corner.z()}}, osem::axis_x, 1};
        return step;
    }
    osem::Point target = random_target(random, corners);
    const std::int32_t before = random.below(4) == 0 ? 0 : random.between(0, target.at[axis] + 1);
    const std::int32_t room = osem::root_side - target.at[axis];
    const std::int32_t after = random.below(4) == 0 || room <= 0 ? 0 : random.between(0, room);
    target.at[axis] -= before;
    return {target, axis, before + after};
}

bool strictly_through(const oracle::Triangle3& t, const Point3& p, const Point3& q) {
    const CGAL::Orientation sides[] = {CGAL::orientation(p, q, t[0], t[1]),
                                       CGAL::orientation(p, q, t[1], t[2]),
                                       CGAL::orientation(p, q, t[2], t[0])};
    if (sides[0] == sides[1] && sides[1] == sides[2] && sides[0] != CGAL::COPLANAR) return true;
    const auto has = [&](CGAL::Orientation side) {
        return sides[0] == side || sides[1] == side || sides[2] == side;
    };
    if (has(CGAL::POSITIVE) && has(CGAL::NEGATIVE)) return false;
    throw std::logic_error("a moved step through an edge");
}

// A solid's inside is behind its faces as these are seen counter-clockwise: who comes out in front of one
// leaves the solid once more.
int change_along(const FacePieces& face, const Step& step) {
    const Point3 p = moved(step.from);
    const Point3 q = moved(step.to());
    int change = 0;
    for (const oracle::WoundTriangle& t : face.triangles) {
        const CGAL::Orientation start = CGAL::orientation(t.shape[0], t.shape[1], t.shape[2], p);
        const CGAL::Orientation end = CGAL::orientation(t.shape[0], t.shape[1], t.shape[2], q);
        if (start == end || !strictly_through(t.shape, p, q)) continue;
        change += end == CGAL::POSITIVE ? -t.winding : t.winding;
    }
    return change;
}

// Before it is moved, the step touches an edge of the face, or the face's plane with one of its ends.
bool is_degenerate(const osem::Solid& face, const std::optional<Spanning>& plane, const Step& step) {
    if (!plane || volume(*plane, step.from) == 0 || volume(*plane, step.to()) == 0) return true;
    const oracle::Segment3 path(oracle::exact_point(step.from), oracle::exact_point(step.to()));
    for (std::uint32_t r = 0; r < face.ring_count(); ++r) {
        const osem::Ring ring = face.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const osem::Point& a = face.vertices[ring.corners[i]];
            const osem::Point& b = face.vertices[ring.corners[(i + 1) % ring.count]];
            if (CGAL::do_intersect(path, oracle::Segment3(oracle::exact_point(a), oracle::exact_point(b)))) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

void write_crossing(const std::string& folder) {
    VectorFile file(osem::cross::Topic::crossing);
    Random random(14);
    for (unsigned seed = 300001; seed < 300001 + faces; ++seed) {
        oracle::FaceCase near(seed);
        const oracle::TestSolid face = near.face();
        const osem::Solid view = face.view_with_tables();
        const FacePieces pieces = oracle::pieces_of(view, 0);
        const oracle::Polygon corners = corners_of(face);
        const std::optional<Spanning> plane = spanning(corners);
        Bytes body;
        body.solid(view);
        for (int i = 0; i < steps_a_face;) {
            const Step step = random_step(random, near, corners);
            if (!step.is_allowed()) continue;
            body.point(step.from);
            body.u8(step.axis);
            body.i32(step.length);
            body.i32(change_along(pieces, step));
            file.tally().count(is_degenerate(view, plane, step),
                               is_extreme(step.from) || is_extreme(step.to()));
            ++i;
        }
        file.add_record(std::move(body));
    }
    file.write(folder);
}

} // namespace vectors
