#include "picture/camera.hpp"

#include <algorithm>
#include <cmath>

#include "files/decimal.hpp"

namespace osem::host {

namespace {

struct KnownView {
    const char* name;
    View view;
};

// 35.2643897 degrees is the elevation of a cube's diagonal, atan(1 / sqrt 2).
constexpr KnownView known_views[] = {{"iso", {-45, 35.2643897}}, {"front", {-90, 0}}, {"back", {90, 0}},
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

// A lattice point in root sides.
Vector unit_of(const Point& p) {
    return {std::ldexp(p.x(), -lattice_bits), std::ldexp(p.y(), -lattice_bits),
            std::ldexp(p.z(), -lattice_bits)};
}

Point lattice_point(const Vector& v) {
    const auto rounded = [](double c) { return static_cast<std::int32_t>(std::lround(c * root_side)); };
    return {rounded(v[0]), rounded(v[1]), rounded(v[2])};
}

// What the subjects reach in the picture.
struct Window {
    const Camera& camera;
    Range across;
    Range along;

    void include(const Point& corner, std::int32_t length) {
        const double half = std::ldexp(length, -lattice_bits) / 2;
        const Vector centre = unit_of(corner) + Vector{half, half, half};
        across.include(dot(centre, camera.right), 2 * half * reach_along(camera.right));
        along.include(dot(centre, camera.down), 2 * half * reach_along(camera.down));
    }
    void include(const Octree& tree) {
        LeafWalk walk(tree);
        for (Leaf leaf = {}; walk.next(leaf);) {
            if (leaf.colour != Colour::white) include(leaf.octant.corner, leaf.octant.side());
        }
    }
    void include(const IntegerSolid& solid) {
        for (const Point& vertex : solid.vertices) include(vertex, 0);
    }
};

std::optional<View> known_view(std::string_view name) {
    for (const KnownView& known : known_views) {
        if (name == known.name) return known.view;
    }
    return std::nullopt;
}

std::optional<View> angle_view(std::string_view text) {
    double angles[2];
    if (!parse_decimals(text, angles, 2) || std::abs(angles[1]) > 90) return std::nullopt;
    return View{angles[0], angles[1]};
}

} // namespace

std::optional<std::vector<NamedView>> parse_views(std::string_view text) {
    std::vector<NamedView> views;
    for (std::size_t at = 0; at <= text.size();) {
        std::size_t end = std::min(text.find(',', at), text.size());
        std::optional<View> view = known_view(text.substr(at, end - at));
        if (!view) {
            end = std::min(text.find(',', end + 1), text.size());
            view = angle_view(text.substr(at, end - at));
        }
        if (!view) return std::nullopt;
        views.push_back({std::string(text.substr(at, end - at)), *view});
        at = end + 1;
    }
    return views;
}

Point Camera::direction() const { return lattice_point(4 * forward); }

Segment Camera::segment(int column, int row) const {
    const Point from = lattice_point(start + (column * step * right + row * step * down));
    const Point d = direction();
    return {from, {from.x() + d.x(), from.y() + d.y(), from.z() + d.z()}};
}

double Camera::ray_length() const {
    const Vector d = unit_of(direction());
    return std::sqrt(dot(d, d));
}

std::pair<double, double> Camera::place_of(const Point& point) const {
    const Vector from_start = unit_of(point) + -1 * start;
    return {dot(from_start, right) / step, dot(from_start, down) / step};
}

Slope Camera::slope_of(const Vector& normal) const {
    constexpr double steepest = 50;
    const Vector n = normalized(normal);
    const double along = dot(n, forward);
    const double facing = std::max(std::abs(along), 1 / steepest) * (along < 0 ? -1 : 1);
    return {static_cast<float>(-dot(n, right) / facing), static_cast<float>(-dot(n, down) / facing)};
}

Camera aim(const View& view, const std::vector<Subject>& subjects, int samples) {
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

    Window window = {camera, {}, {}};
    for (const Subject& subject : subjects) {
        std::visit([&](const auto* shown) { window.include(*shown); }, subject);
    }
    const Range& across = window.across;
    const Range& along = window.along;
    if (across.length() < 0) window.include(root_octant.corner, root_side);

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
