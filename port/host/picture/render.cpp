#include "picture/render.hpp"

#include "picture/cast.hpp"
#include "picture/shade.hpp"
#include "picture/surface.hpp"

namespace osem::host {

Image render(const Subject& subject, const std::vector<Subject>& together, const View& view, int size,
             const Look& look, Progress& progress) {
    const bool drawn = look.style == Style::wireframe;
    const int per_pixel = drawn && size <= 2048 ? 3 : 2;
    const Camera camera = aim(view, together, per_pixel * size);
    const Samples samples =
        std::visit([&](const auto* shown) { return cast(*shown, camera, progress); }, subject);
    if (drawn) return draw_lines(samples, look.lines, per_pixel);
    if (look.style == Style::faces) return shade(samples, samples.slope, true);
    return shade(samples, surface_slopes(samples), false);
}

} // namespace osem::host
