// From file coordinates to the lattice: the cube, welding, collapsed and bent faces, and what is refused.
#include "mesh/quantize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "builders.hpp"
#include "mesh/topology.hpp"
#include "mesh/write_off.hpp"

namespace osem::host {
namespace {

template <class Work>
std::string refusal(Work work) {
    try {
        work();
    } catch (const BadInput& fault) {
        return fault.what();
    }
    return "";
}

Mesh box(std::array<double, 3> low, std::array<double, 3> high) {
    Mesh mesh;
    add_box(mesh, low, high);
    return mesh;
}

TEST(DefaultCube, FollowsItsRule) {
    // Extent 15: 17/16 of it is 15.9375, so side 16; centre (7.5, 0, 100.5); step 16/1024 = 1/64.
    const WorldCube cube = default_cube(box({0, -1, 100}, {15, 1, 101}));
    EXPECT_EQ(cube.side, 16);
    EXPECT_EQ(cube.origin, (std::array<double, 3>{-0.5, -8, 92.5}));
    EXPECT_EQ(default_cube(box({0, 0, 0}, {16, 1, 1})).side, 32);              // 17/16 of 16 is 17
    EXPECT_EQ(default_cube(box({0, 0, 0}, {256.0 / 17, 1, 1})).side, 16);      // 17/16 of it is 16
    EXPECT_EQ(default_cube(box({0, 0, 0}, {0.0078125, 0, 0})).side, 0.015625); // below 1 too
    // Centre 0.005 + 7.5: the origin -0.495 goes down to the next multiple of 1/64, -32/64.
    EXPECT_EQ(default_cube(box({0.005, 0, 0}, {15.005, 1, 1})).origin[0], -0.5);
}

TEST(DefaultCube, Refusals) {
    EXPECT_THROW(default_cube(Mesh{}), BadInput);
    EXPECT_THROW(default_cube(box({1, 1, 1}, {1, 1, 1})), BadInput);
    EXPECT_THROW(default_cube(box({0, 0, 0}, {HUGE_VAL, 1, 1})), BadInput);
}

TEST(Quantize, RoundsHalvesUpAndKeepsTheFileCoordinates) {
    // Cells of 4: 8 + 4k + 2 is a half.
    const WorldCube cube{{8, 8, 8}, 4.0 * root_side};
    const IntegerSolid solid = quantize(box({10, 9.9, 8}, {8 + 4.0 * root_side, 17.999, 1000}), cube);
    ASSERT_EQ(solid.vertices.size(), 8U);
    const auto [low, high] =
        std::make_pair(solid.corners[0], solid.corners[6]); // vertices 0 and 7 of the box
    EXPECT_EQ(solid.vertices[low], (Point{{1, 0, 0}}));
    EXPECT_EQ(solid.vertices[high], (Point{{root_side, 2, 248}}));
    EXPECT_EQ(solid.file_coordinates[low], (std::array<double, 3>{10, 9.9, 8}));
}

TEST(Quantize, Refusals) {
    const Mesh mesh = box({1, 1, 1}, {5, 5, 5});
    const auto quantized = [&](const WorldCube& cube) { return refusal([&] { quantize(mesh, cube); }); };
    EXPECT_EQ(quantized({{1, 1, 1}, 4}), "");
    EXPECT_EQ(quantized({{1, 1, 1}, 3.5}),
              "vertex 4 (counted from 0) at (1 1 5) lies outside the world cube, (1 1 1) to (4.5 4.5 4.5)");
    EXPECT_EQ(quantized({{1.5, 0, 0}, 8}).rfind("vertex 0 (counted from 0) at (1 1 1) lies outside", 0), 0U);
    EXPECT_NE(quantized({{0, 0, 0}, 0}), "");
    EXPECT_NE(quantized({{0, 0, 0}, -8}), "");
    EXPECT_NE(quantized({{0, NAN, 0}, 8}), "");
    Mesh infinite = mesh;
    infinite.vertices[3][1] = HUGE_VAL;
    EXPECT_EQ(refusal([&] {
                  quantize(infinite, {{0, 0, 0}, 8});
              }),
              "vertex 3 (counted from 0) at (5 inf 1) is not finite");
}

TEST(Quantize, VerticesThatNoFaceUsesAreIgnored) {
    Mesh mesh = box({1, 1, 1}, {5, 5, 5});
    mesh.vertices.push_back({1e300, 0, 0});
    const IntegerSolid solid = quantize(mesh, {{0, 0, 0}, 8});
    EXPECT_EQ(solid.input_vertices, 9U);
    EXPECT_EQ(solid.vertices.size(), 8U);
    EXPECT_EQ(solid.welded_vertices, 0U);
}

// A box whose faces do not share vertices in the file.
TEST(Quantize, WeldsASoupOfFaces) {
    const Mesh whole = box({10, 20, 30}, {40, 50, 60});
    Mesh soup;
    for (std::uint32_t face = 0; face < 6; ++face) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
            soup.vertices.push_back(whole.vertices[whole.corners[4 * face + i]]);
        }
        soup.end_ring();
        soup.end_face();
    }
    const IntegerSolid solid = quantize(soup, lattice_cube());
    EXPECT_EQ(solid.vertices.size(), 8U);
    EXPECT_EQ(solid.welded_vertices, 16U);
    EXPECT_NO_THROW(check_or_throw(solid));
}

