#include "picture/camera.hpp"

#include <algorithm>
#include <cmath>

#include "files/decimal.hpp"

namespace osem::host {

namespace {

struct NamedView {
    const char* name;
    View view;
};

// 35.2643897 degrees is the elevation of a cube's diagonal, atan(1 / sqrt 2).
constexpr NamedView named_views[] = {{"iso", {-45, 35.2643897}}, {"front", {-90, 0}}, {"back", {90, 0}},
                                     {"left", {180, 0}},         {"right", {0, 0}},   {"top", {-90, 90}},
                                     {"bottom", {-90, -90}}};

struct Range {
    double low = 1e9;
    double high = -1e9;
    void include(double value, double reach) {
        low = std::min(low, value - reach);
        high = std::max(high, value + reach);
    }
    double middle() const { return (low + high) / 2; }
    double length() const { return high - low; }
};

// A cube reaches half its side times the sum of the components' sizes along a unit vector.
double reach_along(const Vector& unit) {
    return (std::abs(unit[0]) + std::abs(unit[1]) + std::abs(unit[2])) / 2;
}

void include(Range& across, Range& along, const Camera& camera, const Octant& octant) {
    const double side = std::ldexp(octant.side(), -lattice_bits);
    const Point& c = octant.corner;
    const Vector centre = {std::ldexp(c.x(), -lattice_bits) + side / 2,
                           std::ldexp(c.y(), -lattice_bits) + side / 2,
                           std::ldexp(c.z(), -lattice_bits) + side / 2};
    across.include(dot(centre, camera.right), side * reach_along(camera.right));
    along.include(dot(centre, camera.down), side * reach_along(camera.down));
}

} // namespace

std::optional<View> parse_view(std::string_view text) {
    for (const NamedView& named : named_views) {
        if (text == named.name) return named.view;
    }
    double angles[2];
    if (!parse_decimals(text, angles, 2) || std::abs(angles[1]) > 90) return std::nullopt;
    return View{angles[0], angles[1]};
}

Camera aim(const View& view, const Octree& tree, int samples) {
    constexpr double degree = 0.017453292519943295;
    const double ca = std::cos(view.azimuth * degree);
    const double sa = std::sin(view.azimuth * degree);
    const double ce = std::cos(view.elevation * degree);
    const double se = std::sin(view.elevation * degree);
    Camera camera = {};
    camera.right = {-sa, ca, 0};
    camera.down = {se * ca, se * sa, -ce};
    camera.forward = {-ce * ca, -ce * sa, -se};
    camera.samples = samples;

    Range across;
    Range along;
    LeafWalk walk(tree);
    for (Leaf leaf = {}; walk.next(leaf);) {
        if (leaf.colour != Colour::white) include(across, along, camera, leaf.octant);
    }
    if (across.length() < 0) include(across, along, camera, root_octant);

    constexpr double margin = 1.1;
    camera.step = margin * std::max(across.length(), along.length()) / samples;
    const double half = camera.step * (samples - 1) / 2;
    // Two sides before the root's centre: behind every ray's start there is nothing of the root.
    const double depth = dot({0.5, 0.5, 0.5}, camera.forward) - 2;
    camera.start = ((across.middle() - half) * camera.right + (along.middle() - half) * camera.down) +
                   depth * camera.forward;
    return camera;
}

} // namespace osem::host
