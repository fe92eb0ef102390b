// The oracle itself, on cases small enough to know by hand.
#include <gtest/gtest.h>

#include "exact_solid.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

const osem::Octant octant_at_8_8_8{{{8 << 15, 8 << 15, 8 << 15}}, 2}; // small coordinates 8 to 16

TEST(ExactSolid, TouchingIsNotMeeting) {
    EXPECT_FALSE(ExactSolid(box(aligned_grid, {8, 8, 8}, {16, 16, 16}).view()).meets_open(octant_at_8_8_8));
    EXPECT_FALSE(ExactSolid(box(aligned_grid, {16, 8, 8}, {20, 16, 16}).view()).meets_open(octant_at_8_8_8));
    EXPECT_FALSE(ExactSolid(box(aligned_grid, {0, 0, 0}, {32, 32, 32}).view()).meets_open(octant_at_8_8_8));
    EXPECT_TRUE(ExactSolid(box(aligned_grid, {8, 8, 8}, {16, 16, 15}).view()).meets_open(octant_at_8_8_8));
    EXPECT_TRUE(ExactSolid(box(aligned_grid, {15, 8, 8}, {20, 16, 16}).view()).meets_open(octant_at_8_8_8));
}

TEST(ExactSolid, PlaneThroughThreeCornersMeets) {
    const auto g = aligned_grid;
    const TestSolid cut = tetrahedron(g(0, 0, 0), g(32, 0, 0), g(0, 32, 0), g(0, 0, 32));
    EXPECT_TRUE(ExactSolid(cut.view()).meets_open(octant_at_8_8_8)); // x + y + z = 32, corners at 24 and 48
    const TestSolid beside = tetrahedron(g(0, 0, 0), g(24, 0, 0), g(0, 24, 0), g(0, 0, 24));
    EXPECT_FALSE(ExactSolid(beside.view()).meets_open(octant_at_8_8_8)); // touches the corner (8, 8, 8)
}

TEST(ExactSolid, HoleCoversOctant) {
    const FlatRing outer = {{1, 1}, {31, 1}, {31, 31}, {1, 31}};
    const FlatRing hole = {{8, 8}, {8, 16}, {16, 16}, {16, 8}};
    const TestSolid plate = prism(aligned_grid, osem::axis_z, {outer, hole}, 10, 12);
    const ExactSolid exact(plate.view());
    EXPECT_FALSE(exact.meets_open(octant_at_8_8_8));
    EXPECT_EQ(exact.winding(centre_of(octant_at_8_8_8)), 0);
    EXPECT_EQ(exact.winding(exact_point(aligned_grid(4, 11, 11))), 1);
}

TEST(ExactSolid, WindingNumbers) {
    TestSolid shells = box(aligned_grid, {2, 2, 2}, {30, 30, 30});
    shells.add(box(aligned_grid, {8, 8, 8}, {16, 16, 16}));
    EXPECT_EQ(ExactSolid(shells.view()).winding(centre_of(octant_at_8_8_8)), 2);
    EXPECT_EQ(ExactSolid(shells.view()).winding(exact_point(aligned_grid(1, 20, 20))), 0);
    shells.invert();
    EXPECT_EQ(ExactSolid(shells.view()).winding(centre_of(octant_at_8_8_8)), -2);

    const FlatRing pentagram = {{16, 30}, {8, 5}, {29, 20}, {3, 20}, {24, 5}};
    const TestSolid star = prism(aligned_grid, osem::axis_x, {pentagram}, 4, 20);
    const ExactSolid exact(star.view());
    EXPECT_EQ(exact.winding(exact_point(aligned_grid(10, 16, 16))), 2);
    EXPECT_EQ(exact.winding(exact_point(aligned_grid(10, 16, 27))), 1);
    EXPECT_EQ(exact.winding(exact_point(aligned_grid(10, 4, 28))), 0);
}

TEST(ExactSolid, PerturbedCentreOnAFace) {
    // The plane x = 12 halves the octant: the perturbed centre is just above it.
    const osem::Octant& octant = octant_at_8_8_8;
    const TestSolid above = box(aligned_grid, {12, 8, 8}, {16, 16, 16});
    const TestSolid below = box(aligned_grid, {8, 8, 8}, {12, 16, 16});
    EXPECT_EQ(ExactSolid(above.view()).winding(perturbed_centre_of(octant)), 1);
    EXPECT_EQ(ExactSolid(below.view()).winding(perturbed_centre_of(octant)), 0);
}

TEST(ExactSolid, ZeroAreaFaceIsItsRing) {
    TestSolid specks;
    specks.add_face({{aligned_grid(0, 12, 12), aligned_grid(32, 12, 12), aligned_grid(0, 12, 12)}});
    EXPECT_TRUE(ExactSolid(specks.view()).meets_open(octant_at_8_8_8));
    TestSolid beside;
    beside.add_face({{aligned_grid(0, 8, 12), aligned_grid(32, 8, 12), aligned_grid(0, 8, 12)}});
    EXPECT_FALSE(ExactSolid(beside.view()).meets_open(octant_at_8_8_8));
    TestSolid point;
    point.add_face({{aligned_grid(9, 9, 9), aligned_grid(9, 9, 9), aligned_grid(9, 9, 9)}});
    EXPECT_TRUE(ExactSolid(point.view()).meets_open(octant_at_8_8_8));
}

} // namespace

} // namespace oracle
