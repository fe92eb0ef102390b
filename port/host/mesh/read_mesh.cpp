#include "mesh/read_mesh.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "mesh/bad_input.hpp"
#include "mesh/readers.hpp"
#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};

// A device or a pipe has no size that memory could be in proportion to, and may have no end.
void require_regular(const std::string& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        throw BadInput("is not a regular file");
    }
}

std::string read_file(const std::string& path) {
    require_regular(path);
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) throw BadInput("cannot be opened: " + std::generic_category().message(errno));
    std::string bytes;
    char buffer[1 << 16];
    while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, file.get())) {
        bytes.append(buffer, got);
    }
    if (std::ferror(file.get()) != 0) {
        throw BadInput("cannot be read: " + std::generic_category().message(errno));
    }
    return bytes;
}

using Reader = Mesh (*)(std::string_view);

Reader reader_for(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    const std::string_view extension = dot == std::string_view::npos ? "" : path.substr(dot + 1);
    if (equal_ignoring_case(extension, "off")) return read_off;
    if (equal_ignoring_case(extension, "stl")) return read_stl;
    if (equal_ignoring_case(extension, "obj")) return read_obj;
    if (equal_ignoring_case(extension, "poly")) return read_poly;
    const bool is_tree = equal_ignoring_case(extension, "osem");
    throw BadInput(std::string(is_tree ? "a tree, not a mesh" : "unknown kind of mesh file") +
                   ": the extension must be .off, .stl, .obj or .poly");
}

} // namespace

Mesh read_mesh(const std::string& path) {
    try {
        const Reader read = reader_for(path);
        return read(read_file(path));
    } catch (const BadInput& fault) {
        throw BadInput(path + ": " + fault.what());
    }
}

} // namespace osem::host
