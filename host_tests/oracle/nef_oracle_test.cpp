// One pair of solids combined by CGAL's Nef polyhedra: the Boolean itself, and not only its operands, is
// CGAL's.
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <gtest/gtest.h>

#include "converted.hpp"
#include "exact_solid.hpp"
#include "level.hpp"
#include "osem/query.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

using Polyhedron = CGAL::Polyhedron_3<Exact>;
using Nef = CGAL::Nef_polyhedron_3<Exact>;

// Precondition: faces without holes; the surface is a manifold.
Nef nef_of(const osem::Solid& solid) {
    std::vector<Point3> points;
    for (std::uint32_t v = 0; v < solid.vertex_count; ++v) points.push_back(exact_point(solid.vertices[v]));
    std::vector<std::vector<std::size_t>> polygons;
    for (std::uint32_t r = 0; r < solid.ring_count(); ++r) {
        const osem::Ring ring = solid.ring(r);
        polygons.emplace_back(ring.corners, ring.corners + ring.count);
    }
    Polyhedron polyhedron;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, polyhedron);
    return Nef(polyhedron);
}

Nef combined(osem::Operator op, const Nef& a, const Nef& b) {
    switch (op) {
    case osem::Operator::unite:
        return a + b;
    case osem::Operator::intersect:
        return a * b;
    case osem::Operator::subtract:
        return a - b;
    case osem::Operator::exclusive_or:
        break;
    }
    return a ^ b;
}

// The mark of the volume that holds a point off the surface.
bool is_inside(const Nef& nef, const Point3& p) {
    Nef::Volume_const_handle volume;
    EXPECT_TRUE(CGAL::assign(volume, nef.locate(p)));
    return volume->mark();
}

void test_pair(const TestSolid& a, const TestSolid& b, int depth) {
    const osem::ConvertOptions options{depth, osem::LeafRule::centre, osem::WindingRule::nonzero};
    HeapPool pool(1U << 16);
    const osem::CheckOutcome first = checked(a.view());
    const osem::CheckOutcome second = checked(b.view());
    ASSERT_EQ(first.status, osem::Status::ok);
    ASSERT_EQ(second.status, osem::Status::ok);
    const osem::Octree tree_a = converted(first.solid, options, *pool).tree;
    const osem::Octree tree_b = converted(second.solid, options, *pool).tree;
    const Nef nef_a = nef_of(a.view());
    const Nef nef_b = nef_of(b.view());
    for (const auto op : {osem::Operator::unite, osem::Operator::intersect, osem::Operator::subtract,
                          osem::Operator::exclusive_or}) {
        osem::Combination job;
        const osem::TreeOutcome outcome = osem::combine(job, op, tree_a, tree_b, *pool);
        ASSERT_EQ(outcome.status, osem::Status::ok);
        const Nef nef = combined(op, nef_a, nef_b);
        const int side = osem::root_side >> depth;
        const auto level = static_cast<std::uint8_t>(depth);
        for (int x = 0; x < osem::root_side; x += side) {
            for (int y = 0; y < osem::root_side; y += side) {
                for (int z = 0; z < osem::root_side; z += side) {
                    const osem::Octant cell{{{x, y, z}}, level};
                    const osem::Colour colour = osem::leaf_at(outcome.tree, cell.corner).leaf.colour;
                    const bool inside = is_inside(nef, perturbed_centre_of(cell));
                    ASSERT_EQ(colour, inside ? osem::Colour::black : osem::Colour::white)
                        << a.name << " and " << b.name << ", operator " << static_cast<int>(op) << ", cell "
                        << x << ", " << y << ", " << z;
                }
            }
        }
    }
}

TEST(NefOracle, CombinationsAtEveryCell) {
    TestSolid plain = box(aligned_grid, {4, 8, 2}, {20, 24, 31});
    plain.name = "box";
    TestSolid oblique = tetrahedron(aligned_grid(1, 3, 30), aligned_grid(31, 12, 4), aligned_grid(6, 30, 9),
                                    aligned_grid(28, 28, 29));
    oblique.name = "tetrahedron";
    test_pair(plain, oblique, is_full() ? 4 : 3);
    // Both have a face in the plane x = 20.
    TestSolid neighbour = box(aligned_grid, {20, 4, 8}, {28, 20, 24});
    neighbour.name = "neighbour";
    test_pair(plain, neighbour, 3);
}

} // namespace

} // namespace oracle
