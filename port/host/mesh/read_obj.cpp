// OBJ, the format of Wavefront. tinyobjloader splits it into statements and resolves what a face statement
// may look like. Coordinates and indices are read again from the text: tinyobjloader's decimals are off by
// units in the last place, its indices wrap around, and what is no number it silently takes for 0.
#include "mesh/readers.hpp"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <charconv>
#include <istream>
#include <streambuf>

#include "mesh/bad_input.hpp"
#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace {

// The text as a stream that knows how far it has been read.
class TextBuffer : public std::streambuf {
  public:
    explicit TextBuffer(std::string_view text) {
        char* const begin = const_cast<char*>(text.data()); // a get area is never written to
        setg(begin, begin, begin + text.size());
    }
    std::string_view read_so_far() const { return {eback(), static_cast<std::size_t>(gptr() - eback())}; }
};

struct Reading {
    TextBuffer& buffer;
    Mesh mesh;

    /// The statement just read, with its line number (counted only when something is wrong).
    std::string_view statement() const {
        std::string_view text = buffer.read_so_far();
        while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
        const std::size_t newline = text.find_last_of("\r\n");
        return newline == std::string_view::npos ? text : text.substr(newline + 1);
    }
    [[noreturn]] void fail(const std::string& what) const {
        const std::string_view text = buffer.read_so_far().substr(
            0, static_cast<std::size_t>(statement().data() - buffer.read_so_far().data()));
        const auto lines = std::count(text.begin(), text.end(), '\n');
        TextScanner({}, static_cast<std::uint64_t>(lines) + 1).fail(what);
    }
};

void take_vertex(void* context, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
    Reading& reading = *static_cast<Reading*>(context);
    TextScanner scanner(reading.statement());
    try {
        scanner.word("v");
        reading.mesh.vertices.push_back(scanner.point("a coordinate"));
    } catch (const BadInput&) {
        reading.fail("a vertex needs three finite numbers");
    }
}

// Indices count from 1, or from -1 backwards over the vertices read so far.
std::uint32_t resolve(const Reading& reading, std::int64_t index) {
    const auto count = static_cast<std::int64_t>(reading.mesh.vertices.size());
    const std::int64_t vertex = index > 0 ? index - 1 : count + index;
    if (index == 0 || vertex < 0 || vertex >= count) {
        reading.fail("vertex index " + std::to_string(index) + " is out of range; " + std::to_string(count) +
                     " vertices stand before this face, the first is 1");
    }
    return static_cast<std::uint32_t>(vertex);
}

// The vertex of a corner: an index, or such as 1/2, 1//3 or 1/2/3 with those of a texture and a normal.
std::int64_t corner_index(const Reading& reading, std::string_view corner) {
    std::int64_t first = 0;
    std::string_view rest = corner;
    for (int part = 0; part < 3; ++part) {
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
        const bool may_be_left_out = part == 1 && !rest.empty() && rest.front() == '/';
        if (error != std::errc() && !may_be_left_out) break;
        if (part == 0) first = index;
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        if (rest.empty()) return first;
        if (rest.front() != '/') break;
        rest.remove_prefix(1);
    }
    reading.fail("a face has the corner " + quoted(corner) + ", which is no vertex index");
}

void take_face(void* context, tinyobj::index_t*, int) {
    Reading& reading = *static_cast<Reading*>(context);
    constexpr const char* blanks = " \t";
    std::string_view text = reading.statement();
    text.remove_prefix(text.find('f') + 1);
    int count = 0;
    for (;; ++count) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (text.empty()) break;
        const std::string_view corner = text.substr(0, text.find_first_of(blanks));
        reading.mesh.corners.push_back(resolve(reading, corner_index(reading, corner)));
        text.remove_prefix(corner.size());
    }
    if (count < 3) reading.fail("a face has " + std::to_string(count) + " corners; it needs three");
    reading.mesh.end_ring();
    reading.mesh.end_face();
}

} // namespace

Mesh read_obj(std::string_view bytes) {
    TextBuffer buffer(bytes);
    std::istream stream(&buffer);
    Reading reading{buffer, {}};
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = take_vertex;
    callbacks.index_cb = take_face;
    std::string warnings; // of materials only, which have no meaning here
    std::string errors;
    if (!tinyobj::LoadObjWithCallback(stream, callbacks, &reading, nullptr, &warnings, &errors)) {
        throw BadInput(errors.substr(0, errors.find('\n')));
    }
    return std::move(reading.mesh);
}

} // namespace osem::host
