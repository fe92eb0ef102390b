// How transforms work: what they share, in which steps, and what happens when memory runs out.
#include <gtest/gtest.h>

#include <set>

#include "osem/transform.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

Placement moved_by(const Point& by) {
    Placement placement;
    placement.by = by;
    placement.cut_at_root = true;
    return placement;
}

Placement blurred(const Point& by, std::uint8_t depth) {
    Placement placement = moved_by(by);
    placement.depth = depth;
    placement.mixed_as_boundary = true;
    return placement;
}

// Runs a check with every kind of job: check(job, begin), where begin(tree, pool, count_only) begins it.
template <class Check>
void for_every_job(const Check& check) {
    constexpr std::int32_t unit = root_side / 16;
    for (const Placement& placement :
         {moved_by({{unit, -2 * unit, 3 * unit}}), moved_by({{root_side / 2, 0, 0}}),
          blurred({{unit, 0, -unit}}, 3), blurred({{0, 0, 0}}, 2)}) {
        check(Translation(), [placement](Translation& job, const Octree& tree, NodePool& pool, bool count) {
            return job.begin(tree, placement, pool, count);
        });
    }
    check(Reorientation(), [](Reorientation& job, const Octree& tree, NodePool& pool, bool count) {
        return job.begin(tree, Symmetry::nth(29), pool, count);
    });
    for (const Coarse mode : {Coarse::certified, Coarse::inner, Coarse::majority}) {
        check(Coarsening(), [mode](Coarsening& job, const Octree& tree, NodePool& pool, bool count) {
            return job.begin(tree, 3, mode, pool, count);
        });
    }
}

template <class Job, class Begin>
TreeOutcome run(Job& job, const Begin& begin, const Octree& tree, NodePool& pool, bool count_only = false) {
    EXPECT_EQ(begin(job, tree, pool, count_only), Status::ok);
    while (job.step(UINT32_MAX)) {
    }
    return job.finish();
}

TEST(TransformWork, EveryStepBudgetGivesTheSameTree) {
    HeapPool pool(60000);
    const Octree tree = planted(random_grid(4, 5, three_colours), *pool);
    const std::uint32_t used = pool->used();
    for_every_job([&](auto job, const auto& begin) {
        const std::uint64_t expected = digest(run(job, begin, tree, *pool).tree);
        std::set<std::uint64_t> visits;
        for (const std::uint32_t budget : {1U, 2U, 7U, 1000U}) {
            ASSERT_EQ(begin(job, tree, *pool, false), Status::ok);
            std::uint64_t decided = job.decided_volume();
            std::uint64_t visited = job.nodes_visited();
            bool more = true;
            while (more) {
                more = job.step(budget);
                ASSERT_GE(job.decided_volume(), decided);
                ASSERT_LE(job.nodes_visited() - visited, budget);
                ASSERT_EQ(more, job.decided_volume() < root_volume);
                decided = job.decided_volume();
                visited = job.nodes_visited();
            }
            visits.insert(visited);
            EXPECT_EQ(digest(job.finish().tree), expected) << "budget " << budget;
        }
        EXPECT_EQ(visits.size(), 1U);
        pool->roll_back(used);
    });
}

TEST(TransformWork, CountingSaysWhatTheRealRunTakes) {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        HeapPool pool(60000);
        const Octree tree = planted(random_grid(4, seed, three_colours), *pool);
        for_every_job([&](auto job, const auto& begin) {
            const std::uint32_t used = pool->used();
            const PoolImage before(pool);
            const TreeOutcome counted = run(job, begin, tree, *pool, true);
            EXPECT_EQ(counted.status, Status::ok);
            EXPECT_TRUE(before.same_nodes(pool));
            const TreeOutcome real = run(job, begin, tree, *pool);
            EXPECT_EQ(counted.nodes_needed, real.nodes_needed) << "seed " << seed;
            EXPECT_EQ(pool->used() - used, real.nodes_needed) << "seed " << seed;
        });
    }
}

TEST(TransformWork, ExhaustionAtEveryCapacity) {
    HeapPool pool(60000);
    const Octree tree = planted(random_grid(4, 6, three_colours), *pool);
    const std::uint32_t used = pool->used();
    for_every_job([&](auto job, const auto& begin) {
        const TreeOutcome whole = run(job, begin, tree, *pool);
        const std::uint64_t expected = digest(whole.tree);
        pool->roll_back(used);
        for (std::uint32_t room = 0; room <= whole.nodes_needed; ++room) {
            HeapPool small(pool, used + room);
            Octree stood = tree;
            stood.pool = &*small;
            const PoolImage before(small);
            const TreeOutcome outcome = run(job, begin, stood, *small);
            ASSERT_EQ(job.exhausted(), room < whole.nodes_needed);
            ASSERT_EQ(outcome.nodes_needed, whole.nodes_needed);
            ASSERT_EQ(outcome.nodes_missing, whole.nodes_needed - room);
            if (room < whole.nodes_needed) {
                ASSERT_EQ(outcome.status, Status::pool_exhausted);
                ASSERT_TRUE(before.same_nodes(small));
                ASSERT_EQ(digest(stood), digest(tree));
            } else {
                ASSERT_EQ(outcome.status, Status::ok);
                ASSERT_EQ(digest(outcome.tree), expected);
            }
        }
    });
}

