// Coarsening to a node budget: what is certified cell by cell, and how much is lost against the best that
// dynamic programming over all ways to prune finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "osem/fit.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/losses.hpp"

namespace osem::tests {

namespace {

void expect_certified(const DenseGrid& grid, const PruneOutcome& outcome) {
    const DenseGrid after = expand(outcome.built.tree, grid.depth());
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        ASSERT_TRUE(after[cell] == Colour::boundary || after[cell] == grid[cell]) << "cell " << cell;
    }
    EXPECT_EQ(outcome.inner_lost, grid.volume(Colour::black) - after.volume(Colour::black));
    EXPECT_EQ(outcome.outer_gained, grid.volume(Colour::white) - after.volume(Colour::white));
    EXPECT_EQ(digest(outcome.built.tree), expected_digest(after)) << "canonical";
}

// Every budget from 0 to more than enough, into a pool of just that size.
void expect_every_budget(const DenseGrid& grid) {
    HeapPool source(8000);
    const Octree tree = planted(grid, *source);
    const Losses least = least_losses(grid);
    ASSERT_EQ(source->used() + 1, least.size());
    Pruning job;
    std::uint64_t last = UINT64_MAX;
    for (std::uint32_t budget = 0; budget <= least.size(); ++budget) {
        SCOPED_TRACE(budget);
        HeapPool pool(budget);
        const PruneOutcome outcome = prune(job, tree, budget, &*pool);
        ASSERT_EQ(outcome.built.status, Status::ok);
        ASSERT_LE(outcome.built.nodes_needed, budget);
        ASSERT_EQ(outcome.built.nodes_needed, pool->used());
        ASSERT_EQ(outcome.built.nodes_needed + 1, measure(outcome.built.tree).nodes);
        ASSERT_NO_FATAL_FAILURE(expect_certified(grid, outcome));
        const std::uint64_t lost = outcome.inner_lost + outcome.outer_gained;
        const std::uint64_t best = least[std::min<std::size_t>(budget, least.size() - 1)];
        ASSERT_GE(lost, best) << "the oracle is wrong";
        ASSERT_LE(lost - best, outcome.above_optimum);
        ASSERT_LE(lost, last) << "a greater budget loses more";
        last = lost;
    }
    EXPECT_EQ(last, 0U);
}

TEST(Pruning, EveryBudgetOfRandomTrees) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        const DenseGrid grid = grid_of(seed);
        if (preorder_masks(grid).size() <= 500) expect_every_budget(grid);
    }
}

// A ball: black inside, boundary where the sphere passes.
DenseGrid ball(int depth) {
    return make_grid(depth, [](const Point& corner, std::int32_t side) {
        std::int64_t nearest = 0;
        std::int64_t farthest = 0;
        for (const std::int32_t low : corner.at) {
            const std::int64_t a = (low - 500000) / 1000;
            const std::int64_t b = (low + side - 500000) / 1000;
            const std::int64_t most = std::max(std::abs(a), std::abs(b));
            const std::int64_t least = a <= 0 && b >= 0 ? 0 : std::min(std::abs(a), std::abs(b));
            nearest += least * least;
            farthest += most * most;
        }
        constexpr std::int64_t radius = 370;
        return farthest <= radius * radius  ? Colour::black
               : nearest >= radius * radius ? Colour::white
                                            : Colour::boundary;
    });
}

TEST(Pruning, EveryBudgetOfABall) { expect_every_budget(ball(4)); }

// What a hull of optima promises: with no room left over nothing better exists, and the bound says so.
TEST(Pruning, TheBoundIsOftenZeroAndNeverFarOff) {
    const DenseGrid grid = ball(4);
    HeapPool source(8000);
    const Octree tree = planted(grid, *source);
    const Losses least = least_losses(grid);
    Pruning job;
    std::uint32_t exact = 0;
    for (std::uint32_t budget = 0; budget < least.size(); ++budget) {
        const PruneOutcome outcome = prune(job, tree, budget, nullptr);
        const std::uint64_t lost = outcome.inner_lost + outcome.outer_gained;
        if (outcome.above_optimum == 0) {
            ++exact;
            EXPECT_EQ(lost, least[budget]);
        }
    }
    EXPECT_GT(exact, 1U);
    const PruneOutcome all = prune(job, tree, source->used(), nullptr);
    EXPECT_EQ(all.above_optimum, 0U);
    EXPECT_EQ(all.built.nodes_needed, source->used());
}

