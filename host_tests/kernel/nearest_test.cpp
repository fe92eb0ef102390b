// The nearest leaf, against the distances of all cells.
#include "osem/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/leaf_list.hpp"
#include "support/query_oracles.hpp"

namespace osem::tests {

namespace {

// Nodes whose octants are within a distance; the top is looked at in any case.
std::uint32_t nodes_within(const Octree& tree, const CellBox& box, std::uint64_t distance) {
    std::uint32_t count = 0;
    for (NodeWalk walk(tree); !walk.done(); walk.next()) {
        const Octant& octant = walk.octant();
        if (octant.level == 0 || distance_to(octant, box) <= distance) ++count;
    }
    return count;
}

::testing::AssertionResult nearest_agrees(const DenseGrid& grid, const Octree& tree, const CellBox& box,
                                          std::uint8_t colours) {
    const Nearest nearest = expected_nearest(cells_of(grid, colours), box);
    const NearestOutcome found = nearest_leaf(tree, box, colours);
    if (found.status != Status::ok || found.found != nearest.found) {
        return ::testing::AssertionFailure() << describe(found.status) << " found " << found.found;
    }
    if (!nearest.found) return ::testing::AssertionSuccess();
    const Leaf leaf = leaf_at(tree, nearest.corner).leaf;
    if (found.distance != nearest.distance || !same_leaf(found.leaf, leaf)) {
        return ::testing::AssertionFailure() << found.distance << ", not " << nearest.distance;
    }
    const NearestOutcome bounded = nearest_leaf(tree, box, colours, nearest.distance);
    if (!bounded.found || bounded.distance != nearest.distance || !same_leaf(bounded.leaf, leaf)) {
        return ::testing::AssertionFailure() << "the bound itself";
    }
    if (bounded.visited > nodes_within(tree, box, nearest.distance)) {
        return ::testing::AssertionFailure() << "visited " << bounded.visited;
    }
    if (nearest.distance > 0 && nearest_leaf(tree, box, colours, nearest.distance - 1).found) {
        return ::testing::AssertionFailure() << "beyond the bound";
    }
    return ::testing::AssertionSuccess();
}

CellBox random_cell_box(std::mt19937& random) {
    CellBox box = {};
    const bool fine = random() % 2 == 0;
    const bool point = random() % 2 == 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const auto bound = [&random, fine] {
            const auto sixteenth = static_cast<std::int32_t>(random() % 25) - 4;
            return sixteenth * (root_side / 16) + (fine ? static_cast<std::int32_t>(random() % 5) - 2 : 0);
        };
        const std::int32_t a = bound();
        const std::int32_t b = point ? a : bound();
        box.low.at[axis] = std::min(a, b);
        box.high.at[axis] = std::max(a, b);
    }
    return box;
}

TEST(NearestLeaf, AgreesWithEveryCellOfTheGrid) {
    std::mt19937 random(41);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        for (int i = 0; i < 40; ++i) {
            const CellBox box = random_cell_box(random);
            for (const unsigned colours : {0U, 1U, 2U, 8U, 10U, 11U}) {
                ASSERT_TRUE(nearest_agrees(grid, tree, box, static_cast<std::uint8_t>(colours)))
                    << "seed " << seed << ", box " << i << ", colours " << colours;
            }
        }
    }
}

// Few leaves, far away, often several at one distance.
TEST(NearestLeaf, AgreesInSparseGrids) {
    std::mt19937 random(42);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        DenseGrid grid(3);
        for (std::uint32_t i = 0; i < 2 + seed % 4; ++i) {
            const std::size_t cell = random() % grid.size();
            grid[cell] = Colour::boundary;
            grid[grid.size() - 1 - cell] = Colour::boundary; // the mirror image, seen from the middle
        }
        HeapPool pool(100);
        const Octree tree = planted(grid, *pool);
        const Point middle = {{root_side / 2, root_side / 2, root_side / 2}};
        ASSERT_TRUE(nearest_agrees(grid, tree, {middle, middle}, solid_colours));
        for (int i = 0; i < 40; ++i)
            ASSERT_TRUE(nearest_agrees(grid, tree, random_cell_box(random), solid_colours));
    }
}

// One leaf at the end of the longest path of every depth, from points of the whole range.
TEST(NearestLeaf, EveryDepthAndRange) {
    std::mt19937 random(43);
    for (int depth = 1; depth <= max_depth; ++depth) {
        HeapPool pool(max_depth);
        Leaf lone = {};
        const Octree tree = lone_leaf(depth, Colour::boundary, random, *pool, lone);
        for (int i = 0; i < 500; ++i) {
            Point from = {};
            for (std::int32_t& c : from.at) {
                const auto bits = static_cast<unsigned>(random() % 30);
                const auto size = static_cast<std::int32_t>(random() % ((std::uint32_t{1} << bits) + 1));
                c = random() % 2 == 0 ? size : -size;
            }
            const NearestOutcome found = nearest_leaf(tree, from);
            ASSERT_TRUE(found.found && same_leaf(found.leaf, lone));
            ASSERT_EQ(found.distance, distance_to(lone.octant, {from, from}));
            ASSERT_EQ(found.visited, static_cast<std::uint32_t>(depth));
        }
    }
}

TEST(NearestLeaf, UniformTrees) {
    HeapPool pool(0);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const Octree tree = Octree::uniform(*pool, colour);
        const Point from = {{root_side + 3, -4, 7}};
        const NearestOutcome found = nearest_leaf(tree, from, colour_bit(colour));
        EXPECT_TRUE(found.found && same_leaf(found.leaf, {root_octant, colour}));
        EXPECT_EQ(found.distance, 25U);
        EXPECT_EQ(found.visited, 1U);
        const auto others = static_cast<std::uint8_t>(~colour_bit(colour));
        EXPECT_FALSE(nearest_leaf(tree, from, others).found);
        EXPECT_FALSE(nearest_leaf(tree, from, colour_bit(colour), 24).found);
    }
}

TEST(NearestLeaf, RefusesBoxesOutOfRangeAndEmptyOnes) {
    HeapPool pool(0);
    const Octree tree = Octree::uniform(*pool, Colour::black);
    constexpr std::int32_t reach = 1 << 29;
    EXPECT_EQ(nearest_leaf(tree, {{{-reach, -reach, -reach}}, {{reach, reach, reach}}}).status, Status::ok);
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (const std::int32_t bad : {-reach - 1, reach + 1, INT32_MIN, INT32_MAX}) {
            Point from = {{0, 0, 0}};
            from.at[axis] = bad;
            const NearestOutcome found = nearest_leaf(tree, from);
            EXPECT_EQ(found.status, Status::coordinate_out_of_range);
            EXPECT_FALSE(found.found || found.visited != 0);
        }
        for (const std::int32_t bad : {-reach - 1, reach + 1}) { // at the high end alone: worse than empty
            CellBox box = {{{5, 5, 5}}, {{5, 5, 5}}};
            box.high.at[axis] = bad;
            EXPECT_EQ(nearest_leaf(tree, box).status, Status::coordinate_out_of_range);
        }
        CellBox box = {{{5, 5, 5}}, {{5, 5, 5}}};
        box.high.at[axis] = 4;
        EXPECT_EQ(nearest_leaf(tree, box).status, Status::box_empty);
        EXPECT_FALSE(nearest_leaf(tree, box).found);
    }
}

} // namespace

} // namespace osem::tests
