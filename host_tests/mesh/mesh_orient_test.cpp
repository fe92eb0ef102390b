// Facets without orientation: roles of rings, shells, nesting. A box of side s has six times the volume
// 6 s^3, a cavity counts negative.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "builders.hpp"
#include "mesh/topology.hpp"

namespace osem::host {
namespace {

// Turns rings over, rotates and shuffles them within their facet: what an unoriented file may hold.
Mesh disoriented(const Mesh& mesh, unsigned seed) {
    std::mt19937 random(seed);
    Mesh result;
    result.oriented = false;
    result.vertices = mesh.vertices;
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
        std::vector<std::vector<std::uint32_t>> rings;
        for (std::uint32_t r = mesh.face_rings[face]; r < mesh.face_rings[face + 1]; ++r) {
            rings.emplace_back(mesh.corners.data() + mesh.ring_starts[r],
                               mesh.corners.data() + mesh.ring_starts[r + 1]);
            auto& ring = rings.back();
            std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random() % ring.size()),
                        ring.end());
            if (random() % 2 == 0) std::reverse(ring.begin(), ring.end());
        }
        std::shuffle(rings.begin(), rings.end(), random);
        add_face(result, rings);
    }
    return result;
}

double volume6(const Mesh& mesh) {
    const IntegerSolid solid = quantize(mesh, lattice_cube());
    EXPECT_NO_THROW(check_or_throw(solid));
    return topology(solid).volume6;
}

double box6(double side) { return 6 * side * side * side; }

TEST(Orient, ABoxHoweverItsFacetsAreTurned) {
    Mesh mesh;
    add_box(mesh, {10, 10, 10}, {30, 30, 30});
    for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(volume6(disoriented(mesh, seed)), box6(20));
}

TEST(Orient, CountsTheFacesTurned) {
    Mesh mesh;
    add_box(mesh, {10, 10, 10}, {30, 30, 30});
    mesh.oriented = false;
    EXPECT_EQ(quantize(mesh, lattice_cube()).reoriented_faces, 0U);
    std::reverse(mesh.corners.begin() + 4, mesh.corners.begin() + 12); // swaps two faces, both turned over
    EXPECT_EQ(quantize(mesh, lattice_cube()).reoriented_faces, 2U);
}

TEST(Orient, NestedShellsAlternate) {
    Mesh mesh;
    add_box(mesh, {40, 40, 40}, {50, 50, 50}); // inside three others
    add_box(mesh, {30, 30, 30}, {60, 60, 60}); // inside two
    add_box(mesh, {20, 20, 20}, {70, 70, 70}); // inside one
    add_box(mesh, {10, 10, 10}, {90, 90, 90});
    add_box(mesh, {200, 10, 10}, {207, 17, 17}); // beside
    add_box(mesh, {72, 72, 72}, {80, 80, 80});   // beside the inner ones, in the outermost
    const double expected = box6(80) - box6(50) + box6(30) - box6(10) + box6(7) - box6(8);
    for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(volume6(disoriented(mesh, seed)), expected);
}

TEST(Orient, ShellsThatTouch) {
    Mesh beside; // the small box stands on the middle of the large one's side
    add_box(beside, {10, 10, 10}, {30, 30, 30});
    add_box(beside, {30, 15, 15}, {40, 25, 25});
    EXPECT_EQ(volume6(disoriented(beside, 1)), box6(20) + box6(10));
    Mesh inside; // a cavity that reaches the side from within
    add_box(inside, {10, 10, 10}, {30, 30, 30});
    add_box(inside, {20, 15, 15}, {30, 25, 25});
    EXPECT_EQ(volume6(disoriented(inside, 2)), box6(20) - box6(10));
    Mesh edge; // two boxes with an edge in common, which four facets share
    add_box(edge, {10, 10, 10}, {20, 20, 20});
    add_box(edge, {20, 20, 10}, {30, 30, 20});
    EXPECT_EQ(volume6(disoriented(edge, 3)), 2 * box6(10));
}

void add_octahedron(Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& p : std::vector<std::array<double, 3>>{
             {10, 20, 20}, {30, 20, 20}, {20, 10, 20}, {20, 30, 20}, {20, 20, 10}, {20, 20, 30}}) {
        mesh.vertices.push_back(p);
    }
    for (std::uint32_t k = 0; k < 8; ++k) {
        add_face(mesh, {{first + (k & 1U), first + 2 + (k >> 1 & 1U), first + 4 + (k >> 2)}});
    }
}

