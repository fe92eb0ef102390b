#include "osem/tree_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "tree/masks.hpp"

namespace osem::tests {

namespace {

TEST(TreeBuilder, CountsWithoutAPool) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const DenseGrid grid = random_grid(3, seed, three_colours);
        const TreeOutcome counted = plant(grid, nullptr);
        EXPECT_EQ(counted.status, Status::ok);
        EXPECT_EQ(counted.nodes_needed, preorder_masks(grid).size() - 1) << "seed " << seed;

        HeapPool pool(2000);
        const TreeOutcome also_counted = plant(grid, &*pool, true);
        EXPECT_EQ(also_counted.nodes_needed, counted.nodes_needed);
        EXPECT_EQ(pool->peak(), 0U);

        const TreeOutcome built = plant(grid, &*pool);
        EXPECT_EQ(built.nodes_needed, counted.nodes_needed);
        EXPECT_EQ(pool->used(), counted.nodes_needed);
        EXPECT_EQ(built.nodes_missing, 0U);
    }
}

// However few nodes are free: the missing ones are counted, and the others are as they were. Plants as
// plant(grid, pool) does.
template <class Plant>
void expect_missing_counted(const DenseGrid& grid, std::uint32_t least, const Plant& planting) {
    const std::uint32_t needed = plant(grid, nullptr).nodes_needed;
    ASSERT_GT(needed, least);
    for (std::uint32_t room = 0; room < needed; ++room) {
        HeapPool pool(3 + room);
        pool.fill_to(3);
        const PoolImage before(pool);
        const TreeOutcome outcome = planting(grid, &*pool);
        EXPECT_EQ(outcome.status, Status::pool_exhausted);
        EXPECT_EQ(outcome.nodes_needed, needed);
        EXPECT_EQ(outcome.nodes_missing, needed - room);
        EXPECT_TRUE(before.same_nodes(pool));
        EXPECT_GT(pool->refused(), before.refused());
    }
    HeapPool pool(3 + needed);
    pool.fill_to(3);
    EXPECT_EQ(planting(grid, &*pool).status, Status::ok);
}

TEST(TreeBuilder, ExhaustionAtEveryCapacity) {
    expect_missing_counted(random_grid(3, 5, three_colours), 20,
                           [](const DenseGrid& grid, NodePool* pool) { return plant(grid, pool); });
}

TEST(TreeBuilder, GivingUpRollsBack) {
    for (const bool by_finish : {false, true}) {
        HeapPool pool(100);
        pool.fill_to(7);
        const PoolImage before(pool);
        TreeBuilder builder;
        builder.begin(&*pool);
        builder.open(3);
        builder.open(2);
        builder.leaf(1, Colour::black);
        builder.close();
        builder.close(); // the inner octant's node is in the pool from here on
        EXPECT_EQ(pool->used(), 8U);
        EXPECT_FALSE(builder.finished());
        if (by_finish) {
            EXPECT_EQ(builder.finish(4).status, Status::unfinished);
        } else {
            builder.abandon();
        }
        EXPECT_TRUE(before.same_nodes(pool));
    }
}

// Up to finish the nodes can be given back, the root octant being closed or not.
TEST(TreeBuilder, AClosedTreeCanStillBeAbandoned) {
    HeapPool pool(100);
    pool.fill_to(7);
    const PoolImage before(pool);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.open(3);
    builder.leaf(1, Colour::black);
    builder.close();
    builder.close();
    ASSERT_TRUE(builder.finished());
    builder.abandon();
    EXPECT_TRUE(before.same_nodes(pool));
}

TEST(TreeBuilder, AbandonAfterFinishDoesNothing) {
    HeapPool pool(100);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.open(3);
    builder.leaf(1, Colour::black);
    builder.close();
    builder.close();
    const Octree tree = builder.finish(2).tree;
    builder.abandon();
    EXPECT_EQ(pool->used(), 1U);
    EXPECT_EQ(measure(tree).black_leaves, 1U);
}

