// Solids broken on purpose: check must refuse them for the right reason and at the right place. Whether a
// surface is closed or a face planar is found out here by other means than the kernel's.
#include <gtest/gtest.h>

#include <random>

#include "broken_solids.hpp"
#include "converted.hpp"
#include "directed_edges.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

std::vector<TestSolid> sound_solids() {
    std::vector<TestSolid> solids = library(crooked_grid);
    for (TestSolid& solid : random_solids(aligned_grid, 20, 5000)) solids.push_back(std::move(solid));
    return solids;
}

void expect_cycle_decided(const TestSolid& broken) {
    const osem::Solid solid = broken.view();
    const DirectedEdges edges(solid);
    const osem::CheckOutcome outcome = checked(solid);
    if (edges.closed()) {
        EXPECT_EQ(outcome.status, osem::Status::ok) << broken.name;
        return;
    }
    EXPECT_EQ(outcome.status, osem::Status::surface_not_closed) << broken.name;
    EXPECT_TRUE(edges.has(outcome.edge)) << broken.name;
    EXPECT_GT(edges.excess(solid, outcome.edge), 0) << broken.name;
}

TEST(CheckOracle, SoundSolidsAreAccepted) {
    for (const TestSolid& solid : sound_solids()) {
        EXPECT_TRUE(DirectedEdges(solid.view()).closed()) << solid.name;
        EXPECT_EQ(checked(solid.view()).status, osem::Status::ok) << solid.name;
        EXPECT_EQ(checked(solid.view_with_tables()).status, osem::Status::ok) << solid.name;
    }
}

TEST(CheckOracle, FaceRemovedOrTurned) {
    for (const TestSolid& solid : sound_solids()) {
        for (std::uint32_t f = 0; f < solid.view().face_count; ++f) {
            expect_cycle_decided(rebuilt(solid, f, false));
            expect_cycle_decided(rebuilt(solid, f, true));
        }
    }
}

TEST(CheckOracle, VertexMoved) {
    std::mt19937 random(7);
    std::uint32_t not_planar = 0;
    for (const TestSolid& solid : sound_solids()) {
        for (std::size_t v = 0; v < solid.vertices.size(); ++v) {
            TestSolid moved = solid;
            std::int32_t& coordinate = moved.vertices[v].at[random() % 3U];
            coordinate += coordinate < osem::root_side ? 1 : -1;
            const osem::Solid view = moved.view();
            std::uint32_t first = 0;
            while (first < view.face_count && is_planar(view, first)) ++first;
            if (first == view.face_count) {
                expect_cycle_decided(moved);
                continue;
            }
            ++not_planar;
            const osem::CheckOutcome outcome = checked(view);
            ASSERT_EQ(outcome.status, osem::Status::face_not_planar) << solid.name << ", vertex " << v;
            EXPECT_EQ(outcome.face, first) << solid.name << ", vertex " << v;
            ASSERT_TRUE(view.first_ring(first) <= outcome.ring && outcome.ring < view.end_ring(first));
            ASSERT_TRUE(view.first_corner(outcome.ring) <= outcome.corner &&
                        outcome.corner < view.first_corner(outcome.ring + 1));
            EXPECT_EQ(outcome.vertex, view.corners[outcome.corner]);
        }
    }
    EXPECT_GT(not_planar, 100U);
}

TEST(CheckOracle, CoordinateOffLattice) {
    for (const TestSolid& solid : sound_solids()) {
        for (const std::int32_t value : {-1, osem::root_side + 1, INT32_MIN, INT32_MAX}) {
            TestSolid moved = solid;
            const std::size_t v = moved.vertices.size() / 2;
            moved.vertices[v].at[v % 3] = value;
            const osem::CheckOutcome outcome = checked(moved.view());
            EXPECT_EQ(outcome.status, osem::Status::coordinate_off_lattice) << solid.name << ", " << value;
            EXPECT_EQ(outcome.vertex, v) << solid.name;
        }
    }
}

TEST(CheckOracle, IndexOutOfRange) {
    for (const TestSolid& solid : sound_solids()) {
        TestSolid broken = solid;
        const std::size_t corner = broken.corners.size() / 2;
        broken.corners[corner] = static_cast<std::uint32_t>(broken.vertices.size());
        const osem::Solid view = broken.view();
        const osem::CheckOutcome outcome = checked(view);
        EXPECT_EQ(outcome.status, osem::Status::index_out_of_range) << solid.name;
        EXPECT_EQ(outcome.corner, corner) << solid.name;
        EXPECT_EQ(outcome.vertex, broken.vertices.size()) << solid.name;
        EXPECT_TRUE(view.first_ring(outcome.face) <= outcome.ring &&
                    outcome.ring < view.end_ring(outcome.face));
        EXPECT_TRUE(view.first_corner(outcome.ring) <= corner &&
                    corner < view.first_corner(outcome.ring + 1));
    }
}

TEST(CheckOracle, ShortRingAndBadTables) {
    for (const TestSolid& solid : sound_solids()) {
        const std::uint32_t rings = static_cast<std::uint32_t>(solid.ring_starts.size() - 1);
        for (std::uint32_t r = 0; r < rings; ++r) {
            TestSolid broken = solid;
            broken.ring_starts[r + 1] = broken.ring_starts[r] + 2;
            const osem::CheckOutcome outcome = checked(broken.view_with_tables());
            EXPECT_EQ(outcome.status, osem::Status::ring_too_short) << solid.name << ", ring " << r;
            EXPECT_EQ(outcome.ring, r) << solid.name;
        }
        TestSolid descending = solid;
        descending.ring_starts[rings] = descending.ring_starts[rings - 1] - 1;
        EXPECT_EQ(checked(descending.view_with_tables()).status, osem::Status::ring_table_invalid);
        TestSolid overrunning = solid;
        overrunning.ring_starts[rings] += 1;
        EXPECT_EQ(checked(overrunning.view_with_tables()).status, osem::Status::ring_table_invalid);
        TestSolid without_ring = solid;
        without_ring.face_rings.push_back(rings);
        EXPECT_EQ(checked(without_ring.view_with_tables()).status, osem::Status::ring_table_invalid);
    }
}

TEST(CheckOracle, CrackAtTJunction) {
    TestSolid solid = rebuilt(box(aligned_grid, {5, 5, 5}, {21, 21, 21}), 4, false);
    const auto p = [](int x, int y) { return aligned_grid(x, y, 21); };
    solid.add_face({{p(5, 5), p(12, 5), p(5, 21)}});
    solid.add_face({{p(12, 5), p(21, 5), p(21, 21)}});
    solid.add_face({{p(12, 5), p(21, 21), p(5, 21)}});
    EXPECT_FALSE(DirectedEdges(solid.view()).closed());
    expect_cycle_decided(solid);
    solid.add_face({{p(5, 5), p(21, 5), p(12, 5)}});
    EXPECT_TRUE(DirectedEdges(solid.view()).closed());
    expect_cycle_decided(solid);
}

TEST(CheckOracle, ScratchTooSmall) {
    const TestSolid solid = box(aligned_grid, {5, 5, 5}, {21, 21, 21});
    std::vector<osem::Edge> scratch(osem::check_scratch(solid.view()));
    const auto size = static_cast<std::uint32_t>(scratch.size());
    EXPECT_EQ(osem::check(solid.view(), scratch.data(), size - 1).status, osem::Status::scratch_too_small);
    EXPECT_EQ(osem::check(solid.view(), scratch.data(), size).status, osem::Status::ok);
}

} // namespace

} // namespace oracle
