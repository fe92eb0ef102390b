// Compaction in place.
#include <gtest/gtest.h>

#include <random>

#include "osem/boolean.hpp"
#include "osem/octree.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

// A pool in which trees share subtrees, and its trees with their grids.
struct Forest {
    explicit Forest(std::uint32_t seed) {
        std::mt19937 random(seed);
        for (std::uint32_t i = 0; i < 5; ++i) {
            grids.push_back(random_grid(1 + static_cast<int>(random() % 3), 100 * seed + i, three_colours));
            trees.push_back(planted(grids.back(), *pool));
        }
        // A tree that is a path: groups of one node, each right below its parent.
        grids.emplace_back(3);
        grids.back()[random() % grids.back().size()] = Colour::black;
        trees.push_back(planted(grids.back(), *pool));
        for (int i = 0; i < 15; ++i) {
            const auto op = static_cast<Operator>(random() % 4);
            const std::size_t a = random() % trees.size();
            const std::size_t b = random() % trees.size();
            Combination job;
            const TreeOutcome outcome = combine(job, op, trees[a], trees[b], *pool);
            EXPECT_EQ(outcome.status, Status::ok);
            grids.push_back(combined(op, grids[a], grids[b]));
            trees.push_back(outcome.tree);
        }
        trees.push_back(Octree::uniform(*pool, Colour::black));
        grids.emplace_back(1, Colour::black);
    }
    HeapPool pool{30000};
    std::vector<DenseGrid> grids;
    std::vector<Octree> trees;
};

Status compact_all(HeapPool& pool, std::vector<Octree>& trees) {
    std::vector<std::uint32_t> scratch(compact_scratch(pool->used()), 0xdeadbeef);
    return compact(*pool, trees.data(), static_cast<std::uint32_t>(trees.size()), scratch.data(),
                   static_cast<std::uint32_t>(scratch.size()));
}

TEST(Compact, KeepsWhatIsReachedInOrder) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        Forest forest(seed);
        std::mt19937 random(seed);
        std::vector<Octree> kept;
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < forest.trees.size(); ++i) {
            if (random() % 4 != 0) continue;
            kept.push_back(forest.trees[i]);
            which.push_back(i);
        }
        std::set<std::uint32_t> reached;
        for (const Octree& tree : kept) reached.merge(reachable(tree));
        const std::vector<Node> old_nodes = forest.pool.used_nodes();
        const std::vector<Octree> old_trees = kept;

        ASSERT_EQ(compact_all(forest.pool, kept), Status::ok);
        ASSERT_EQ(forest.pool->used(), reached.size()) << "seed " << seed;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            EXPECT_EQ(expand(kept[i], 3), refined(forest.grids[which[i]], 3)) << "seed " << seed;
            EXPECT_EQ(digest(kept[i]), expected_digest(forest.grids[which[i]]));
            EXPECT_EQ(kept[i].depth, old_trees[i].depth);
            EXPECT_EQ(kept[i].pool, &*forest.pool);
        }

        // New place of each node kept: its rank. Every node and top has to be the old one with that applied.
        std::vector<std::uint32_t> rank(old_nodes.size(), 0);
        std::uint32_t next = 0;
        for (const std::uint32_t old : reached) rank[old] = next++;
        const auto moved = [&rank](const Node& node) {
            const std::uint32_t first = node.grey() != 0 ? rank[node.first()] : 0;
            return Node::of(node.may, node.must, static_cast<NodeIndex>(first));
        };
        std::uint32_t index = 0;
        for (const std::uint32_t old : reached) {
            const Node& node = forest.pool->at(static_cast<NodeIndex>(index));
            ASSERT_EQ(node, moved(old_nodes[old])) << "seed " << seed << ", node " << old;
            ASSERT_TRUE(node.grey() == 0 || node.first() < index) << "children stand below their parent";
            ++index;
        }
        for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].top, moved(old_trees[i].top));

        // A second time there is nothing to do.
        const PoolImage once(forest.pool);
        ASSERT_EQ(compact_all(forest.pool, kept), Status::ok);
        EXPECT_TRUE(once.same_nodes(forest.pool));
    }
}

TEST(Compact, KeepsEveryTreeOfAFullPool) {
    Forest forest(7);
    const PoolImage before(forest.pool);
    std::vector<std::uint64_t> digests;
    for (const Octree& tree : forest.trees) digests.push_back(digest(tree));
    ASSERT_EQ(compact_all(forest.pool, forest.trees), Status::ok);
    EXPECT_TRUE(before.same_nodes(forest.pool)) << "nothing was garbage";
    for (std::size_t i = 0; i < digests.size(); ++i) EXPECT_EQ(digest(forest.trees[i]), digests[i]);
}

TEST(Compact, NoTreesMeanAnEmptyPool) {
    Forest forest(8);
    std::vector<Octree> none;
    ASSERT_EQ(compact_all(forest.pool, none), Status::ok);
    EXPECT_EQ(forest.pool->used(), 0U);
    ASSERT_EQ(compact_all(forest.pool, none), Status::ok);

    std::vector<Octree> uniform = {Octree::uniform(*forest.pool, Colour::boundary)};
    forest.pool.fill_to(100);
    ASSERT_EQ(compact_all(forest.pool, uniform), Status::ok);
    EXPECT_EQ(forest.pool->used(), 0U);
    EXPECT_EQ(uniform[0].top, Node::uniform(Colour::boundary));
}