// All corners of an octahedron lie on a box around it, which a post on one of its corners makes higher.
TEST(Orient, NestingIsDecidedWhereAllCornersTouch) {
    Mesh mesh;
    mesh.vertices = {{10, 10, 10}, {30, 10, 10}, {30, 30, 10}, {10, 30, 10}, {30, 10, 30},
                     {30, 30, 30}, {10, 30, 30}, {12, 10, 30}, {12, 12, 30}, {10, 12, 30},
                     {10, 10, 40}, {12, 10, 40}, {12, 12, 40}, {10, 12, 40}};
    for (const auto& ring : std::vector<std::vector<std::uint32_t>>{{0, 3, 2, 1},
                                                                    {0, 10, 13, 9, 6, 3},
                                                                    {0, 1, 4, 7, 11, 10},
                                                                    {1, 2, 5, 4},
                                                                    {2, 3, 6, 5},
                                                                    {7, 4, 5, 6, 9, 8},
                                                                    {7, 8, 12, 11},
                                                                    {8, 9, 13, 12},
                                                                    {10, 11, 12, 13}}) {
        add_face(mesh, {ring});
    }
    add_octahedron(mesh); // of six times the volume 8 * 10^3
    for (unsigned seed = 0; seed < 20; ++seed) {
        EXPECT_EQ(volume6(disoriented(mesh, seed)), box6(20) + 6 * 2 * 2 * 10 - 8000);
    }
}

// The thirteen dark cubes of a chequered block of 27. All edges of the middle one have four facets: only the
// file's own vertices say which of them are its.
TEST(Orient, SheetsThatTouchAreToldApartByTheirVertices) {
    Mesh mesh;
    for (unsigned i = 0; i < 27; ++i) {
        const unsigned at[3] = {i % 3, i / 3 % 3, i / 9};
        if ((at[0] + at[1] + at[2]) % 2 == 0) continue;
        add_box(mesh, {10.0 * at[0], 10.0 * at[1], 10.0 * at[2]},
                {10.0 * at[0] + 10, 10.0 * at[1] + 10, 10.0 * at[2] + 10});
    }
    for (unsigned seed = 0; seed < 20; ++seed) {
        const IntegerSolid solid = quantize(disoriented(mesh, seed), lattice_cube());
        EXPECT_NO_THROW(check_or_throw(solid));
        EXPECT_EQ(topology(solid).volume6, 13 * box6(10));
        EXPECT_EQ(solid.vertices.size(), 4U * 4U * 4U - 8U); // the block's corners are light cubes'
        EXPECT_EQ(solid.welded_vertices, 13U * 8U - 56U);
    }
}

// An octahedron stands with all its corners on the sides of a box around it. The box's corners are clear of
// it, but whether it is inside cannot be seen at a corner.
TEST(Orient, RefusesShellsThatTouchWithAllTheirCorners) {
    Mesh mesh;
    add_box(mesh, {10, 10, 10}, {30, 30, 30});
    add_octahedron(mesh);
    mesh.oriented = false;
    EXPECT_THROW(quantize(mesh, lattice_cube()), BadInput);
}

TEST(Orient, NestingIsDecidedBesideSlantedFaces) {
    // A box in the empty corner of a tetrahedron's bounding box, beyond its slanted face, and one within.
    Mesh mesh;
    mesh.vertices = {{100, 100, 100}, {160, 100, 100}, {100, 160, 100}, {100, 100, 160}};
    for (const auto& ring :
         std::vector<std::vector<std::uint32_t>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        add_face(mesh, {ring});
    }
    const double tetrahedron6 = 60.0 * 60 * 60;
    Mesh beyond = mesh;
    add_box(beyond, {120, 120, 120}, {130, 130, 130}); // its low corner is on the slanted plane
    EXPECT_EQ(volume6(disoriented(beyond, 4)), tetrahedron6 + box6(10));
    Mesh within = mesh;
    add_box(within, {110, 110, 110}, {120, 120, 120}); // its high corner is on it
    EXPECT_EQ(volume6(disoriented(within, 5)), tetrahedron6 - box6(10));
}

TEST(Orient, HolesOfFacetsAreFoundByNesting) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const IntegerSolid solid = quantize(disoriented(plate_with_holes(4), seed), lattice_cube());
        EXPECT_NO_THROW(check_or_throw(solid));
        const Topology t = topology(solid);
        EXPECT_EQ(t.faces, 2U + 5U * 4U);
        EXPECT_EQ(t.hole_rings, 8U);
        EXPECT_EQ(t.genus, 4);
        EXPECT_EQ(t.volume6, 6 * 10 * (140.0 * 40 - 4 * 20 * 20)); // thickness 10
    }
}

TEST(Orient, AFacetOfSeveralOutlinesIsSplit) {
    // Two columns whose tops are one facet.
    Mesh mesh;
    add_box(mesh, {10, 10, 10}, {30, 30, 30});
    add_box(mesh, {50, 10, 10}, {60, 20, 30});
    Mesh joined;
    joined.oriented = false;
    joined.vertices = mesh.vertices;
    std::vector<std::vector<std::uint32_t>> tops;
    for (std::uint32_t face = 0; face < 12; ++face) {
        const auto ring = mesh.corners.begin() + 4 * static_cast<std::ptrdiff_t>(face);
        if (face % 6 == 5) {
            tops.emplace_back(ring, ring + 4);
        } else {
            add_face(joined, {{ring, ring + 4}});
        }
    }
    std::reverse(tops[1].begin(), tops[1].end());
    add_face(joined, tops);
    const IntegerSolid solid = quantize(joined, lattice_cube());
    EXPECT_EQ(solid.input_faces, 11U);
    EXPECT_EQ(solid.face_count(), 12U);
    EXPECT_NO_THROW(check_or_throw(solid));
    EXPECT_EQ(topology(solid).volume6, box6(20) + 6 * 10 * 10 * 20);
}