TEST(Quantize, CollapsedFacesGoAndTheSurfaceStaysClosed) {
    // Thinner than half a cell: the four walls collapse, top and bottom fall on each other.
    const IntegerSolid flat = quantize(box({10, 10, 10}, {20, 20, 10.25}), lattice_cube());
    EXPECT_EQ(flat.input_faces, 6U);
    EXPECT_EQ(flat.dropped_faces, 4U);
    EXPECT_EQ(flat.face_count(), 2U);
    EXPECT_EQ(flat.welded_vertices, 4U);
    EXPECT_NO_THROW(check_or_throw(flat));

    const IntegerSolid speck = quantize(box({10, 10, 10}, {10.1, 10.1, 10.1}), lattice_cube());
    EXPECT_EQ(speck.dropped_faces, 6U);
    EXPECT_THROW(check_or_throw(speck), BadInput);
}

TEST(Quantize, TrianglesWithoutAreaStay) {
    // A tetrahedron whose edge 0 - 1 is split at 4 in one of its faces only; a triangle without area fills
    // in.
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {0, 0, 20}, {10, 0, 0}};
    for (const auto& ring : std::vector<std::vector<std::uint32_t>>{
             {0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 1}}) {
        add_face(mesh, {ring});
    }
    const IntegerSolid solid = quantize(mesh, lattice_cube());
    EXPECT_EQ(solid.dropped_faces, 0U);
    EXPECT_EQ(solid.face_count(), 6U);
    EXPECT_NO_THROW(check_or_throw(solid));
}

TEST(Quantize, BentPolygonsBecomeTrianglesAndTheSurfaceStaysClosed) {
    Mesh mesh = box({10, 10, 10}, {30, 30, 30});
    mesh.vertices[7] = {31, 32, 33}; // the three faces there are no longer planar
    const IntegerSolid solid = quantize(mesh, lattice_cube());
    EXPECT_EQ(solid.triangulated_faces, 3U);
    EXPECT_EQ(solid.face_count(), 3U + 3U * 2U);
    EXPECT_NO_THROW(check_or_throw(solid));
    EXPECT_TRUE(boundary(solid.view()).empty());
}

// Corners moved up and down bend top and bottom of the plate; its walls stay in their vertical planes.
TEST(Quantize, BentFacesWithHoles) {
    Mesh mesh = plate_with_holes(3);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 5) mesh.vertices[i][2] += 1;
    const IntegerSolid solid = quantize(mesh, lattice_cube());
    EXPECT_EQ(solid.triangulated_faces, 2U);
    EXPECT_NO_THROW(check_or_throw(solid));
    EXPECT_EQ(topology(solid).genus, 3); // no triangulation can change what the surface is
}

