// TetGen's .poly: a piecewise linear complex of facets. A facet is read as one face whose rings are its
// polygons; which of them are holes, and which way the facet faces, is decided on the lattice.
#include "mesh/readers.hpp"

#include "mesh/text_scanner.hpp"

namespace osem::host {

namespace {

// Node numbers start at 0 or at 1, as the first node says.
struct Nodes {
    std::uint32_t first;
    std::uint32_t count;
};

Nodes read_nodes(TextScanner& scanner, Mesh& mesh) {
    const std::uint32_t nodes = scanner.count_of_items("the number of nodes", 8);
    if (nodes == 0) scanner.fail("the nodes are in a separate .node file, which is not read; put them here");
    if (scanner.count("the dimension") != 3) scanner.fail("the dimension must be 3");
    scanner.skip_line(); // numbers of attributes and markers a node, which stand behind the coordinates
    mesh.vertices.reserve(nodes);
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        const std::uint32_t number = scanner.count("a node number");
        if (i == 0) {
            if (number > 1) scanner.fail("the first node's number must be 0 or 1");
            first = number;
        }
        if (number != first + i) scanner.fail("node " + std::to_string(first + i) + " should stand here");
        mesh.vertices.push_back(scanner.point("a coordinate"));
        scanner.skip_line();
    }
    return {first, nodes};
}

void read_polygon(TextScanner& scanner, const Nodes& nodes, Mesh& mesh) {
    const std::uint32_t corners = scanner.count_of_items("a polygon's number of corners", 2);
    if (corners < 3) {
        scanner.fail("a polygon has " + std::to_string(corners) +
                     " corners: loose points and segments in a facet bound no solid");
    }
    for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t number = scanner.count("a node number");
        if (number < nodes.first || number - nodes.first >= nodes.count) {
            scanner.fail("node " + std::to_string(number) + " does not exist; the file has " +
                         std::to_string(nodes.count) + ", the first is " + std::to_string(nodes.first));
        }
        mesh.corners.push_back(number - nodes.first);
    }
    mesh.end_ring();
}

void read_facet(TextScanner& scanner, const Nodes& nodes, Mesh& mesh) {
    const std::uint32_t polygons = scanner.count_of_items("a facet's number of polygons", 7);
    if (polygons == 0) scanner.fail("a facet has no polygon");
    const std::uint32_t holes = scanner.at_line_end() ? 0 : scanner.count_of_items("a facet's holes", 8);
    scanner.skip_line(); // a boundary marker may follow
    for (std::uint32_t i = 0; i < polygons; ++i) read_polygon(scanner, nodes, mesh);
    // A point in each hole is what a mesh generator needs to eat it away. How the polygons are nested says
    // the same without trust in the points.
    for (std::uint32_t i = 0; i < holes; ++i) {
        scanner.count("a hole's number");
        scanner.point("a coordinate of a hole point");
    }
    mesh.end_face();
}

// The points that mark cavities of the volume. The even-odd rule finds the cavities from the facets alone,
// so the list is only read for its faults; the list of regions that may follow has no meaning here.
void read_volume_holes(TextScanner& scanner) {
    if (scanner.at_end()) return;
    const std::uint32_t holes = scanner.count_of_items("the number of holes", 8);
    for (std::uint32_t i = 0; i < holes; ++i) {
        scanner.count("a hole's number");
        scanner.point("a coordinate of a hole point");
    }
}

} // namespace

Mesh read_poly(std::string_view bytes) {
    TextScanner scanner(bytes);
    Mesh mesh;
    mesh.oriented = false;
    const Nodes nodes = read_nodes(scanner, mesh);
    const std::uint32_t facets = scanner.count_of_items("the number of facets", 9);
    scanner.skip_line(); // a flag for boundary markers may follow
    for (std::uint32_t i = 0; i < facets; ++i) read_facet(scanner, nodes, mesh);
    read_volume_holes(scanner);
    return mesh;
}

} // namespace osem::host
