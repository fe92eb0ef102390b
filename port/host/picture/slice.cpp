#include "picture/slice.hpp"

#include <algorithm>
#include <cmath>

namespace osem::host {

namespace {

// How much of each column of a picture row is covered. A run adds to its two ends and to the change of cover
// behind its first column, so that its length costs nothing.
class Cover {
  public:
    Cover(int columns, int shift)
        : shift_(shift), ends_(static_cast<std::size_t>(columns)), change_(ends_.size() + 1) {}

    void add(std::int32_t start, std::int32_t end) {
        const auto first = static_cast<std::size_t>(start >> shift_);
        const auto last = static_cast<std::size_t>((end - 1) >> shift_);
        if (first == last) {
            ends_[first] += end - start;
            return;
        }
        const std::int64_t column = std::int64_t{1} << shift_;
        ends_[first] += static_cast<std::int64_t>(first + 1) * column - start;
        ends_[last] += end - static_cast<std::int64_t>(last) * column;
        change_[first + 1] += column;
        change_[last] -= column;
    }

    // Takes the cover of the columns, and starts anew.
    std::vector<std::int64_t> take() {
        std::vector<std::int64_t> cover = ends_;
        std::int64_t through = 0;
        for (std::size_t i = 0; i < cover.size(); ++i) {
            through += change_[i];
            cover[i] += through;
        }
        std::fill(ends_.begin(), ends_.end(), 0);
        std::fill(change_.begin(), change_.end(), 0);
        return cover;
    }

  private:
    int shift_;
    std::vector<std::int64_t> ends_;
    std::vector<std::int64_t> change_;
};

Rgb mixed(double black, double boundary) {
    constexpr double boundary_colour[3] = {70, 130, 180}; // steel blue
    const double white = 1 - black - boundary;
    Rgb colour = {};
    for (std::size_t i = 0; i < 3; ++i) {
        colour[i] = static_cast<std::uint8_t>(std::lround(255 * white + boundary_colour[i] * boundary));
    }
    return colour;
}

// Runs to pixels, a row of the picture at a time.
class SlicePicture {
  public:
    explicit SlicePicture(int level)
        : shift_(std::max(0, level - most_bits)), side_(1 << (level - shift_)),
          scale_(std::max(1, slice_least_pixels / side_)), image_(side_ * scale_, side_ * scale_),
          black_(side_, shift_), boundary_(side_, shift_) {
        std::fill(image_.pixels.begin(), image_.pixels.end(), mixed(0, 0));
    }

    RunSink sink() { return {take, this}; }

    Image finish() {
        paint_row();
        return std::move(image_);
    }

  private:
    static constexpr int most_bits = 11;
    static_assert(slice_most_pixels == 1 << most_bits);

    static bool take(void* context, const PixelRun& run) {
        auto& self = *static_cast<SlicePicture*>(context);
        const int row = run.row >> self.shift_;
        if (row != self.row_) self.paint_row();
        self.row_ = row;
        (run.colour == Colour::black ? self.black_ : self.boundary_).add(run.start, run.start + run.length);
        return true;
    }

    void paint_row() {
        const std::vector<std::int64_t> black = black_.take();
        const std::vector<std::int64_t> boundary = boundary_.take();
        const double area = static_cast<double>(std::int64_t{1} << (2 * shift_));
        for (int y = 0; y < scale_; ++y) {
            for (int x = 0; x < image_.width; ++x) {
                const auto i = static_cast<std::size_t>(x / scale_);
                image_.at(x, (side_ - 1 - row_) * scale_ + y) =
                    mixed(static_cast<double>(black[i]) / area, static_cast<double>(boundary[i]) / area);
            }
        }
    }

    int shift_; // a pixel of the picture is 2^shift_ of the slice's a side
    int side_;
    int scale_;
    Image image_;
    Cover black_;
    Cover boundary_;
    int row_ = 0;
};

} // namespace

Image draw_slice(const Octree& tree, const Slice& slice) {
    SlicePicture picture(slice.level);
    RunSlicing job;
    static_cast<void>(
        job.begin(tree, slice, picture.sink())); // a slice of the tree, and a sink that takes all
    job.step(UINT32_MAX);
    return picture.finish();
}

} // namespace osem::host
