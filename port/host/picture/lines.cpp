#include "picture/lines.hpp"

#include <algorithm>
#include <cmath>

namespace osem::host {

namespace {

class Drawing {
  public:
    Drawing(const Samples& samples, Lines lines, int per_pixel)
        : samples_(samples), lines_(lines), per_pixel_(per_pixel), ink_(samples.cells()) {
        for (int row = 0; row < samples.side; ++row) {
            for (int column = 0; column < samples.side; ++column) {
                if (parts(column, row, 1, 0)) stroke(column + 1, row, true);
                if (parts(column, row, 0, 1)) stroke(column, row + 1, false);
            }
        }
    }

    std::uint8_t pixel(int x, int y) const {
        int inked = 0;
        for (int row = y * per_pixel_; row < (y + 1) * per_pixel_; ++row) {
            for (int column = x * per_pixel_; column < (x + 1) * per_pixel_; ++column) {
                inked += ink_[samples_.index(column, row)];
            }
        }
        const int all = per_pixel_ * per_pixel_;
        return static_cast<std::uint8_t>(255 * (all - inked) / all);
    }

  private:
    // Whether a line runs between a sample and the next one, dx columns and dy rows on.
    bool parts(int column, int row, int dx, int dy) const {
        if (!samples_.holds(column + dx, row + dy)) return false;
        const std::size_t a = samples_.index(column, row);
        const std::size_t b = samples_.index(column + dx, row + dy);
        if (samples_.face[a] == samples_.face[b]) return false;
        if (lines_ == Lines::leaves || samples_.face[a] == 0 || samples_.face[b] == 0) return true;
        return samples_.plane[a] != samples_.plane[b] && (bends(a, b) || drops(a, b, dx, dy));
    }

    // By more than 25 degrees.
    bool bends(std::size_t a, std::size_t b) const {
        const Slope& s = samples_.slope[a];
        const Slope& t = samples_.slope[b];
        const float along = 1 + s.across * t.across + s.along * t.along;
        const float lengths =
            (1 + s.across * s.across + s.along * s.along) * (1 + t.across * t.across + t.along * t.along);
        return along < 0.906F * std::sqrt(lengths);
    }

    // By more than the two faces' slopes explain.
    bool drops(std::size_t a, std::size_t b, int dx, int dy) const {
        const auto rise = [&](const Slope& s) {
            return s.across * static_cast<float>(dx) + s.along * static_cast<float>(dy);
        };
        const float r = rise(samples_.slope[a]);
        const float s = rise(samples_.slope[b]);
        const float difference = samples_.depth[b] - samples_.depth[a];
        constexpr float rounding = 0.25F;
        return difference < std::min(r, s) - rounding || difference > std::max(r, s) + rounding;
    }

    // Inks a pixel's width of samples about the border before a sample.
    void stroke(int column, int row, bool upright) {
        const int first = -(per_pixel_ / 2);
        for (int k = first; k < first + per_pixel_; ++k) {
            const int x = column + (upright ? k : 0);
            const int y = row + (upright ? 0 : k);
            if (samples_.holds(x, y)) ink_[samples_.index(x, y)] = 1;
        }
    }

    const Samples& samples_;
    Lines lines_;
    int per_pixel_;
    std::vector<std::uint8_t> ink_;
};

} // namespace

Image draw_lines(const Samples& samples, Lines lines, int per_pixel) {
    const Drawing drawing(samples, lines, per_pixel);
    Image image(samples.side / per_pixel, samples.side / per_pixel);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t value = drawing.pixel(x, y);
            image.at(x, y) = {value, value, value};
        }
    }
    return image;
}

} // namespace osem::host
