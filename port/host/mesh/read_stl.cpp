// STL, binary and ASCII. Facet normals are ignored: the order of the corners says which side is outside.
#include "mesh/readers.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "mesh/bad_input.hpp"
#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace {

constexpr std::size_t header_size = 84;   // 80 bytes of text and the number of triangles
constexpr std::size_t triangle_size = 50; // normal and three corners, three floats each; two spare bytes

static_assert(std::numeric_limits<float>::is_iec559 && sizeof(float) == 4, "STL holds IEEE 754 binary32");

std::uint32_t little_endian_32(const char* bytes) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

double little_endian_float(const char* bytes) {
    const std::uint32_t bits = little_endian_32(bytes);
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
}

// Every vertex of an STL file is a corner, in order.
void add_triangle(Mesh& mesh) {
    const std::size_t vertices = mesh.vertices.size();
    for (std::size_t i = 3; i > 0; --i) mesh.corners.push_back(static_cast<std::uint32_t>(vertices - i));
    mesh.end_ring();
    mesh.end_face();
}

Mesh read_binary(std::string_view bytes, std::uint32_t triangles) {
    Mesh mesh;
    mesh.vertices.reserve(3 * std::size_t{triangles});
    mesh.corners.reserve(3 * std::size_t{triangles});
    mesh.ring_starts.reserve(std::size_t{triangles} + 1);
    mesh.face_rings.reserve(std::size_t{triangles} + 1);
    for (std::uint32_t t = 0; t < triangles; ++t) {
        const std::size_t first = header_size + std::size_t{t} * triangle_size + 12; // behind the normal
        for (std::size_t offset = first; offset < first + 36; offset += 12) {
            std::array<double, 3> point{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                point[axis] = little_endian_float(bytes.data() + offset + 4 * axis);
                if (!std::isfinite(point[axis])) {
                    throw BadInput("byte " + std::to_string(offset + 4 * axis) +
                                   ": a coordinate of triangle " + std::to_string(t) +
                                   " is not a finite number");
                }
            }
            mesh.vertices.push_back(point);
        }
        add_triangle(mesh);
    }
    return mesh;
}

void expect(TextScanner& scanner, const char* keyword) {
    const std::string_view token = scanner.word(keyword);
    if (!equal_ignoring_case(token, keyword)) {
        scanner.fail("'" + std::string(keyword) + "' should stand here, not " + quoted(token));
    }
}

// The rest of a facet whose first word has been read.
void read_facet(TextScanner& scanner, Mesh& mesh) {
    scanner.skip_line(); // the normal
    expect(scanner, "outer");
    expect(scanner, "loop");
    for (int i = 0; i < 3; ++i) {
        expect(scanner, "vertex");
        mesh.vertices.push_back(scanner.point("a coordinate"));
    }
    expect(scanner, "endloop");
    expect(scanner, "endfacet");
    add_triangle(mesh);
}

Mesh read_ascii(std::string_view bytes) {
    TextScanner scanner(bytes);
    Mesh mesh;
    while (!scanner.at_end()) { // a file may hold several solids
        expect(scanner, "solid");
        scanner.skip_line(); // the solid's name
        std::string_view token = scanner.word("facet or endsolid");
        for (; equal_ignoring_case(token, "facet"); token = scanner.word("facet or endsolid")) {
            read_facet(scanner, mesh);
        }
        if (!equal_ignoring_case(token, "endsolid")) {
            scanner.fail("'facet' or 'endsolid' should stand here, not " + quoted(token));
        }
        scanner.skip_line();
    }
    return mesh;
}

} // namespace

Mesh read_stl(std::string_view bytes) {
    // Many binary files begin with "solid" too; their size tells, and so does a zero byte.
    const bool has_header = bytes.size() >= header_size;
    const std::uint32_t triangles = has_header ? little_endian_32(bytes.data() + 80) : 0;
    const std::uint64_t size = header_size + std::uint64_t{triangle_size} * triangles;
    if (has_header && size == bytes.size()) return read_binary(bytes, triangles);

    const std::string_view head = bytes.substr(0, header_size);
    if (head.find('\0') == std::string_view::npos) return read_ascii(bytes);
    if (!has_header) throw BadInput("byte 0: too short for a binary STL file, whose header has 84 bytes");
    throw BadInput("byte 80: the header announces " + std::to_string(triangles) + " triangles, so " +
                   std::to_string(size) + " bytes, but the file has " + std::to_string(bytes.size()));
}

} // namespace osem::host
