#include "picture/render.hpp"

#include <cmath>

#include "picture/ray_walk.hpp"
#include "picture/samples.hpp"
#include "picture/shade.hpp"
#include "picture/surface.hpp"

namespace osem::host {

namespace {

Samples cast_rays(const Octree& tree, const Camera& camera, Progress& progress) {
    Samples samples(camera.samples, static_cast<float>(std::ldexp(1 / camera.step, -tree.depth)));
    const RayWalk rays(tree, camera.forward);
    for (int row = 0; row < samples.side; ++row) {
        for (int column = 0; column < samples.side; ++column) {
            Hit hit = {};
            if (!rays.cast(camera.origin(column, row), hit)) continue;
            const std::size_t i = samples.index(column, row);
            samples.depth[i] = static_cast<float>(hit.distance / camera.step);
            samples.axis[i] = static_cast<std::uint8_t>(hit.axis);
            samples.black[i] = hit.colour == Colour::black ? 1 : 0;
        }
        progress.show(static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(samples.side));
    }
    return samples;
}

} // namespace

Image render(const Octree& tree, const View& view, int size, Progress& progress) {
    const Camera camera = aim(view, tree, 2 * size);
    const Samples samples = cast_rays(tree, camera, progress);
    return shade(samples, surface_slopes(samples, camera));
}

} // namespace osem::host