TEST(Pruning, EnoughRoomGivesTheTreeAndItsDepth) {
    const DenseGrid grid = ball(4);
    HeapPool source(8000);
    const Octree tree = planted(grid, *source);
    Pruning job;
    HeapPool pool(source->used());
    const PruneOutcome outcome = prune(job, tree, UINT32_MAX, &*pool);
    EXPECT_TRUE(same_leaves(outcome.built.tree, tree));
    EXPECT_EQ(outcome.built.tree.depth, 4);
    EXPECT_EQ(outcome.inner_lost + outcome.outer_gained, 0U);
}

// The greatest volumes and prices: octants of level 1 of which nearly nothing is known, and nearly all.
TEST(Pruning, UniformAndExtremeTrees) {
    Pruning job;
    HeapPool pool(100);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const PruneOutcome outcome = prune(job, Octree::uniform(*pool, colour), 0, &*pool);
        EXPECT_EQ(outcome.built.tree.top, Node::uniform(colour));
        EXPECT_EQ(outcome.inner_lost + outcome.outer_gained, 0U);
    }
    TreeBuilder builder;
    builder.begin(&*pool);
    for (int level = 1; level < max_depth; ++level) builder.open(0);
    builder.leaf(0, Colour::black);
    for (int level = 0; level < max_depth; ++level) builder.close();
    const Octree deep = builder.finish(max_depth).tree;
    for (std::uint32_t budget = 0; budget < 20; ++budget) {
        const PruneOutcome outcome = prune(job, deep, budget, nullptr);
        EXPECT_EQ(outcome.built.nodes_needed, std::min(budget, 19U));
        EXPECT_EQ(outcome.inner_lost, budget < 19 ? 1U : 0U);
        const int level = static_cast<int>(budget) + 1; // of the octant given up
        EXPECT_EQ(outcome.outer_gained, budget < 19 ? volume_at(level) - 1 : 0U);
    }
}

TEST(Pruning, SharedNodesCountAsOftenAsTheyAreReached) {
    const DenseGrid grid = ball(3);
    HeapPool pool(2000);
    const Octree part = planted(grid, *pool);
    TreeBuilder builder;
    builder.begin(&*pool);
    for (unsigned k = 0; k < 8; ++k) builder.graft(k, part.top);
    builder.close();
    const Octree tree = builder.finish(4).tree;
    const auto all = static_cast<std::uint32_t>(measure(tree).nodes - 1);
    Pruning job;
    HeapPool other(all);
    EXPECT_EQ(prune(job, tree, all, &*other).built.nodes_needed, all);
    const PruneOutcome outcome = prune(job, tree, all - 1, nullptr);
    EXPECT_LT(outcome.built.nodes_needed, all);
    EXPECT_GT(outcome.inner_lost + outcome.outer_gained, 0U);
}

TEST(Pruning, EveryStepBudgetGivesTheSame) {
    HeapPool source(8000);
    const Octree tree = planted(ball(4), *source);
    std::vector<std::uint64_t> digests;
    std::vector<std::uint64_t> visits;
    for (const std::uint32_t steps : {1U, 2U, 7U, 1000U, UINT32_MAX}) {
        HeapPool pool(100);
        Pruning job;
        job.begin(tree, 100, &*pool);
        EXPECT_TRUE(job.step(0));
        while (job.step(steps)) {
        }
        EXPECT_FALSE(job.step(steps));
        digests.push_back(digest(job.finish().built.tree));
        visits.push_back(job.nodes_visited());
    }
    EXPECT_EQ(digests, std::vector<std::uint64_t>(digests.size(), digests[0]));
    EXPECT_EQ(visits, std::vector<std::uint64_t>(visits.size(), visits[0]));
    const std::uint64_t nodes = measure(tree).nodes;
    EXPECT_LE(visits[0], (59 + 2 * 4) * nodes + 4 * 101);
}