TEST(TreeBuilder, LaterLeavesReplaceEarlierOnes) {
    HeapPool pool(8);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.leaves(0b0101, 0b0001); // black, white, boundary
    builder.leaf(0, Colour::boundary);
    builder.leaf(2, Colour::black);
    builder.leaf(3, Colour::black);
    builder.leaf(3, Colour::white);
    builder.close();
    const Octree tree = builder.finish(1).tree;
    EXPECT_EQ(tree.top, Node::of(0b0101, 0b0100, 0));
    EXPECT_EQ(pool->used(), 0U);
}

// 64 cells of a grid as a builder takes them.
struct Sets {
    std::uint64_t may = 0;
    std::uint64_t must = 0;

    Sets(const DenseGrid& grid, std::size_t first) {
        for (unsigned cell = 0; cell < 64; ++cell) {
            const Colour colour = grid[first + cell];
            may |= std::uint64_t{colour != Colour::white} << cell;
            must |= std::uint64_t{colour == Colour::black} << cell;
        }
    }
};

void expect_tree_of(const DenseGrid& grid, const TreeOutcome& outcome) {
    EXPECT_EQ(outcome.status, Status::ok);
    EXPECT_EQ(outcome.nodes_needed, preorder_masks(grid).size() - 1);
    EXPECT_EQ(expand(outcome.tree, outcome.tree.depth), grid);
    EXPECT_EQ(digest(outcome.tree), expected_digest(grid));
}

// Of depth 3, by subtrees.
TreeOutcome plant_subtrees(const DenseGrid& grid, NodePool* pool) {
    TreeBuilder builder;
    builder.begin(pool);
    for (unsigned child = 0; child < 8; ++child) {
        const Sets sets(grid, 64 * child);
        builder.subtree(child, sets.may, sets.must);
    }
    builder.close();
    return builder.finish(3);
}

TEST(TreeBuilder, SubtreesFromLeavesOfTwoLevels) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = random_grid(3, seed, three_colours);
        HeapPool pool(600);
        expect_tree_of(grid, plant_subtrees(grid, &*pool));
    }
}

// Of depth 4, by subtrees a level higher.
TreeOutcome plant_greater_subtrees(const DenseGrid& grid, NodePool* pool) {
    bool in_one = false; // every second time, of a set that is another one only where there is boundary
    TreeBuilder builder;
    builder.begin(pool);
    for (unsigned child = 0; child < 8; ++child) {
        std::uint64_t may[8] = {};
        std::uint64_t must[8] = {};
        for (unsigned part = 0; part < 8; ++part) {
            const Sets sets(grid, 512 * child + 64 * part);
            may[part] = sets.may;
            must[part] = sets.must;
        }
        in_one = !in_one && std::equal(may, may + 8, must);
        builder.subtree_of_512(child, may, in_one ? may : must);
    }
    builder.close();
    return builder.finish(4);
}

TEST(TreeBuilder, SubtreesFromLeavesOfThreeLevels) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = random_grid(4, seed, seed % 2 == 0 ? three_colours : two_colours);
        HeapPool pool(5000);
        HeapPool other(5000);
        expect_tree_of(grid, plant_greater_subtrees(grid, &*pool));
        ASSERT_EQ(plant(grid, &*other).status, Status::ok);
        ASSERT_EQ(pool->used(), other->used());
        EXPECT_EQ(pool->peak(), other->peak());
        for (std::uint32_t node = 0; node < pool->used(); ++node) { // each at the same place
            ASSERT_EQ(pool->at(static_cast<NodeIndex>(node)), other->at(static_cast<NodeIndex>(node)));
        }
        EXPECT_EQ(plant_greater_subtrees(grid, nullptr).nodes_needed, pool->used());
    }
}

