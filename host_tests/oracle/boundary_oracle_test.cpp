// The surfaces of octrees as CGAL sees them: closed, oriented outwards, 2-manifolds by their vertex indices,
// and around exactly the volume of the solid.
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "converted.hpp"
#include "exact_face.hpp"
#include "level.hpp"
#include "off_mesh.hpp"
#include "osem/boundary.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

using Mesh = CGAL::Surface_mesh<Point3>;
namespace processing = CGAL::Polygon_mesh_processing;

constexpr osem::SolidPart both_parts[] = {osem::SolidPart::inner, osem::SolidPart::outer};

struct Surface {
    std::vector<osem::Point> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> ring_starts;
    std::vector<std::uint32_t> face_rings;
    osem::Solid view;

    Surface(const osem::Octree& tree, osem::SolidPart part) {
        osem::Boundary job;
        job.begin(tree, part, nullptr, 0);
        const std::uint32_t entries = osem::boundary_scratch(run(job).corners);
        std::vector<osem::BoundaryCorner> scratch(entries + std::size_t{1});
        job.begin(tree, part, scratch.data(), entries);
        const osem::BoundarySizes sizes = run(job);
        vertices.resize(sizes.vertices);
        corners.resize(sizes.corners);
        ring_starts.resize(sizes.rings + std::size_t{1});
        face_rings.resize(sizes.faces + std::size_t{1});
        view = osem::boundary_solid(job,
                                    {vertices.data(), corners.data(), ring_starts.data(), face_rings.data()});
    }

    static osem::BoundarySizes run(osem::Boundary& job) {
        while (job.step(UINT32_MAX)) {
        }
        const osem::BoundaryOutcome outcome = job.finish();
        EXPECT_EQ(outcome.status, osem::Status::ok);
        EXPECT_EQ(outcome.double_edges, 0U);
        return outcome.sizes;
    }
};

// The surface as a soup of triangles, with a disc in every ring. A ring may pass through a vertex twice, so a
// disc has corners of its own at the ring's places, joined to the ring by triangles without area. What it
// says of edges and vertices is true of the surface; and the discs of holes count against the faces' outer
// ones, so that the volume is the surface's.
struct Soup {
    std::vector<Point3> points;
    std::vector<std::vector<std::size_t>> triangles;

    explicit Soup(const osem::Solid& surface) {
        for (std::uint32_t v = 0; v < surface.vertex_count; ++v) {
            points.push_back(exact_point(surface.vertices[v]));
        }
        for (std::uint32_t r = 0; r < surface.ring_count(); ++r) add_disc(surface.ring(r));
    }

    void add_disc(const osem::Ring& ring) {
        const std::size_t first = points.size();
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const std::uint32_t next = i + 1 == ring.count ? 0 : i + 1;
            points.push_back(points[ring.corners[i]]);
            triangles.push_back({ring.corners[i], ring.corners[next], first + next});
            triangles.push_back({ring.corners[i], first + next, first + i});
            if (i >= 2) triangles.push_back({first, first + i - 1, first + i});
        }
    }
};

FT exact_number(std::uint64_t number) {
    constexpr double word = 4294967296.0;
    return FT(static_cast<double>(number >> 32)) * word + static_cast<double>(number & UINT32_MAX);
}

void expect_closed_manifold(const osem::Solid& surface, std::uint64_t volume) {
    const Soup soup(surface);
    ASSERT_TRUE(processing::is_polygon_soup_a_polygon_mesh(soup.triangles));
    Mesh mesh;
    processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    EXPECT_EQ(mesh.number_of_faces(), soup.triangles.size());
    EXPECT_TRUE(mesh.is_valid());
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_EQ(processing::volume(mesh), exact_number(volume)); // inwards it would be negative
}

// Every face covered once, by exact triangulation: its outer ring turns one way and its holes the other, none
// crosses another. Six times the volume under the faces is then the solid's.
void expect_simple_faces(const osem::Solid& surface, std::uint64_t volume) {
    FT six_volumes = 0;
    const Point3 origin(0, 0, 0);
    for (std::uint32_t face = 0; face < surface.face_count; ++face) {
        const FacePieces pieces = pieces_of(surface, face);
        ASSERT_FALSE(pieces.triangles.empty());
        for (const WoundTriangle& triangle : pieces.triangles) {
            ASSERT_EQ(triangle.winding, pieces.triangles.front().winding);
            ASSERT_EQ(std::abs(triangle.winding), 1);
            const Triangle3& t = triangle.shape;
            six_volumes += 6 * triangle.winding * CGAL::volume(origin, t[0], t[1], t[2]);
        }
        CGAL::exact(six_volumes); // forgets how the number came about
    }
    EXPECT_EQ(six_volumes, 6 * exact_number(volume));
}