TEST(TransformWork, GivingUpAtEveryStepRollsBack) {
    HeapPool pool(60000);
    const Octree tree = planted(random_grid(3, 7, three_colours), *pool);
    const std::uint32_t used = pool->used();
    const PoolImage before(pool);
    for_every_job([&](auto job, const auto& begin) {
        for (std::uint32_t steps = 0;; ++steps) {
            ASSERT_EQ(begin(job, tree, *pool, false), Status::ok);
            bool more = true;
            for (std::uint32_t i = 0; i < steps && more; ++i) more = job.step(1);
            if (!more) break;
            ASSERT_EQ(job.finish().status, Status::unfinished);
            ASSERT_TRUE(before.same_nodes(pool)) << steps;
        }
        EXPECT_EQ(job.finish().status, Status::ok);
        pool->roll_back(used);
    });
}

TEST(TransformWork, LeavingTheRootIsFoundAtEveryBudgetAndChangesNothing) {
    HeapPool pool(6000);
    const Octree tree = planted(random_grid(4, 9, three_colours), *pool);
    const PoolImage before(pool);
    Placement placement;
    placement.by = Point{{-root_side / 16, 0, 0}};
    for (const std::uint32_t budget : {1U, 2U, 100U}) {
        Translation job;
        ASSERT_EQ(job.begin(tree, placement, *pool), Status::ok);
        EXPECT_EQ(job.decided_volume(), 0U);
        while (job.step(budget)) {
        }
        EXPECT_EQ(job.finish().status, Status::part_leaves_root);
        EXPECT_EQ(job.finish().status, Status::unfinished);
        EXPECT_TRUE(before.same_nodes(pool));
    }
}

TEST(TransformSharing, WhatStaysTheSameTakesNoNode) {
    HeapPool pool(6000);
    const Octree tree = planted(random_grid(4, 10, three_colours), *pool);
    Translation translation;
    const TreeOutcome still = translate(translation, tree, Placement(), *pool);
    EXPECT_EQ(still.nodes_needed, 0U);
    EXPECT_EQ(still.tree.top, tree.top);
    Reorientation reorientation;
    EXPECT_EQ(reorient(reorientation, tree, Symmetry::identity(), *pool).tree.top, tree.top);
    Coarsening coarsening;
    EXPECT_EQ(coarsen(coarsening, tree, 4, Coarse::certified, *pool).tree.top, tree.top);
    EXPECT_EQ(coarsen(coarsening, tree, 20, Coarse::certified, *pool).nodes_needed, 0U);
}

// A move by half the root's side moves four subtrees of the top.
TEST(TransformSharing, OctantsThatMoveAsAWholeAreShared) {
    HeapPool pool(6000);
    const Octree tree = planted(random_grid(4, 11, two_colours), *pool);
    ASSERT_GT(measure(tree).nodes, 200U);
    Translation job;
    const TreeOutcome half = translate(job, tree, moved_by({{root_side / 2, 0, 0}}), *pool);
    EXPECT_LE(half.nodes_needed, 4U);
    const TreeOutcome quarter = translate(job, tree, moved_by({{0, root_side / 4, 0}}), *pool);
    EXPECT_LE(quarter.nodes_needed, 8U + 64U);
    const CellBox box = {Point{{0, 0, 0}}, Point{{root_side / 2, root_side, root_side}}};
    EXPECT_LE(crop(job, tree, box, *pool).nodes_needed, 4U);
    EXPECT_EQ(job.nodes_visited(), 2U); // the top twice: nothing leaves the root, then its children
}

TEST(TransformWork, TreesOfOtherPoolsAreRefused) {
    HeapPool pool(6000);
    HeapPool other(10);
    const Octree tree = planted(random_grid(2, 1, two_colours), *pool);
    for_every_job([&](auto job, const auto& begin) {
        EXPECT_EQ(begin(job, tree, *other, false), Status::pools_differ);
        EXPECT_FALSE(job.step(1));
        EXPECT_EQ(job.finish().status, Status::unfinished);
    });
}

} // namespace

} // namespace osem::tests
