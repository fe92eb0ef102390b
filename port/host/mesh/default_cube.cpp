#include <algorithm>
#include <cmath>

#include "mesh/quantize.hpp"

namespace osem::host {

const char* const default_cube_rule =
    "the cube's side is the smallest power of two that is at least 17/16 of the solid's largest extent, and "
    "its centre is that of the solid's bounding box, with the origin rounded down to a multiple of side/1024";

namespace {

// As its name says; `value` is positive and finite.
double power_of_two_at_least(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent); // in [1/2, 1)
    return std::ldexp(1.0, fraction > 0.5 ? exponent : exponent - 1);
}

} // namespace

WorldCube default_cube(const Mesh& mesh) {
    if (mesh.corners.empty()) throw BadInput("the mesh has no faces");
    std::array<double, 3> low = mesh.vertices[mesh.corners[0]];
    std::array<double, 3> high = low;
    for (const std::uint32_t vertex : mesh.corners) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double coordinate = mesh.vertices[vertex][axis];
            if (!std::isfinite(coordinate)) throw BadInput("the mesh has a coordinate that is not finite");
            low[axis] = std::min(low[axis], coordinate);
            high[axis] = std::max(high[axis], coordinate);
        }
    }
    double extent = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) extent = std::max(extent, high[axis] - low[axis]);
    if (!(extent > 0)) throw BadInput("the mesh has no extent: all its corners are one point");

    WorldCube cube{};
    cube.side = power_of_two_at_least(extent * 1.0625);
    const double step = cube.side / 1024;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double centre = low[axis] + (high[axis] - low[axis]) / 2;
        cube.origin[axis] = std::floor((centre - cube.side / 2) / step) * step;
    }
    return cube;
}

} // namespace osem::host