// 512 leaves, of parts that are each one leaf, or of eight such.
TEST(TreeBuilder, GreaterSubtreesOfFewNodes) {
    constexpr std::uint64_t all = ~std::uint64_t{0};
    const std::uint64_t none[8] = {};
    const std::uint64_t every[8] = {all, all, all, all, all, all, all, all};
    const std::uint64_t one_part[8] = {0, 0, 0, 0, 0, all, 0, 0};
    const std::uint64_t one_octant[8] = {0, 0, 0xff00, 0, 0, 0, 0, 0};
    HeapPool pool(200);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.subtree_of_512(0, none, none);
    builder.subtree_of_512(1, every, every);
    builder.subtree_of_512(2, every, none);
    builder.subtree_of_512(3, one_part, one_part);
    builder.subtree_of_512(4, one_part, none);
    builder.subtree_of_512(5, one_octant, none);
    builder.close();
    const TreeOutcome outcome = builder.finish(4);
    EXPECT_EQ(outcome.nodes_needed, 4U);
    EXPECT_EQ(outcome.tree.top.may, 0b000110);
    EXPECT_EQ(outcome.tree.top.must, 0b111010);
    EXPECT_EQ(pool->child(outcome.tree.top, 3), Node::of(0b100000, 0b100000, 0));
    EXPECT_EQ(pool->child(outcome.tree.top, 4), Node::of(0b100000, 0, 0));
    EXPECT_EQ(pool->child(outcome.tree.top, 5), Node::of(0, 0b100, 0));
    EXPECT_EQ(pool->at(0), Node::of(0b10, 0, 0));
}

TEST(TreeBuilder, EightLeavesInOneStep) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = random_grid(2, seed, three_colours);
        const Sets sets(grid, 0);
        HeapPool pool(8);
        TreeBuilder builder;
        builder.begin(&*pool);
        for (unsigned child = 0; child < 8; ++child) {
            builder.eight_leaves(child, children_of(sets.may, child), children_of(sets.must, child));
        }
        builder.close();
        expect_tree_of(grid, builder.finish(2));
    }
}

TEST(TreeBuilder, EightEqualLeavesInOneStepAreOne) {
    TreeBuilder builder;
    builder.begin(nullptr);
    builder.eight_leaves(0, 0xff, 0xff);
    builder.eight_leaves(3, 0xff, 0x00);
    builder.eight_leaves(5, 0x00, 0x00);
    builder.close();
    const TreeOutcome outcome = builder.finish(1);
    EXPECT_EQ(outcome.nodes_needed, 0U);
    EXPECT_EQ(outcome.tree.top, Node::of(0b1001, 0b0001, 0));
}

TEST(TreeBuilder, GrandchildrenAndThoseLeftOpen) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = random_grid(2, seed, three_colours);
        const Sets sets(grid, 0);
        HeapPool pool(100);
        TreeBuilder builder;
        builder.begin(&*pool);
        const unsigned opened = seed % 9; // 8: none
        builder.grandchildren(sets.may, sets.must,
                              opened < 8 ? std::uint64_t{1} << (8 * opened + seed % 8) : 0);
        if (opened < 8) {
            builder.open(opened);
            builder.leaves(children_of(sets.may, opened), children_of(sets.must, opened));
            builder.close();
        }
        builder.close();
        expect_tree_of(grid, builder.finish(2));
    }
}

TEST(TreeBuilder, SixtyFourEqualLeavesAreOne) {
    TreeBuilder builder;
    builder.begin(nullptr);
    builder.subtree(1, ~std::uint64_t{0}, ~std::uint64_t{0});
    builder.subtree(2, ~std::uint64_t{0}, 0);
    builder.subtree(4, 0, 0);
    builder.close();
    const TreeOutcome outcome = builder.finish(1);
    EXPECT_EQ(outcome.nodes_needed, 0U);
    EXPECT_EQ(outcome.tree.top, Node::of(0b0110, 0b0010, 0));
}

TEST(TreeBuilder, SubtreesAndGrandchildrenAtFullDepth) {
    constexpr std::uint64_t one[8] = {1};
    for (const int levels : {2, 3, 4}) { // from the innermost open octant to the leaf
        HeapPool pool(100);
        TreeBuilder builder;
        builder.begin(&*pool);
        const int opened = max_depth - levels;
        for (int level = 0; level < opened; ++level) builder.open(0);
        if (levels == 2) builder.grandchildren(1, 1);
        if (levels == 3) builder.subtree(0, 1, 1);
        if (levels == 4) builder.subtree_of_512(0, one, one);
        for (int level = 0; level <= opened; ++level) builder.close();
        const TreeOutcome outcome = builder.finish(max_depth);
        EXPECT_EQ(outcome.nodes_needed, static_cast<std::uint32_t>(max_depth - 1));
        const Measures measures = measure(outcome.tree);
        EXPECT_EQ(measures.inner_volume, 1U);
        EXPECT_EQ(measures.outer_volume, 1U);
    }
}

