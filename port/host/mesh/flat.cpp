#include "mesh/flat.hpp"

namespace osem::host {

namespace {

Normal cross(const Point& origin, const Point& a, const Point& b) {
    Normal result{};
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        result[static_cast<std::size_t>(axis)] =
            std::int64_t{a.at[u] - origin.at[u]} * (b.at[v] - origin.at[v]) -
            std::int64_t{a.at[v] - origin.at[v]} * (b.at[u] - origin.at[u]);
    }
    return result;
}

} // namespace

Normal newell_normal(const Solid& solid, std::uint32_t r) {
    const Ring ring = solid.ring(r);
    const Point& origin = solid.vertices[ring.corners[0]];
    Normal sum{};
    for (std::uint32_t i = 1; i + 1 < ring.count; ++i) {
        const Normal part =
            cross(origin, solid.vertices[ring.corners[i]], solid.vertices[ring.corners[i + 1]]);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += part[axis];
    }
    return sum;
}

Projection::Projection(const Normal& normal) {
    int axis = 2;
    for (const int other : {1, 0}) {
        if (magnitude(normal[static_cast<std::size_t>(other)]) >
            magnitude(normal[static_cast<std::size_t>(axis)])) {
            axis = other;
        }
    }
    const bool up = normal[static_cast<std::size_t>(axis)] >= 0;
    u_ = (axis + (up ? 1 : 2)) % 3;
    v_ = (axis + (up ? 2 : 1)) % 3;
}

FacePlane::FacePlane(const Solid& solid, std::uint32_t face)
    : origin_(solid.vertices[solid.corners[solid.first_corner(solid.first_ring(face))]]) {
    const std::uint32_t* const end = solid.corners + solid.first_corner(solid.end_ring(face));
    const Point* second = nullptr;
    for (const std::uint32_t* corner = solid.corners + solid.first_corner(solid.first_ring(face));
         corner != end && is_null(); ++corner) {
        const Point& p = solid.vertices[*corner];
        if (second != nullptr) {
            normal_ = cross(origin_, *second, p);
        } else if (p != origin_) {
            second = &p;
        }
    }
}

std::int64_t FacePlane::at(const Point& p) const {
    return normal_[0] * (p.at[0] - origin_.at[0]) + normal_[1] * (p.at[1] - origin_.at[1]) +
           normal_[2] * (p.at[2] - origin_.at[2]);
}

bool is_planar(const Solid& solid, std::uint32_t face) {
    const std::uint32_t first = solid.first_corner(solid.first_ring(face));
    const std::uint32_t end = solid.first_corner(solid.end_ring(face));
    if (end - first == 3) return true;
    const FacePlane plane(solid, face);
    for (std::uint32_t corner = first; corner < end; ++corner) {
        if (plane.at(solid.vertices[solid.corners[corner]]) != 0) return false;
    }
    return true;
}

Side side_of(const std::vector<FlatPoint>& polygon, const FlatPoint& p) {
    bool inside = false;
    FlatPoint a = polygon.back();
    for (const FlatPoint& b : polygon) {
        const std::int64_t turn = orient(a, b, p);
        if (turn == 0 && in_box(a, b, p)) return Side::on;
        const bool up = a.v <= p.v && b.v > p.v;
        const bool down = b.v <= p.v && a.v > p.v;
        if ((up && turn > 0) || (down && turn < 0)) inside = !inside;
        a = b;
    }
    return inside ? Side::inside : Side::outside;
}

} // namespace osem::host
