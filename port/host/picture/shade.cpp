#include "picture/shade.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture/vector.hpp"

namespace osem::host {

namespace {

// Colours are linear light until the end.
const Vector steel_blue = {0.20, 0.33, 0.50};
const Vector warm_grey = {0.52, 0.47, 0.41};
const Vector background_top = {0.93, 0.945, 0.96};
const Vector background_bottom = {0.78, 0.80, 0.83};

// Directions towards the lights in picture space: columns, rows (downwards), depth (away from the viewer).
const Vector key_light = normalized({-0.45, -0.65, -0.75});
const Vector fill_light = normalized({0.8, 0.1, -0.55});

Vector normal_of(const Slope& slope) { return normalized({slope.across, slope.along, -1}); }

struct Direction {
    double x;
    double y;
};

constexpr double half = 0.70710678118654752;
constexpr Direction directions[] = {{1, 0},  {half, half},   {0, 1},  {-half, half},
                                    {-1, 0}, {-half, -half}, {0, -1}, {half, -half}};

class Shader {
  public:
    Shader(const Samples& samples, const std::vector<Slope>& slopes, bool steps)
        : samples_(samples), slopes_(slopes), steps_(steps && samples.leaf >= least_step) {}

    Vector colour(int column, int row) const {
        const std::size_t i = samples_.index(column, row);
        if (samples_.depth[i] == no_depth) return background(row);
        const Vector normal = normal_of(slopes_[i]);
        const double open = openness(column, row);
        const double key = std::max(0.0, dot(normal, key_light));
        const double fill = std::max(0.0, dot(normal, fill_light));
        const double sky = 0.5 - 0.5 * normal[1]; // rows grow downwards
        const double light = open * (0.13 + 0.24 * sky + 0.18 * fill) + (0.3 + 0.7 * open) * 1.05 * key;
        const double shine = open * 0.16 * std::pow(std::max(0.0, dot(normal, highlight_)), 40);
        const Vector lit = light * (samples_.black[i] != 0 ? warm_grey : steel_blue);
        return line(column, row, normal) * (lit + Vector{shine, shine, shine});
    }

  private:
    Vector background(int row) const {
        const double t = static_cast<double>(row) / samples_.side;
        return (1 - t) * background_top + t * background_bottom;
    }

    // How far the surface stands in front of the tangent plane of a sample, `dx` columns and `dy` rows away.
    float rise(std::size_t i, int column, int row, int dx, int dy) const {
        const Slope& slope = slopes_[i];
        const float plane =
            samples_.depth[i] + slope.across * static_cast<float>(dx) + slope.along * static_cast<float>(dy);
        return plane - samples_.depth_at(column + dx, row + dy);
    }

    // Ambient occlusion: the part of the sky that what rises around a sample leaves, from 0 to 1.
    double openness(int column, int row) const {
        const std::size_t i = samples_.index(column, row);
        const double slant =
            std::sqrt(1 + slopes_[i].across * slopes_[i].across + slopes_[i].along * slopes_[i].along);
        const double reach = 0.09 * samples_.side;
        const double step = 1.5 * samples_.leaf + 1; // the height of steps is no occlusion
        double hidden = 0;
        for (const Direction& d : directions) {
            double worst = 0;
            for (const double part : {0.04, 0.1, 0.2, 0.4, 0.7, 1.0}) {
                const double distance = part * reach;
                const int dx = static_cast<int>(std::lround(d.x * distance));
                const int dy = static_cast<int>(std::lround(d.y * distance));
                const double height = rise(i, column, row, dx, dy) / slant - step;
                if (!(height > 0)) continue;
                // What stands far in front is another part, whose shadow would be a halo.
                const double near = std::max(0.0, 1 - height / (2 * reach)) * (1 - 0.6 * part);
                worst = std::max(worst, near * height / std::sqrt(height * height + distance * distance));
            }
            hidden += worst;
        }
        return 1 - 0.85 * hidden / 8;
    }

    // Leaves of so many samples at least have room for lines between them.
    static constexpr float least_step = 4;

    // A thin dark line where the surface ends in front of another, a fainter one along its edges and on the
    // rims of steps, which nothing else shows to a viewer who looks along an axis.
    double line(int column, int row, const Vector& normal) const {
        const std::size_t i = samples_.index(column, row);
        const double step = 4 * samples_.leaf + 3;
        double strength = 1;
        for (const auto& [dx, dy] : {std::pair<int, int>{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const double drop = -rise(i, column, row, dx, dy);
            if (drop > step) {
                strength = std::min(strength, 0.45);
            } else if (steps_ && drop > 0.5 * samples_.leaf) {
                strength = std::min(strength, 0.7);
            } else if (samples_.holds(column + dx, row + dy)) {
                const Slope& beside = slopes_[samples_.index(column + dx, row + dy)];
                const double bend = dot(normal, normal_of(beside));
                if (bend < 0.85 && samples_.depth_at(column + dx, row + dy) != no_depth) {
                    strength = std::min(strength, 0.8);
                }
            }
        }
        return strength;
    }

    const Samples& samples_;
    const std::vector<Slope>& slopes_;
    bool steps_;
    const Vector highlight_ = normalized(key_light + Vector{0, 0, -1});
};

std::uint8_t encoded(double light) {
    const double value = std::pow(std::clamp(light, 0.0, 1.0), 1 / 2.2);
    return static_cast<std::uint8_t>(std::lround(255 * value));
}

} // namespace

Image shade(const Samples& samples, const std::vector<Slope>& slopes, bool steps) {
    const Shader shader(samples, slopes, steps);
    Image image(samples.side / 2, samples.side / 2);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Vector sum = (shader.colour(2 * x, 2 * y) + shader.colour(2 * x + 1, 2 * y)) +
                               (shader.colour(2 * x, 2 * y + 1) + shader.colour(2 * x + 1, 2 * y + 1));
            image.at(x, y) = {encoded(sum[0] / 4), encoded(sum[1] / 4), encoded(sum[2] / 4)};
        }
    }
    return image;
}

} // namespace osem::host
