#include "commands/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/flat.hpp"

namespace osem::host {

namespace {

// In lattice units.
double area_of(const Solid& solid, std::uint32_t face) {
    std::array<double, 3> doubled{};
    for (std::uint32_t ring = solid.first_ring(face); ring != solid.end_ring(face); ++ring) {
        const Normal normal = newell_normal(solid, ring);
        for (std::size_t axis = 0; axis < 3; ++axis) doubled[axis] += static_cast<double>(normal[axis]);
    }
    return std::sqrt(doubled[0] * doubled[0] + doubled[1] * doubled[1] + doubled[2] * doubled[2]) / 2;
}

// Which child of the root a point lies in; one on its upper side may count in either.
std::size_t child_of_root(const Point& p) {
    std::size_t child = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (p.at[axis] >= root_octant.side() / 2) child |= std::size_t{1} << axis;
    }
    return child;
}

} // namespace

std::uint64_t Estimate::nodes() const {
    constexpr double most = 1 << 26;
    return static_cast<std::uint64_t>(std::min(leaves + faces + 1024, most));
}

std::array<Estimate, 8> estimate_children(const Solid& solid, int depth) {
    std::array<Estimate, 8> children;
    const double leaf_area = std::ldexp(1.0, 2 * (lattice_bits - depth));
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        const std::uint32_t first = solid.corners[solid.first_corner(solid.first_ring(face))];
        Estimate& child = children[child_of_root(solid.vertices[first])];
        child.leaves += area_of(solid, face) / leaf_area;
        child.faces += 1;
    }
    return children;
}

Estimate estimate(const Solid& solid, int depth) {
    Estimate sum;
    for (const Estimate& child : estimate_children(solid, depth)) sum.add(child);
    return sum;
}

} // namespace osem::host
