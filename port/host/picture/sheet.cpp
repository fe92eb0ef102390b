#include "picture/sheet.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_easy_font.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace osem::host {

namespace {

// A corner of the rectangles that the font's letters are made of.
struct FontVertex {
    float x, y, z;
    unsigned char colour[4];
};

// Letters are about 7 units high; they are drawn two pixels a unit where there is room.
void write_label(Image& image, int left, int top, int size, std::string text) {
    std::array<FontVertex, 4096> vertices;
    const int count = 4 * stb_easy_font_print(0, 0, text.data(), nullptr, vertices.data(), sizeof vertices);
    const int scale = size >= 300 ? 2 : 1;
    const int margin = 4 * scale;
    const auto clipped = [&](float at) { return std::min(margin + scale * static_cast<int>(at), size); };
    for (int i = 0; i < count; i += 4) {
        const FontVertex& low = vertices[static_cast<std::size_t>(i)];
        const FontVertex& high = vertices[static_cast<std::size_t>(i) + 2];
        for (int y = clipped(low.y); y < clipped(high.y); ++y) {
            for (int x = clipped(low.x); x < clipped(high.x); ++x) image.at(left + x, top + y) = {60, 60, 60};
        }
    }
}

} // namespace

Image sheet(const std::vector<Tile>& tiles, int columns) {
    const int size = tiles.front().image.width;
    const int count = static_cast<int>(tiles.size());
    Image image(columns * size, (count + columns - 1) / columns * size);
    std::fill(image.pixels.begin(), image.pixels.end(), Rgb{255, 255, 255});
    for (int i = 0; i < count; ++i) {
        const int left = i % columns * size;
        const int top = i / columns * size;
        const Tile& tile = tiles[static_cast<std::size_t>(i)];
        for (int y = 0; y < size; ++y) {
            std::copy_n(tile.image.pixels.begin() + std::ptrdiff_t{y} * size, size,
                        image.pixels.begin() + std::ptrdiff_t{top + y} * image.width + left);
        }
        write_label(image, left, top, size, tile.label);
    }
    return image;
}

} // namespace osem::host
