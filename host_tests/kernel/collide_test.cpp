// Two trees, one moved, against all pairs of their cells.
#include "osem/collide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "osem/query.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/leaf_list.hpp"
#include "support/query_oracles.hpp"

namespace osem::tests {

namespace {

bool is_leaf_of(const Octree& tree, const Leaf& leaf) {
    return same_leaf(leaf_at(tree, leaf.octant.corner).leaf, leaf);
}

::testing::AssertionResult agrees(const CollisionOutcome& found, Contact expected, const Octree& a,
                                  const Octree& b, const Point& offset) {
    if (found.status != Status::ok || found.contact != expected) {
        return ::testing::AssertionFailure()
               << describe(found.status) << ": " << static_cast<int>(found.contact) << ", not "
               << static_cast<int>(expected);
    }
    if (expected == Contact::clear) return ::testing::AssertionSuccess();
    if (!is_leaf_of(a, found.a) || !is_leaf_of(b, found.b) ||
        contact_of(found.a, found.b, offset) != expected) {
        return ::testing::AssertionFailure() << "the leaves named do not meet so";
    }
    return ::testing::AssertionSuccess();
}

Point random_offset(std::mt19937& random) {
    Point offset = {};
    const bool fine = random() % 2 == 0;
    for (std::int32_t& c : offset.at) {
        c = (static_cast<std::int32_t>(random() % 37) - 18) * (root_side / 16);
        if (fine) c += static_cast<std::int32_t>(random() % 3) - 1;
    }
    return offset;
}

DenseGrid dense_grid(std::mt19937& random, int depth) {
    return random_grid(depth, static_cast<std::uint32_t>(random()), three_colours);
}

DenseGrid sparse_grid(std::mt19937& random, int depth) {
    DenseGrid grid(depth);
    for (std::size_t left = 1 + random() % 4; left > 0; --left) {
        grid[random() % grid.size()] = random() % 2 == 0 ? Colour::black : Colour::boundary;
    }
    return grid;
}

TEST(Collision, AgreesWithAllPairsOfCells) {
    std::mt19937 random(51);
    const auto job = std::make_unique<Collision>();
    unsigned counts[4] = {};
    for (int round = 0; round < 250; ++round) {
        const auto depth = [&random] { return 1 + static_cast<int>(random() % 3); };
        const bool sparse = round % 3 != 0;
        const DenseGrid grid_a = sparse ? sparse_grid(random, depth()) : dense_grid(random, depth());
        const DenseGrid grid_b = sparse ? sparse_grid(random, depth()) : dense_grid(random, depth());
        HeapPool pool_a(1000);
        HeapPool pool_b(1000);
        const Octree a = planted(grid_a, *pool_a);
        const Octree b = planted(grid_b, *pool_b);
        const std::vector<Leaf> cells_a = cells_of(grid_a, solid_colours);
        const std::vector<Leaf> cells_b = cells_of(grid_b, solid_colours);
        for (int i = 0; i < 60; ++i) {
            const Point offset = random_offset(random);
            const Contact expected = expected_contact(cells_a, cells_b, offset);
            ASSERT_TRUE(agrees(collide(*job, a, b, offset), expected, a, b, offset)) << round << " " << i;
            const Point back = {{-offset.x(), -offset.y(), -offset.z()}};
            ASSERT_TRUE(agrees(collide(*job, b, a, back), expected, b, a, back)) << round << " " << i;
            ++counts[static_cast<unsigned>(expected)];
        }
    }
    for (const unsigned count : counts) EXPECT_GT(count, 500U); // or the grids have missed the point
}

// All pairs of grids with one cell of depth 1 each, and all offsets by half cells.
TEST(Collision, AllPlacesOfTwoCells) {
    const auto job = std::make_unique<Collision>();
    HeapPool pool(0);
    constexpr std::int32_t step = root_side / 4;
    for (unsigned places = 0; places < 64; ++places) {
        const Octree a = {&*pool, Node::of(static_cast<std::uint8_t>(1U << places % 8), 0, 0), 1};
        const auto in_b = static_cast<std::uint8_t>(1U << places / 8);
        const Octree b = {&*pool, Node::of(in_b, in_b, 0), 1};
        const Leaf leaf_a = {root_octant.child(places % 8), Colour::boundary};
        const Leaf leaf_b = {root_octant.child(places / 8), Colour::black};
        for (int i = 0; i < 9 * 9 * 9; ++i) {
            const Point offset = {{step * (i % 9 - 4), step * (i / 9 % 9 - 4), step * (i / 81 - 4)}};
            ASSERT_TRUE(
                agrees(collide(*job, a, b, offset), contact_of(leaf_a, leaf_b, offset), a, b, offset));
        }
    }
}

// Lone leaves of all depths, moved so that they overlap, touch, or miss by one lattice unit along an axis.
TEST(Collision, EveryDepth) {
    std::mt19937 random(52);
    const auto job = std::make_unique<Collision>();
    for (int round = 0; round < 400; ++round) {
        const int depth_a = 1 + round % max_depth;
        const int depth_b = 1 + round / max_depth;
        HeapPool pool_a(max_depth);
        HeapPool pool_b(max_depth);
        Leaf leaf_a = {};
        Leaf leaf_b = {};
        const Octree a =
            lone_leaf(depth_a, round % 3 == 0 ? Colour::boundary : Colour::black, random, *pool_a, leaf_a);
        const Octree b =
            lone_leaf(depth_b, round % 7 == 0 ? Colour::boundary : Colour::black, random, *pool_b, leaf_b);
        for (int i = 0; i < 50; ++i) {
            Point offset = {};
            for (unsigned axis = 0; axis < 3; ++axis) {
                const std::int32_t low = leaf_a.octant.corner.at[axis] - leaf_b.octant.side();
                const std::int32_t high = leaf_a.octant.corner.at[axis] + leaf_a.octant.side();
                const std::int32_t ends[] = {low - 1, low, low + 1, high - 1, high, high + 1};
                const std::int32_t corner = random() % 2 == 0 ? (low + high) / 2 : ends[random() % 6];
                offset.at[axis] = corner - leaf_b.octant.corner.at[axis];
            }
            const CollisionOutcome found = collide(*job, a, b, offset);
            ASSERT_TRUE(agrees(found, contact_of(leaf_a, leaf_b, offset), a, b, offset)) << round << " " << i;
            ASSERT_LE(found.visited, static_cast<std::uint64_t>(depth_a + depth_b));
        }
    }
}

// The octants that can stand in a pair: those of nodes and of solid leaves.
std::vector<Octant> octants_of(const Octree& tree) {
    std::vector<Octant> octants;
    for (NodeWalk walk(tree); !walk.done(); walk.next()) octants.push_back(walk.octant());
    for (const Leaf& leaf : leaves_of(tree)) {
        if (leaf.colour != Colour::white && leaf.octant.level > 0) octants.push_back(leaf.octant);
    }
    return octants;
}

TEST(Collision, VisitsNoMoreThanThePairsThatMeetAndStepsAsToldTo) {
    std::mt19937 random(53);
    const auto job = std::make_unique<Collision>();
    for (int round = 0; round < 60; ++round) {
        HeapPool pool_a(1000);
        HeapPool pool_b(1000);
        const Octree a = planted(dense_grid(random, 3), *pool_a);
        const Octree b = planted(dense_grid(random, 2), *pool_b);
        const Point offset = random_offset(random);
        std::uint64_t pairs = 0;
        for (const Octant& of_a : octants_of(a)) {
            for (const Octant& of_b : octants_of(b)) {
                pairs += contact_of({of_a, Colour::black}, {of_b, Colour::black}, offset) != Contact::clear
                             ? 1U
                             : 0U;
            }
        }
        const CollisionOutcome whole = collide(*job, a, b, offset);
        ASSERT_LE(whole.visited, std::max<std::uint64_t>(pairs, 1));

        job->begin(a, b, offset);
        EXPECT_EQ(job->finish().status, Status::unfinished);
        std::uint64_t steps = 0;
        Contact weakest = Contact::clear;
        for (; job->step(1); ++steps) {
            ASSERT_EQ(job->pairs_visited(), steps + 1);
            ASSERT_GE(job->contact(), weakest);
            weakest = job->contact();
        }
        const CollisionOutcome stepped = job->finish();
        ASSERT_TRUE(agrees(stepped, whole.contact, a, b, offset));
        ASSERT_EQ(stepped.visited, whole.visited);
        ASSERT_FALSE(job->step(1));
    }
}

// No other pair is looked at once two black leaves have been found to overlap.
TEST(Collision, ACertainOneIsTheEnd) {
    const DenseGrid grid = make_grid(4, [](const Point& corner, std::int32_t side) {
        return (corner.x() + corner.y() + corner.z()) / side % 2 == 0 ? Colour::black : Colour::white;
    });
    HeapPool pool(2000);
    const Octree tree = planted(grid, *pool);
    const auto job = std::make_unique<Collision>();
    const CollisionOutcome found = collide(*job, tree, tree, {{0, 0, 0}});
    EXPECT_EQ(found.contact, Contact::certain);
    EXPECT_LE(found.visited, 2U * 4U); // the way down in both, to the first cell
}

TEST(Collision, UniformTreesAndFarOffsets) {
    const auto job = std::make_unique<Collision>();
    HeapPool pool(0);
    std::vector<Point> offsets = {
        {{0, 0, 0}}, {{root_side, 3, -5}}, {{root_side + 1, 0, 0}}, {{0, -root_side, root_side}}};
    for (const std::int32_t far : {INT32_MIN, INT32_MAX, 3 * root_side}) {
        offsets.push_back({{far, 0, 0}});
        offsets.push_back({{0, far, far}});
    }
    for (const Colour colour_a : three_colours) {
        for (const Colour colour_b : three_colours) {
            const Octree a = Octree::uniform(*pool, colour_a);
            const Octree b = Octree::uniform(*pool, colour_b);
            for (const Point& offset : offsets) {
                const CollisionOutcome found = collide(*job, a, b, offset);
                const Contact expected = contact_of({root_octant, colour_a}, {root_octant, colour_b}, offset);
                EXPECT_TRUE(agrees(found, expected, a, b, offset));
                EXPECT_EQ(found.visited, 1U);
            }
        }
    }
}

// A job that has not begun answers nothing.
TEST(Collision, NothingIsKnownBeforeTheBeginning) {
    const auto job = std::make_unique<Collision>();
    EXPECT_FALSE(job->step(1));
    EXPECT_EQ(job->finish().status, Status::unfinished);
    EXPECT_EQ(job->contact(), Contact::clear);
}

} // namespace

} // namespace osem::tests
