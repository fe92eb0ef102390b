// OFF, the Object File Format of Geomview, in its plain ASCII form.
#include "mesh/readers.hpp"

#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace {

void read_header(TextScanner& scanner) {
    const std::string_view keyword = scanner.word("the keyword OFF");
    if (keyword != "OFF") {
        scanner.fail("the file begins with " + quoted(keyword) +
                     "; only plain OFF is read (no normals, vertex colours or fourth coordinate)");
    }
}

void read_face(TextScanner& scanner, Mesh& mesh) {
    const auto vertex_count = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::uint32_t corners = scanner.count_of_items("a face's number of corners", 2);
    if (corners < 3) scanner.fail("a face has " + std::to_string(corners) + " corners; it needs three");
    for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t vertex = scanner.count("a vertex index");
        if (vertex >= vertex_count) {
            scanner.fail("vertex index " + std::to_string(vertex) + " is out of range; the file has " +
                         std::to_string(vertex_count) + " vertices, the first is 0");
        }
        mesh.corners.push_back(vertex);
    }
    mesh.end_ring();
    mesh.end_face();
    scanner.skip_line(); // what stands behind the corners is the face's colour
}

} // namespace

Mesh read_off(std::string_view bytes) {
    TextScanner scanner(bytes);
    read_header(scanner);
    const std::uint32_t vertices = scanner.count_of_items("the number of vertices", 6);
    const std::uint32_t faces = scanner.count_of_items("the number of faces", 8);
    scanner.count("the number of edges"); // widely written as 0, so not relied upon

    Mesh mesh;
    mesh.vertices.reserve(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) mesh.vertices.push_back(scanner.point("a coordinate"));
    for (std::uint32_t i = 0; i < faces; ++i) read_face(scanner, mesh);
    if (!scanner.at_end()) scanner.fail("more data follows the last of the faces announced");
    return mesh;
}

} // namespace osem::host
