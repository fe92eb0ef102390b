#include "broken_solids.hpp"

#include "exact_face.hpp"

namespace oracle {

TestSolid rebuilt(const TestSolid& solid, std::uint32_t changed, bool turned) {
    TestSolid result(solid.name);
    const osem::Solid view = solid.view_with_tables();
    for (std::uint32_t f = 0; f < view.face_count; ++f) {
        if (f == changed && !turned) continue;
        std::vector<Polygon> rings;
        for (std::uint32_t r = view.first_ring(f); r < view.end_ring(f); ++r) {
            const osem::Ring ring = view.ring(r);
            Polygon polygon;
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                polygon.push_back(view.vertices[ring.corners[f == changed ? ring.count - 1 - i : i]]);
            }
            rings.push_back(std::move(polygon));
        }
        result.add_face(rings);
    }
    return result;
}

bool is_planar(const osem::Solid& solid, std::uint32_t face) {
    std::vector<Point3> points;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const osem::Ring ring = solid.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            points.push_back(exact_point(solid.vertices[ring.corners[i]]));
        }
    }
    std::size_t second = 1;
    while (second < points.size() && points[second] == points[0]) ++second;
    std::size_t third = second + 1;
    while (third < points.size() && CGAL::collinear(points[0], points[second], points[third])) ++third;
    for (std::size_t i = third + 1; i < points.size(); ++i) {
        if (!CGAL::coplanar(points[0], points[second], points[third], points[i])) return false;
    }
    return true;
}

} // namespace oracle
