#include <cmath>

#include "osem/ray.hpp"
#include "picture/cast.hpp"

namespace osem::host {

namespace {

// The plane of the face that a ray enters a leaf by: its axis and its place along it.
std::uint32_t plane_of(const Passage& passage, const Point& direction) {
    const unsigned axis = static_cast<unsigned>(passage.entered_axis);
    const Octant& octant = passage.leaf.octant;
    const std::int32_t far_side = direction.at[axis] < 0 ? octant.side() : 0;
    return static_cast<std::uint32_t>(octant.corner.at[axis] + far_side) << 2 | axis;
}

// Leaves are told apart by their corners, of 20 bits a coordinate; above them stands the axis, from 1.
std::uint64_t face_of(const Passage& passage) {
    const Point& c = passage.leaf.octant.corner;
    const auto bits = [](std::int32_t coordinate) { return static_cast<std::uint64_t>(coordinate); };
    return bits(c.x()) | bits(c.y()) << 20 | bits(c.z()) << 40 |
           (static_cast<std::uint64_t>(passage.entered_axis) + 1) << 60;
}

} // namespace

Samples cast(const Octree& tree, const Camera& camera, Progress& progress) {
    Samples samples(camera.samples, static_cast<float>(std::ldexp(1 / camera.step, -tree.depth)));
    const Slope slopes[3] = {camera.slope_of({1, 0, 0}), camera.slope_of({0, 1, 0}),
                             camera.slope_of({0, 0, 1})};
    const Point direction = camera.direction();
    const double length = camera.ray_length() / camera.step;
    for (int row = 0; row < samples.side; ++row) {
        for (int column = 0; column < samples.side; ++column) {
            const HitOutcome found = first_hit(tree, camera.segment(column, row));
            if (!found.hit) continue;
            const Passage& passage = found.passage;
            const std::size_t i = samples.index(column, row);
            samples.depth[i] =
                static_cast<float>(length * passage.entry.numerator / passage.entry.denominator);
            samples.slope[i] = slopes[static_cast<unsigned>(passage.entered_axis)];
            samples.face[i] = face_of(passage);
            samples.plane[i] = plane_of(passage, direction);
            samples.black[i] = passage.leaf.colour == Colour::black ? 1 : 0;
        }
        progress.show(static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(samples.side));
    }
    return samples;
}

} // namespace osem::host