struct Totals {
    std::uint64_t surfaces = 0;
    std::uint64_t faces = 0;
    std::uint64_t corners = 0;
};

void test_tree(const osem::Octree& tree, Totals& totals) {
    const osem::Measures measures = osem::measure(tree);
    for (const osem::SolidPart part : both_parts) {
        const Surface surface(tree, part);
        const std::uint64_t volume =
            part == osem::SolidPart::inner ? measures.inner_volume : measures.outer_volume;
        expect_closed_manifold(surface.view, volume);
        expect_simple_faces(surface.view, volume);
        ++totals.surfaces;
        totals.faces += surface.view.face_count;
        totals.corners += surface.view.corner_count;
    }
}

void test_solid(const std::string& name, const osem::Solid& solid, int depth, Totals& totals) {
    const osem::CheckOutcome outcome = checked(solid);
    ASSERT_EQ(outcome.status, osem::Status::ok) << name << ": " << osem::describe(outcome.status);
    HeapPool pool(1U << 18);
    const osem::ConvertOptions options{depth, osem::LeafRule::conservative, osem::WindingRule::nonzero};
    const osem::TreeOutcome tree = converted(outcome.solid, options, *pool);
    ASSERT_EQ(tree.status, osem::Status::ok) << name;
    test_tree(tree.tree, totals);
    EXPECT_FALSE(::testing::Test::HasFailure()) << name << ", depth " << depth;
}

void print(const char* what, const Totals& totals) {
    std::printf("%s: %llu surfaces, %llu faces, %llu corners\n", what,
                static_cast<unsigned long long>(totals.surfaces),
                static_cast<unsigned long long>(totals.faces),
                static_cast<unsigned long long>(totals.corners));
}

void test_library(const Grid& grid) {
    Totals totals;
    const int depth = is_full() ? 5 : 4;
    for (const TestSolid& solid : every(is_full() ? 1 : 6, library(grid))) {
        test_solid(solid.name, solid.view(), depth, totals);
        if (::testing::Test::HasFailure()) return;
    }
    EXPECT_GT(totals.surfaces, 0U);
    print(grid.name, totals);
}

TEST(BoundaryOracle, TheLibraryOnPlanesOfOctants) { test_library(aligned_grid); }

TEST(BoundaryOracle, TheLibraryOffThem) { test_library(crooked_grid); }

// Cells at random: all that can touch in edges and corners only.
TEST(BoundaryOracle, RandomCells) {
    Totals totals;
    std::uint32_t state = 1;
    for (int round = 0; round < (is_full() ? 60 : 6); ++round) {
        HeapPool pool(600);
        osem::TreeBuilder builder;
        builder.begin(&*pool);
        for (unsigned k = 0; k < 8; ++k) {
            builder.open(k);
            for (unsigned j = 0; j < 8; ++j) {
                builder.open(j);
                for (unsigned i = 0; i < 8; ++i) {
                    state = state * 1664525U + 1013904223U; // Numerical Recipes
                    builder.leaf(i, state >> 28 < 2U + static_cast<unsigned>(2 * round % 12)
                                        ? osem::Colour::black
                                        : osem::Colour::white);
                }
                builder.close();
            }
            builder.close();
        }
        builder.close();
        const osem::TreeOutcome tree = builder.finish(3);
        ASSERT_EQ(tree.status, osem::Status::ok);
        test_tree(tree.tree, totals);
        ASSERT_FALSE(HasFailure()) << "round " << round;
    }
    print("random cells", totals);
}

TEST(BoundaryOracle, RealMeshes) {
    if (mesh_folder().empty()) FAIL() << "OSEM_CGAL_DATA names no folder";
    Totals totals;
    for (const char* name : {"star", "3torus"}) {
        const std::optional<TriangleMesh> mesh = read_off(name, whole_root);
        ASSERT_TRUE(mesh.has_value()) << name << " is not in " << mesh_folder();
        test_solid(name, mesh->view(), is_full() ? 6 : 5, totals);
    }
    print("meshes", totals);
}

} // namespace

} // namespace oracle