TEST(Quantize, TriangleMeshesNeedNoRingTables) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {0, 0, 20}};
    for (const auto& ring :
         std::vector<std::vector<std::uint32_t>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        add_face(mesh, {ring});
    }
    EXPECT_TRUE(quantize(mesh, lattice_cube()).view().is_triangle_mesh());
    EXPECT_FALSE(quantize(box({1, 1, 1}, {2, 2, 2}), lattice_cube()).view().is_triangle_mesh());
}

TEST(CheckOrThrow, NamesAnOpenEdgeInTheFilesCoordinates) {
    Mesh mesh = box({0.5, 1, 2}, {1.5, 2, 3});
    mesh.corners.resize(4); // only the face at x = 0.5
    mesh.ring_starts = {0, 4};
    mesh.face_rings = {0, 1};
    const IntegerSolid solid = quantize(mesh, {{0, 0, 0}, 4});
    const std::string what = refusal([&] { check_or_throw(solid); });
    EXPECT_EQ(what.rfind("surface is not closed: edge (0.5 ", 0), 0U) << what;
    const std::string end = " is used once one way and never the other: a gap, a crack or a T-junction";
    EXPECT_NE(what.find(end), std::string::npos) << what;
}

TEST(CheckOrThrow, TellsAFaceTurnedOver) {
    Mesh mesh = box({1, 1, 1}, {2, 2, 2});
    std::reverse(mesh.corners.begin(), mesh.corners.begin() + 4);
    const IntegerSolid solid = quantize(mesh, lattice_cube());
    const std::string what = refusal([&] { check_or_throw(solid); });
    const std::string end = " is used 2 times one way and never the other: a face is turned over";
    EXPECT_NE(what.find(end), std::string::npos) << what;
}

TEST(CheckOrThrow, NamesEveryCauseOfAnEdgeUsedThreeTimes) {
    Mesh mesh = box({1, 1, 1}, {2, 2, 2});
    const std::vector<std::uint32_t> twice(mesh.corners.begin(), mesh.corners.begin() + 4);
    add_face(mesh, {twice});
    const IntegerSolid solid = quantize(mesh, lattice_cube());
    const std::string what = refusal([&] { check_or_throw(solid); });
    const std::string end =
        " is used 2 times one way and once the other: a gap, a crack, a T-junction or a face turned over";
    EXPECT_NE(what.find(end), std::string::npos) << what;
}

TEST(WriteOff, KeepsPolygonsAndTriangulatesFacesWithHoles) {
    const IntegerSolid solid = quantize(plate_with_holes(2), lattice_cube());
    std::ostringstream out;
    write_off(out, solid);
    std::istringstream in(out.str());
    std::string keyword;
    std::uint32_t vertices = 0;
    std::uint32_t faces = 0;
    std::uint32_t edges = 0;
    in >> keyword >> vertices >> faces >> edges;
    EXPECT_EQ(keyword, "OFF");
    EXPECT_EQ(vertices, 24U);
    // 12 walls; each end has 12 corners and 2 holes, so 12 + 2 * 2 - 2 triangles.
    ASSERT_EQ(faces, 12U + 2U * 14U);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        Point p{};
        in >> p.at[0] >> p.at[1] >> p.at[2];
        EXPECT_EQ(p, solid.vertices[i]);
    }
    Chain chain;
    for (std::uint32_t i = 0; i < faces; ++i) {
        std::vector<std::uint32_t> ring;
        std::uint32_t count = 0;
        in >> count;
        ASSERT_TRUE(in && count >= 3 && count <= 4);
        ring.resize(count);
        for (auto& corner : ring) in >> corner;
        add_ring_edges(chain, ring.data(), ring.size());
    }
    EXPECT_TRUE(chain.empty());
    std::string rest;
    EXPECT_FALSE(in >> rest);
}

} // namespace
} // namespace osem::host