TEST(Orient, IslandsInHolesOfAFacet) {
    // A square tube around a post: at both ends one facet with three rings.
    Mesh mesh;
    mesh.oriented = false;
    const double rings[3][2] = {{10, 90}, {20, 80}, {40, 60}};
    for (const auto& ring : rings) {
        for (const double z : {10.0, 50.0}) {
            mesh.vertices.push_back({ring[0], ring[0], z});
            mesh.vertices.push_back({ring[1], ring[0], z});
            mesh.vertices.push_back({ring[1], ring[1], z});
            mesh.vertices.push_back({ring[0], ring[1], z});
        }
    }
    add_face(mesh, {{0, 1, 2, 3}, {16, 17, 18, 19}, {8, 9, 10, 11}});
    add_face(mesh, {{12, 13, 14, 15}, {20, 21, 22, 23}, {4, 5, 6, 7}});
    for (const std::uint32_t base : {0U, 8U, 16U}) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t k = (i + 1) % 4;
            add_face(mesh, {{base + i, base + k, base + 4 + k, base + 4 + i}});
        }
    }
    const IntegerSolid solid = quantize(disoriented(mesh, 7), lattice_cube());
    EXPECT_NO_THROW(check_or_throw(solid));
    const Topology t = topology(solid);
    EXPECT_EQ(t.faces, 2U * 2U + 12U);
    EXPECT_EQ(t.shells, 2U);
    EXPECT_EQ(t.genus, 1); // the tube's
    EXPECT_EQ(t.volume6, 6 * 40 * (80.0 * 80 - 60 * 60 + 20 * 20));
}

std::string refusal(const Mesh& mesh) {
    try {
        quantize(mesh, lattice_cube());
    } catch (const BadInput& fault) {
        return fault.what();
    }
    return "";
}

TEST(Orient, Refusals) {
    Mesh open;
    add_box(open, {10, 10, 10}, {20, 20, 20});
    open.face_rings.pop_back();
    open.ring_starts.pop_back();
    open.corners.resize(20);
    open.oriented = false;
    EXPECT_EQ(refusal(open).rfind("the surface is not closed: only one facet has edge (", 0), 0U);

    Mesh inner; // two boxes with a common facet, which belongs to neither surface
    add_box(inner, {10, 10, 10}, {20, 20, 20});
    add_box(inner, {20, 10, 10}, {30, 20, 20});
    inner.corners.erase(inner.corners.begin() + 24,
                        inner.corners.begin() + 28); // the second's face at x = 20
    inner.ring_starts.pop_back();
    inner.face_rings.pop_back();
    inner.oriented = false;
    EXPECT_EQ(refusal(inner).rfind("which facets belong together cannot be told at edge (20 ", 0), 0U);

    Mesh doubled; // a facet whose two polygons are the same
    add_box(doubled, {10, 10, 10}, {20, 20, 20});
    doubled.corners.insert(doubled.corners.begin(), doubled.corners.begin(), doubled.corners.begin() + 4);
    doubled.ring_starts.push_back(28);
    for (std::size_t i = 1; i < doubled.face_rings.size(); ++i) ++doubled.face_rings[i];
    doubled.oriented = false;
    EXPECT_EQ(refusal(doubled), "two polygons of facet 0 (counted from 0) coincide");
}

// Six vertices, ten triangles, every edge in two of them: the projective plane, which has no two sides.
TEST(Orient, RefusesASurfaceWithOneSide) {
    Mesh mesh;
    mesh.vertices = {{10, 10, 10}, {90, 10, 17}, {40, 80, 10}, {40, 30, 90}, {70, 75, 60}, {15, 60, 55}};
    for (const auto& ring : std::vector<std::vector<std::uint32_t>>{{0, 1, 2},
                                                                    {0, 2, 3},
                                                                    {0, 3, 4},
                                                                    {0, 4, 5},
                                                                    {0, 5, 1},
                                                                    {1, 2, 4},
                                                                    {2, 3, 5},
                                                                    {3, 4, 1},
                                                                    {4, 5, 2},
                                                                    {5, 1, 3}}) {
        add_face(mesh, {ring});
    }
    mesh.oriented = false;
    EXPECT_EQ(refusal(mesh).rfind("the surface has one side only", 0), 0U) << refusal(mesh);
}

} // namespace
} // namespace osem::host
