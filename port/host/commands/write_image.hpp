// A picture to a PNG file.
#ifndef OSEM_HOST_WRITE_IMAGE_HPP
#define OSEM_HOST_WRITE_IMAGE_HPP

#include <string>

#include "files/output_file.hpp"
#include "picture/image.hpp"

namespace osem::host {

inline void write_image(const std::string& path, const Image& image) {
    OutputFile output(path);
    write_png(output.stream(), image);
    output.commit();
}

} // namespace osem::host

#endif
