// Counts, shells, genus and volume of surfaces whose numbers follow from how they are made.
#include "mesh/topology.hpp"

#include <gtest/gtest.h>

#include "builders.hpp"
#include "mesh/volume.hpp"

namespace osem::host {
namespace {

Topology topology_of(const Mesh& mesh) { return topology(quantize(mesh, lattice_cube())); }

TEST(Topology, Cube) {
    Mesh mesh;
    add_box(mesh, {1, 2, 3}, {11, 22, 33});
    const Topology t = topology_of(mesh);
    EXPECT_EQ(t.faces, 6U);
    EXPECT_EQ(t.rings, 6U);
    EXPECT_EQ(t.hole_rings, 0U);
    EXPECT_EQ(t.vertices, 8U);
    EXPECT_EQ(t.edges, 12U);
    EXPECT_EQ(t.shells, 1U);
    EXPECT_TRUE(t.manifold);
    EXPECT_EQ(t.genus, 0);
    EXPECT_EQ(t.volume6, 6 * 10 * 20 * 30);
}

TEST(Topology, PlateWithHoles) {
    for (std::uint32_t holes = 0; holes < 6; ++holes) {
        const Topology t = topology_of(plate_with_holes(holes));
        EXPECT_EQ(t.faces, 2 + 4 * (holes + 1));
        EXPECT_EQ(t.hole_rings, 2 * holes);
        EXPECT_EQ(t.edges, 12 * (holes + 1));
        EXPECT_EQ(t.shells, 1U);
        EXPECT_EQ(t.genus, std::int64_t{holes});
        EXPECT_EQ(t.volume6, 6 * 10 * ((30.0 * holes + 20) * 40 - holes * 400.0));
    }
}

TEST(Topology, TwoShells) {
    Mesh mesh;
    add_box(mesh, {1, 1, 1}, {10, 10, 10});
    add_box(mesh, {20, 1, 1}, {30, 10, 10});
    const Topology t = topology_of(mesh);
    EXPECT_EQ(t.shells, 2U);
    EXPECT_TRUE(t.manifold);
    EXPECT_EQ(t.genus, 0);
}

TEST(Topology, EdgeWithFourFacesIsNotManifold) {
    Mesh mesh;
    add_box(mesh, {10, 10, 10}, {20, 20, 20});
    add_box(mesh, {20, 20, 10}, {30, 30, 20});
    const Topology t = topology_of(mesh);
    EXPECT_EQ(t.vertices, 14U);
    EXPECT_EQ(t.edges, 23U);
    EXPECT_EQ(t.shells, 1U); // joined by that edge
    EXPECT_FALSE(t.manifold);
    EXPECT_FALSE(t.genus.has_value());
}

TEST(Topology, VertexWithTwoFansIsNotManifold) {
    Mesh mesh;
    add_box(mesh, {10, 10, 10}, {20, 20, 20});
    add_box(mesh, {20, 20, 20}, {30, 30, 30});
    const Topology t = topology_of(mesh);
    EXPECT_EQ(t.vertices, 15U);
    EXPECT_EQ(t.edges, 24U);
    EXPECT_EQ(t.shells, 2U);
    EXPECT_FALSE(t.manifold);
    EXPECT_FALSE(t.genus.has_value());
}

TEST(Topology, OpenOrDisagreeingFacesAreNotManifold) {
    Mesh open;
    add_box(open, {10, 10, 10}, {20, 20, 20});
    Mesh turned = open;
    std::swap(turned.corners[1], turned.corners[3]); // the first face the other way round
    EXPECT_FALSE(topology_of(turned).manifold);
    open.face_rings.pop_back();
    open.ring_starts.pop_back();
    open.corners.resize(20);
    EXPECT_FALSE(topology_of(open).manifold);
}

TEST(Topology, WholeLatticeManyTimes) {
    // Sixteen times the root's surface: six times the volume is 16 * 6 * 2^60, past 64 bits.
    Mesh mesh;
    for (int i = 0; i < 16; ++i) add_box(mesh, {0, 0, 0}, {root_side, root_side, root_side});
    EXPECT_EQ(topology_of(mesh).volume6, 96 * static_cast<double>(root_volume));
}

TEST(WideSum, AddsBothWaysAcrossTheWords) {
    WideSum sum;
    EXPECT_EQ(sum.value(), 0);
    sum.add(-1);
    EXPECT_EQ(sum.value(), -1);
    EXPECT_TRUE(sum < WideSum{});
    for (int i = 0; i < 4; ++i) sum.add(INT64_MIN);
    EXPECT_EQ(sum.value(), -36893488147419103232.0); // -2^65 - 1, rounded
    for (int i = 0; i < 4; ++i) sum.add(INT64_MAX);
    EXPECT_EQ(sum.value(), -5);
    sum.add(5);
    EXPECT_FALSE(sum < WideSum{});
    EXPECT_FALSE(WideSum{} < sum);
    for (int i = 0; i < 3; ++i) sum.add(INT64_MAX);
    EXPECT_EQ(sum.value(), 27670116110564327424.0); // 3 * 2^63 - 3, rounded
    EXPECT_TRUE(WideSum{} < sum);
}

} // namespace
} // namespace osem::host