TEST(Compact, TheSameTreeMayBeGivenTwice) {
    Forest forest(9);
    const std::size_t last = forest.trees.size() - 2;
    std::vector<Octree> twice = {forest.trees[last], forest.trees[0], forest.trees[last]};
    ASSERT_EQ(compact_all(forest.pool, twice), Status::ok);
    EXPECT_EQ(twice[0].top, twice[2].top);
    EXPECT_EQ(digest(twice[0]), expected_digest(forest.grids[last]));
    EXPECT_EQ(digest(twice[1]), expected_digest(forest.grids[0]));
}

TEST(Compact, CountersAndRoom) {
    Forest forest(10);
    const std::uint32_t peak = forest.pool->peak();
    std::vector<Octree> kept = {forest.trees[3]};
    ASSERT_EQ(compact_all(forest.pool, kept), Status::ok);
    EXPECT_EQ(forest.pool->peak(), peak);
    EXPECT_EQ(forest.pool->refused(), 0U);
    const Octree again = planted(forest.grids[4], *forest.pool);
    EXPECT_EQ(digest(again), expected_digest(forest.grids[4]));
    EXPECT_EQ(digest(kept[0]), expected_digest(forest.grids[3]));
}

TEST(Compact, RefusalsChangeNothing) {
    Forest forest(11);
    HeapPool other(10);
    const PoolImage before(forest.pool);
    std::vector<std::uint32_t> scratch(compact_scratch(forest.pool->used()), 0);
    const auto size = static_cast<std::uint32_t>(scratch.size());
    std::vector<Octree> trees = {forest.trees[0], forest.trees[9]};
    const auto first = bytes_of(trees[0]);
    const auto second = bytes_of(trees[1]);
    EXPECT_EQ(compact(*forest.pool, trees.data(), 2, scratch.data(), size - 1), Status::scratch_too_small);
    EXPECT_EQ(compact(*forest.pool, trees.data(), 2, nullptr, 0), Status::scratch_too_small);
    trees.push_back(Octree::uniform(*other, Colour::white));
    EXPECT_EQ(compact(*forest.pool, trees.data(), 3, scratch.data(), size), Status::pools_differ);
    EXPECT_TRUE(before.same_nodes(forest.pool));
    EXPECT_EQ(bytes_of(trees[0]), first);
    EXPECT_EQ(bytes_of(trees[1]), second);
}

TEST(Compact, ScratchIsOneBitANode) {
    for (const std::uint32_t used : {0U, 1U, 31U, 32U, 33U, 63U, 64U, 65U, 1000U}) {
        EXPECT_EQ(compact_scratch(used), (used + 31) / 32);
    }
    EXPECT_EQ(compact_scratch(UINT32_MAX), 1U << 27);
}

// Every pool size around the words of the scratch.
TEST(Compact, EveryNumberOfNodes) {
    const DenseGrid grid = random_grid(2, 3, three_colours);
    for (std::uint32_t garbage = 0; garbage < 130; ++garbage) {
        HeapPool pool(garbage + 1000);
        pool.fill_to(garbage);
        std::vector<Octree> trees = {planted(grid, *pool)};
        pool.fill_to(pool->used() + garbage % 40);
        ASSERT_EQ(compact_all(pool, trees), Status::ok);
        EXPECT_EQ(pool->used(), preorder_masks(grid).size() - 1);
        EXPECT_EQ(digest(trees[0]), expected_digest(grid)) << garbage;
    }
}

// A pool in long service: room for a few trees, compacted whenever it runs out.
TEST(Compact, ThousandsOfOperatorsInASmallPool) {
    std::mt19937 random(2024);
    HeapPool pool(700);
    constexpr std::size_t count = 4;
    std::vector<DenseGrid> grids;
    std::vector<Octree> trees;
    for (std::uint32_t i = 0; i < count; ++i) {
        grids.push_back(random_grid(3, i, two_colours));
        trees.push_back(planted(grids.back(), *pool));
    }
    std::uint32_t compactions = 0;
    for (int round = 0; round < 2000; ++round) {
        const std::size_t a = random() % count;
        const std::size_t b = random() % count;
        const auto op = static_cast<Operator>(random() % 4);
        // Now and then a new tree, or all would end up white.
        const bool is_new = round % 5 == 0;
        const DenseGrid fresh = random_grid(3, 1000 + static_cast<std::uint32_t>(round), three_colours);
        Combination job;
        const auto attempt = [&] {
            return is_new ? plant(fresh, &*pool) : combine(job, op, trees[a], trees[b], *pool);
        };
        TreeOutcome outcome = attempt();
        if (outcome.status == Status::pool_exhausted) {
            ++compactions;
            ASSERT_EQ(compact_all(pool, trees), Status::ok);
            outcome = attempt();
        }
        ASSERT_EQ(outcome.status, Status::ok) << "round " << round;
        grids[a] = is_new ? fresh : combined(op, grids[a], grids[b]);
        trees[a] = outcome.tree;
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(digest(trees[i]), expected_digest(grids[i])) << "round " << round << ", tree " << i;
        }
    }
    EXPECT_GT(compactions, 50U);
}

} // namespace

} // namespace osem::tests
