#include "picture/slice.hpp"

#include <algorithm>
#include <cmath>

namespace osem::host {

namespace {

// Area of each colour in each pixel of the slice, rows from the bottom.
struct Coverage {
    int side;
    int unit_bits; ///< a pixel is 2^unit_bits lattice units wide
    std::vector<std::uint64_t> black;
    std::vector<std::uint64_t> boundary;

    explicit Coverage(int pixel_bits)
        : side(1 << pixel_bits), unit_bits(lattice_bits - pixel_bits), black(cells()), boundary(cells()) {}

    std::size_t cells() const { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }

    // A leaf is a square of whole pixels or lies in one.
    void add(std::vector<std::uint64_t>& area, std::int32_t u, std::int32_t v, std::int32_t leaf) const {
        const int pixels = std::max(1, leaf >> unit_bits);
        const auto width = static_cast<std::uint64_t>(std::min(leaf, std::int32_t{1} << unit_bits));
        for (int row = v >> unit_bits; row < (v >> unit_bits) + pixels; ++row) {
            for (int column = u >> unit_bits; column < (u >> unit_bits) + pixels; ++column) {
                area[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                     static_cast<std::size_t>(column)] += width * width;
            }
        }
    }
};

bool meets(const Octant& octant, Axis axis, std::int32_t cell) {
    const std::int32_t low = octant.corner.at[axis];
    return low <= cell && cell < low + octant.side();
}

Coverage cover(const Octree& tree, Axis axis, std::int32_t cell, int pixel_bits) {
    Coverage coverage(pixel_bits);
    const unsigned u = axis == axis_x ? 1 : 0;
    const unsigned v = axis == axis_z ? 1 : 2;
    for (NodeWalk walk(tree); !walk.done();) {
        if (!meets(walk.octant(), axis, cell)) {
            walk.skip();
            continue;
        }
        for (unsigned k = 0; k < 8; ++k) {
            const Octant child = walk.octant().child(k);
            const Colour colour = walk.node().colour(k);
            if ((colour != Colour::black && colour != Colour::boundary) || !meets(child, axis, cell)) {
                continue;
            }
            coverage.add(colour == Colour::black ? coverage.black : coverage.boundary, child.corner.at[u],
                         child.corner.at[v], child.side());
        }
        walk.next();
    }
    return coverage;
}

Rgb mixed(double black, double boundary) {
    constexpr double boundary_colour[3] = {70, 130, 180}; // steel blue
    const double white = 1 - black - boundary;
    Rgb colour = {};
    for (std::size_t i = 0; i < 3; ++i) {
        colour[i] = static_cast<std::uint8_t>(std::lround(255 * white + boundary_colour[i] * boundary));
    }
    return colour;
}

} // namespace

Image slice(const Octree& tree, Axis axis, std::int32_t cell) {
    const int most_bits = 11; // of slice_most_pixels
    static_assert(slice_most_pixels == 1 << most_bits);
    const Coverage coverage = cover(tree, axis, cell, std::min<int>(tree.depth, most_bits));
    const int scale = std::max(1, slice_least_pixels / coverage.side);
    const double pixel_area = static_cast<double>(std::uint64_t{1} << (2 * coverage.unit_bits));

    Image image(coverage.side * scale, coverage.side * scale);
    for (int y = 0; y < image.height; ++y) {
        const int row = coverage.side - 1 - y / scale;
        for (int x = 0; x < image.width; ++x) {
            const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(coverage.side) +
                                  static_cast<std::size_t>(x / scale);
            image.at(x, y) = mixed(static_cast<double>(coverage.black[i]) / pixel_area,
                                   static_cast<double>(coverage.boundary[i]) / pixel_area);
        }
    }
    return image;
}

} // namespace osem::host
