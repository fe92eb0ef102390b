// A picture in memory, and out as PNG.
#ifndef OSEM_HOST_IMAGE_HPP
#define OSEM_HOST_IMAGE_HPP

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

namespace osem::host {

using Rgb = std::array<std::uint8_t, 3>;

/// Rows from the top, pixels from the left.
struct Image {
    int width;
    int height;
    std::vector<Rgb> pixels;

    Image(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    Rgb& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// Writes a PNG of 8 bits a channel.
void write_png(std::ostream& out, const Image& image);

} // namespace osem::host

#endif