// Into the operand's own pool, of every size: it fits, or the pool is as before and says what is missing.
TEST(Pruning, PoolsOfEverySize) {
    HeapPool source(8000);
    const Octree tree = planted(ball(4), *source);
    constexpr std::uint32_t budget = 60;
    Pruning job;
    const std::uint32_t needed = prune(job, tree, budget, nullptr).built.nodes_needed;
    ASSERT_GT(needed, 50U);
    for (std::uint32_t room = 0; room <= needed; ++room) {
        HeapPool pool(source, source->used() + room);
        const PoolImage before(pool);
        const PruneOutcome outcome = prune(job, Octree{&*pool, tree.top, tree.depth}, budget, &*pool);
        ASSERT_EQ(outcome.built.nodes_needed, needed);
        if (room < needed) {
            ASSERT_EQ(outcome.built.status, Status::pool_exhausted);
            ASSERT_EQ(outcome.built.nodes_missing, needed - room);
            ASSERT_TRUE(before.same_nodes(pool));
        } else {
            ASSERT_EQ(outcome.built.status, Status::ok);
        }
    }
}

TEST(Pruning, GivingUpRollsBack) {
    HeapPool source(8000);
    const Octree tree = planted(ball(3), *source);
    HeapPool pool(100);
    pool.fill_to(5);
    const PoolImage before(pool);
    Pruning job;
    EXPECT_EQ(job.finish().built.status, Status::unfinished);
    for (std::uint32_t steps = 0;; ++steps) {
        job.begin(tree, 20, &*pool);
        if (!job.step(steps)) break;
        ASSERT_EQ(job.finish().built.status, Status::unfinished);
        ASSERT_TRUE(before.same_nodes(pool));
    }
    EXPECT_EQ(job.finish().built.status, Status::ok);
}

// A top node of leaves needs no pool.
TEST(Pruning, ATreeWithoutAPool) {
    const Node leaves = Node::of(0x35, 0x14, 0);
    for (const Node& top : {Node::uniform(Colour::black), leaves}) {
        Pruning job;
        const PruneOutcome outcome = prune(job, Octree{nullptr, top, 2}, 0, nullptr);
        EXPECT_EQ(outcome.built.status, Status::ok);
        EXPECT_EQ(outcome.built.tree.top, top);
        EXPECT_EQ(outcome.built.nodes_needed, 0U);
        EXPECT_EQ(outcome.inner_lost + outcome.outer_gained + outcome.above_optimum, 0U);
    }
}

// Of the black and white leaves in the last node alone, few cells are known for many nodes: no price in whole
// cells is as low, so what the budget costs at the price found is more than all there is to lose.
TEST(Pruning, NodesWorthLessThanACellEach) {
    HeapPool pool(100);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.leaves(0xff, 0);
    for (int level = 1; level < max_depth; ++level) {
        builder.open(0);
        builder.leaves(0xff, level == max_depth - 1 ? 1 : 0);
    }
    for (int level = 0; level < max_depth; ++level) builder.close();
    const Octree deep = builder.finish(max_depth).tree;
    ASSERT_EQ(pool->used(), 19U);
    Pruning job;
    for (std::uint32_t budget = 0; budget <= 19; ++budget) {
        const PruneOutcome outcome = prune(job, deep, budget, nullptr);
        EXPECT_EQ(outcome.inner_lost, budget < 19 ? 1U : 0U);
        EXPECT_EQ(outcome.outer_gained, 0U);
        EXPECT_LE(outcome.above_optimum, outcome.inner_lost);
    }
}

// Eight octants of one node each, as much known in each: no price keeps some of them, so all that is kept is
// what the room left over goes to, the first ones in Morton order, down to the last node of the budget.
TEST(Pruning, RoomLeftOverIsUsedToTheLastNode) {
    DenseGrid grid(2, Colour::boundary);
    for (std::size_t octant = 0; octant < 8; ++octant) grid[8 * octant + octant] = Colour::black;
    HeapPool source(100);
    const Octree tree = planted(grid, *source);
    Pruning job;
    for (std::uint32_t budget = 0; budget <= 8; ++budget) {
        const PruneOutcome outcome = prune(job, tree, budget, &*source);
        EXPECT_EQ(outcome.built.nodes_needed, budget);
        EXPECT_EQ(outcome.inner_lost, (8 - budget) * volume_at(2));
        EXPECT_EQ(outcome.above_optimum, 0U);
        for (unsigned octant = 0; octant < 8; ++octant) {
            EXPECT_EQ(outcome.built.tree.top.colour(octant) == Colour::grey, octant < budget);
        }
    }
}

} // namespace

} // namespace osem::tests
