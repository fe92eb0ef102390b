#include "picture/image.hpp"

#include <new>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace osem::host {

namespace {

void put(void* context, void* data, int size) {
    static_cast<std::ostream*>(context)->write(static_cast<const char*>(data), size);
}

} // namespace

void write_png(std::ostream& out, const Image& image) {
    static_assert(sizeof(Rgb) == 3, "pixels are packed");
    const int stride = 3 * image.width;
    // The library fails for want of memory alone; what the stream refuses is the stream's own state.
    if (stbi_write_png_to_func(put, &out, image.width, image.height, 3, image.pixels.data(), stride) == 0) {
        throw std::bad_alloc();
    }
}

} // namespace osem::host
