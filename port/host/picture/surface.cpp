#include "picture/surface.hpp"

#include <algorithm>
#include <cmath>

namespace osem::host {

namespace {

// A plane fitted to the depths in a window.
struct Fit {
    Slope slope;
    float depth; ///< at the window's centre
    float error; ///< root mean square distance from the plane, in samples; no_depth when nothing was fitted
};

constexpr int taps = 4;            // to each side of the window's centre
constexpr int spacing = 2;         // samples between the centres of windows
constexpr float largest_leaf = 24; // in samples; larger ones are shown as the cubes they are

// Half the width of a window, and the greatest error of a fit, both in leaves. Steps of one leaf stand a
// third of a leaf off their plane; the last pass takes what is too small or too bent for a plane.
struct Pass {
    float reach;
    float tolerance;
};
constexpr Pass passes[] = {{12, 0.45F}, {6, 0.45F}, {3, 0.45F}, {2, 0.7F}};

float slant(const Slope& s) { return std::sqrt(1 + s.across * s.across + s.along * s.along); }

// Sums of a least-squares fit of depth over column and row, about the window's centre.
struct Sums {
    double n = 0, u = 0, v = 0, z = 0, uu = 0, uv = 0, vv = 0, uz = 0, vz = 0, zz = 0;

    void add(double du, double dv, double dz) {
        n += 1;
        u += du, v += dv, z += dz;
        uu += du * du, uv += du * dv, vv += dv * dv;
        uz += du * dz, vz += dv * dz, zz += dz * dz;
    }

    Fit fit(float depth) const {
        const double cuu = uu - u * u / n, cuv = uv - u * v / n, cvv = vv - v * v / n;
        const double cuz = uz - u * z / n, cvz = vz - v * z / n, czz = zz - z * z / n;
        const double det = cuu * cvv - cuv * cuv;
        if (n < 6 || det < 1e-6 * (cuu + cvv) * (cuu + cvv)) return {{0, 0}, 0, no_depth};
        const double a = (cuz * cvv - cvz * cuv) / det;
        const double b = (cvz * cuu - cuz * cuv) / det;
        const double square = std::max(0.0, (czz - a * cuz - b * cvz) / n);
        const Slope slope = {static_cast<float>(a), static_cast<float>(b)};
        return {slope, depth + static_cast<float>((z - a * u - b * v) / n),
                static_cast<float>(std::sqrt(square)) / slant(slope)};
    }
};

Fit fit_window(const Samples& samples, int column, int row, int stride) {
    const float depth = samples.depth[samples.index(column, row)];
    if (depth == no_depth) return {{0, 0}, 0, no_depth};
    // Deeper by more than a steep slope explains is another surface.
    const float reach = 6 * static_cast<float>(taps * stride) + 2 * samples.leaf;
    Sums sums;
    for (int j = -taps; j <= taps; ++j) {
        for (int i = -taps; i <= taps; ++i) {
            const float there = samples.depth_at(column + i * stride, row + j * stride);
            if (std::abs(there - depth) < reach) sums.add(i * stride, j * stride, there - depth);
        }
    }
    return sums.fit(depth);
}

// Windows of one width about every spacing-th sample.
class Fits {
  public:
    Fits(const Samples& samples, int stride, float tolerance)
        : samples_(samples), side_((samples.side + spacing - 1) / spacing), stride_(stride),
          tolerance_(tolerance) {
        fits_.reserve(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
        for (int row = 0; row < side_; ++row) {
            for (int column = 0; column < side_; ++column) {
                fits_.push_back(fit_window(samples, column * spacing, row * spacing, stride));
            }
        }
    }

    // The slope at a sample: by the window around it, else by the best one beside it whose plane the sample
    // lies on; false when no window will do.
    bool slope_at(int column, int row, Slope& slope) const {
        const Fit* best = suitable(column, row, 0, 0);
        const int shift = taps * stride_;
        for (int dy = -1; dy <= 1 && best == nullptr; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Fit* fit = suitable(column, row, dx * shift, dy * shift);
                if (fit != nullptr && (best == nullptr || fit->error < best->error)) best = fit;
            }
        }
        if (best != nullptr) slope = best->slope;
        return best != nullptr;
    }

  private:
    const Fit* suitable(int column, int row, int dx, int dy) const {
        if (!samples_.holds(column + dx, row + dy)) return nullptr;
        const int x = (column + dx) / spacing;
        const int y = (row + dy) / spacing;
        const Fit& fit = fits_[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
                               static_cast<std::size_t>(x)];
        if (!(fit.error <= tolerance_)) return nullptr;
        const float plane = fit.depth + fit.slope.across * static_cast<float>(column - x * spacing) +
                            fit.slope.along * static_cast<float>(row - y * spacing);
        const float off = std::abs(samples_.depth[samples_.index(column, row)] - plane) / slant(fit.slope);
        return off <= 2.5F * tolerance_ ? &fit : nullptr;
    }

    const Samples& samples_;
    int side_;
    int stride_;
    float tolerance_;
    std::vector<Fit> fits_;
};

// The mean slope of what belongs to one smooth surface around a sample: it hides where one window ended and
// another took over.
Slope smoothed(const Samples& samples, const std::vector<Slope>& slopes, int column, int row) {
    constexpr int reach = 6;
    constexpr int stride = 2;
    constexpr float same_bend = 0.2F; // greatest difference of slope, relative to the slant
    const std::size_t centre = samples.index(column, row);
    const float bend = same_bend * slant(slopes[centre]) * slant(slopes[centre]);
    Slope sum = {0, 0};
    float count = 0;
    for (int y = row - reach; y <= row + reach; y += stride) {
        for (int x = column - reach; x <= column + reach; x += stride) {
            if (samples.depth_at(x, y) == no_depth) continue;
            const Slope& slope = slopes[samples.index(x, y)];
            const float across = slope.across - slopes[centre].across;
            const float along = slope.along - slopes[centre].along;
            if (across * across + along * along > bend * bend) continue;
            sum.across += slope.across;
            sum.along += slope.along;
            count += 1;
        }
    }
    return {sum.across / count, sum.along / count}; // the sample itself counts
}

std::vector<Slope> smoothed(const Samples& samples, const std::vector<Slope>& slopes) {
    std::vector<Slope> smooth(slopes);
    for (int row = 0; row < samples.side; ++row) {
        for (int column = 0; column < samples.side; ++column) {
            const std::size_t i = samples.index(column, row);
            if (samples.depth[i] != no_depth) smooth[i] = smoothed(samples, slopes, column, row);
        }
    }
    return smooth;
}

} // namespace

std::vector<Slope> surface_slopes(const Samples& samples) {
    std::vector<Slope> slopes(samples.slope);
    std::vector<bool> settled(samples.cells());
    for (std::size_t i = 0; i < samples.cells(); ++i) settled[i] = samples.depth[i] == no_depth;
    if (samples.leaf > largest_leaf) return slopes;

    for (const Pass& pass : passes) {
        const int stride = std::max(1, static_cast<int>(std::lround(pass.reach * samples.leaf / taps)));
        const float tolerance = std::max(pass.tolerance * samples.leaf, 0.3F); // below that is rounding
        const Fits fits(samples, std::min(stride, 24), tolerance);
        for (int row = 0; row < samples.side; ++row) {
            for (int column = 0; column < samples.side; ++column) {
                const std::size_t i = samples.index(column, row);
                if (!settled[i]) settled[i] = fits.slope_at(column, row, slopes[i]);
            }
        }
    }
    return smoothed(samples, slopes);
}

} // namespace osem::host
