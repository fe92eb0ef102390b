#include "mesh/shell_test.hpp"

#include "mesh/flat.hpp"

namespace osem::host {

namespace {

int sign_of(std::int64_t value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

// The first that is not 0.
int leading_sign(std::int64_t value, const Normal& ties) {
    for (std::size_t axis = 0; value == 0 && axis < 3; ++axis) value = ties[axis];
    return sign_of(value);
}

bool on_segment(const Point& a, const Point& b, const Point& p) {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        const FlatPoint from{a.at[u], a.at[v]};
        const FlatPoint to{b.at[u], b.at[v]};
        const FlatPoint at{p.at[u], p.at[v]};
        if (orient(from, to, at) != 0 || !in_box(from, to, at)) return false;
    }
    return true;
}

bool lies_on_an_edge(const Solid& solid, std::uint32_t face, const Point& p) {
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        std::uint32_t from = ring.corners[ring.count - 1];
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            if (on_segment(solid.vertices[from], solid.vertices[ring.corners[i]], p)) return true;
            from = ring.corners[i];
        }
    }
    return false;
}

// In the projection along x, where the ray is a point: whether the edge runs above it in z, p being moved by
// (e^2, e^3) in y and z.
bool edge_is_above(const Point& from, const Point& to, const Point& p) {
    const FlatPoint a{from.y(), from.z()};
    const FlatPoint b{to.y(), to.z()};
    const FlatPoint q{p.y(), p.z()};
    if ((a.u <= q.u) == (b.u <= q.u)) return false;
    std::int64_t turn = orient(a, b, q);
    // Moving q by (e^2, e^3) adds e^3 (b.u - a.u) - e^2 (b.v - a.v).
    if (turn == 0) turn = std::int64_t{a.v} - b.v;
    if (turn == 0) turn = std::int64_t{b.u} - a.u;
    return b.u > a.u ? turn < 0 : turn > 0;
}

} // namespace

bool lies_on(const Solid& solid, std::uint32_t face, const Point& p) {
    const FacePlane plane(solid, face);
    if (plane.is_null()) return lies_on_an_edge(solid, face, p);
    if (plane.at(p) != 0) return false;
    const Projection project(plane.normal());
    bool inside = false;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        std::vector<FlatPoint> polygon;
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            polygon.push_back(project(solid.vertices[ring.corners[i]]));
        }
        const Side side = side_of(polygon, project(p));
        if (side == Side::on) return true;
        if (side == Side::inside) inside = !inside;
    }
    return inside;
}

bool ray_crosses(const Solid& solid, std::uint32_t face, const Point& p) {
    const FacePlane plane(solid, face);
    const int along = sign_of(plane.normal()[0]);
    if (along == 0 || leading_sign(plane.at(p), plane.normal()) == along) return false; // beside or behind
    bool inside = false;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const Ring ring = solid.ring(r);
        std::uint32_t from = ring.corners[ring.count - 1];
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            if (edge_is_above(solid.vertices[from], solid.vertices[ring.corners[i]], p)) inside = !inside;
            from = ring.corners[i];
        }
    }
    return inside;
}

} // namespace osem::host