TEST(TreeBuilder, SubtreesAreCountedWhenThePoolRunsOut) {
    expect_missing_counted(random_grid(3, 5, three_colours), 20, plant_subtrees);
}

TEST(TreeBuilder, GreaterSubtreesAreCountedWhenThePoolRunsOut) {
    expect_missing_counted(random_grid(4, 5, three_colours), 100, plant_greater_subtrees);
}

// All parts and all their children are divided, so it takes all nodes there can be. What is behind the pool
// stays as it is, however few nodes are left.
TEST(TreeBuilder, TheGreatestSubtreeNearTheEndOfAPool) {
    constexpr std::uint64_t every_second = 0x5555555555555555;
    const std::uint64_t sets[8] = {every_second, every_second, every_second, every_second,
                                   every_second, every_second, every_second, every_second};
    const std::uint64_t none[8] = {};
    const Node guard = Node::of(0xf0, 0x3c, 12345);
    for (std::uint32_t trial = 0; trial < 60; ++trial) {
        const std::uint32_t room = 60 + trial / 2;
        std::vector<Node> memory(200, guard);
        NodePool pool(memory.data(), room);
        TreeBuilder builder;
        builder.begin(&pool);
        builder.subtree_of_512(6, sets, trial % 2 == 0 ? sets : none);
        builder.close();
        const TreeOutcome outcome = builder.finish(4);
        EXPECT_EQ(outcome.nodes_needed, 73U);
        EXPECT_EQ(outcome.status, room < 73 ? Status::pool_exhausted : Status::ok);
        for (std::size_t node = room; node < memory.size(); ++node) ASSERT_EQ(memory[node], guard) << room;
    }
}

TEST(TreeBuilder, GraftsAreShared) {
    HeapPool pool(3000);
    const DenseGrid part = random_grid(3, 11, three_colours);
    const Octree graft = planted(part, *pool);
    const std::uint32_t used = pool->used();
    TreeBuilder builder;
    builder.begin(&*pool);
    for (unsigned k = 0; k < 8; ++k) builder.graft(k, graft.top);
    builder.close();
    const TreeOutcome outcome = builder.finish(4);
    EXPECT_EQ(outcome.nodes_needed, 8U); // copies of the top; what is below stands once
    EXPECT_EQ(pool->used(), used + 8);
    DenseGrid expected(4);
    for (std::size_t cell = 0; cell < expected.size(); ++cell) expected[cell] = part[cell % part.size()];
    EXPECT_EQ(expand(outcome.tree, 4), expected);
    EXPECT_EQ(digest(outcome.tree), expected_digest(expected));
}

TEST(TreeBuilder, AGroupLikeAnotherIsNotWrittenAgain) {
    HeapPool pool(3000);
    const Octree a = planted(random_grid(3, 12, three_colours), *pool);
    const Octree b = planted(random_grid(3, 13, three_colours), *pool);
    const std::uint32_t used = pool->used();
    for (const bool is_a : {false, true}) {
        const Octree& tree = is_a ? a : b;
        const Octree& other = is_a ? b : a;
        ASSERT_NE(tree.top.grey(), 0);
        for (const bool is_first : {false, true}) {
            TreeBuilder builder;
            builder.begin(&*pool);
            builder.leaves(tree.top.may, static_cast<std::uint8_t>(tree.top.must & ~tree.top.grey()));
            for (unsigned k = 0; k < 8; ++k) {
                if (tree.top.colour(k) == Colour::grey) builder.graft(k, pool->child(tree.top, k));
            }
            is_first ? builder.close(&tree.top, &other.top) : builder.close(&other.top, &tree.top);
            const TreeOutcome outcome = builder.finish(3);
            EXPECT_EQ(outcome.nodes_needed, 0U);
            EXPECT_EQ(outcome.tree.top, tree.top);
            EXPECT_EQ(pool->used(), used);
        }
    }
}

} // namespace

} // namespace osem::tests
