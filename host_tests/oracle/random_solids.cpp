// Random solids, the same in every run.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <random>

#include "solids.hpp"

namespace oracle {

namespace {

using Hull = CGAL::Exact_predicates_inexact_constructions_kernel; // nothing is constructed: doubles are exact
using HullMesh = CGAL::Surface_mesh<Hull::Point_3>;

// Half of the coordinates are even and a quarter multiples of eight, so that corners, edges and faces often
// lie on planes of octants.
int small_coordinate(std::mt19937& random) {
    const int any = static_cast<int>(random() % 33U);
    switch (random() % 4U) {
    case 0:
        return any & ~7;
    case 1:
        return any & ~1;
    default:
        return any;
    }
}

osem::Point small_point(const Grid& grid, std::mt19937& random) {
    const int x = small_coordinate(random);
    const int y = small_coordinate(random);
    const int z = small_coordinate(random);
    return grid(x, y, z);
}

TestSolid soup(const Grid& grid, std::mt19937& random) {
    TestSolid all;
    const auto parts = static_cast<unsigned>(1 + random() % 4U);
    for (unsigned i = 0; i < parts; ++i) {
        const osem::Point a = small_point(grid, random);
        const osem::Point b = small_point(grid, random);
        const osem::Point c = small_point(grid, random);
        const osem::Point d = small_point(grid, random);
        TestSolid part = tetrahedron(a, b, c, d);
        if (random() % 4U == 0) part.invert();
        all.add(part);
    }
    return all;
}

TestSolid hull(const Grid& grid, std::mt19937& random) {
    std::vector<Hull::Point_3> points;
    const auto count = static_cast<unsigned>(6 + random() % 20U);
    for (unsigned i = 0; i < count; ++i) {
        const osem::Point p = small_point(grid, random);
        points.emplace_back(p.x(), p.y(), p.z());
    }
    HullMesh mesh;
    CGAL::convex_hull_3(points.begin(), points.end(), mesh);
    TestSolid solid;
    for (const auto face : mesh.faces()) {
        Polygon ring;
        for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
            const Hull::Point_3& p = mesh.point(vertex);
            ring.push_back({{static_cast<int>(p.x()), static_cast<int>(p.y()), static_cast<int>(p.z())}});
        }
        solid.add_face({ring});
    }
    return solid;
}

} // namespace

std::vector<TestSolid> random_solids(const Grid& grid, unsigned count, unsigned seed) {
    std::vector<TestSolid> solids;
    for (unsigned i = 0; i < count; ++i) {
        std::mt19937 random(seed + i);
        solids.push_back(i % 2 == 0 ? soup(grid, random) : hull(grid, random));
        solids.back().name = (i % 2 == 0 ? "soup of seed " : "hull of seed ") + std::to_string(seed + i);
    }
    return solids;
}

} // namespace oracle
