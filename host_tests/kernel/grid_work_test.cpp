// Conversion by grids as a job: budgets, progress, pools and scratch of every size, and what it refuses.
#include <gtest/gtest.h>

#include <vector>

#include "osem/grid_convert.hpp"
#include "support/grid_jobs.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

TEST(GridConversionWork, BudgetsAndProgress) {
    const SmallSolid solid = octahedron_solid(Octahedron{{{400001, 500003, 600005}}, 399999});
    GridScratch scratch(grid_scratch(solid.view(), 6, 2));
    for (const int depth : {5, 6}) {
        std::vector<std::uint64_t> digests;
        for (const std::uint32_t budget : {1U, 2U, 7U, UINT32_MAX}) {
            HeapPool pool(20000);
            GridConversion job;
            ASSERT_EQ(scratch.begin(job, solid, ConvertOptions{depth}, &*pool, 2), Status::ok);
            EXPECT_TRUE(job.step(0));
            std::uint64_t decided = 0;
            while (job.step(budget)) {
                EXPECT_LE(decided, job.decided_volume());
                decided = job.decided_volume();
                EXPECT_LT(decided, root_volume);
            }
            EXPECT_EQ(job.decided_volume(), root_volume);
            EXPECT_FALSE(job.step(budget));
            const TreeOutcome outcome = job.finish();
            ASSERT_EQ(outcome.status, Status::ok);
            EXPECT_EQ(job.finish().status, Status::ok);
            digests.push_back(digest(outcome.tree) + job.grids_visited());
        }
        EXPECT_EQ(digests, std::vector<std::uint64_t>(digests.size(), digests[0]));
    }
}

TEST(GridConversionWork, EveryPoolTooSmallSaysHowMuch) {
    const SmallSolid solid =
        boxes_solid({box(1, 9), {{{300001, 300001, 300001}}, {{750001, 700001, 400001}}, -1}});
    const ConvertOptions options = {4};
    GridScratch scratch(grid_scratch(solid.view(), 4));
    GridConversion job;
    const std::uint32_t needed = scratch.run(job, solid, options, nullptr).nodes_needed;
    ASSERT_GT(needed, 20U);
    for (std::uint32_t room = 0; room < needed; ++room) {
        HeapPool pool(3 + room);
        pool.fill_to(3);
        const PoolImage before(pool);
        const TreeOutcome outcome = scratch.run(job, solid, options, &*pool);
        ASSERT_EQ(outcome.status, Status::pool_exhausted);
        ASSERT_EQ(outcome.nodes_missing, needed - room);
        ASSERT_TRUE(before.same_nodes(pool));
    }
}

TEST(GridConversionWork, EveryScratchTooSmallIsRefusedAndGivingUpRollsBack) {
    const SmallSolid solid = octahedron_solid(Octahedron{{{400001, 500003, 600005}}, 399999});
    const ConvertOptions options = {6};
    GridConversion job;
    GridScratch enough(grid_scratch(solid.view(), 6, 3));
    // Two grids above the last one: 8 faces x (3 + 3 + 1) and 2 x 64; and 64 rows of 4 words, 4 for winding
    // numbers up to 24 corners, and 48.
    EXPECT_EQ(enough.size(), 56U + 128U + 64U * 8U + 48U);
    HeapPool pool(20000);
    pool.fill_to(3);
    const PoolImage before(pool);
    ASSERT_EQ(enough.run(job, solid, options, nullptr, 3).status, Status::ok);
    const std::uint32_t used = job.scratch_used();
    EXPECT_GT(used, 3 * solid.face_count() + 64 * 4);
    ASSERT_EQ(enough.run(job, solid, {2}, nullptr, 3).status, Status::ok);
    EXPECT_LT(job.scratch_used(), used) << "of the last one";
    for (std::uint32_t size = 0; size < used; ++size) {
        GridScratch scratch(size);
        const TreeOutcome outcome = scratch.run(job, solid, options, &*pool, 3);
        ASSERT_EQ(outcome.status, Status::scratch_too_small) << size;
        ASSERT_TRUE(before.same_nodes(pool));
    }
    for (std::uint32_t grids = 0;; grids += 3) {
        ASSERT_EQ(enough.begin(job, solid, options, &*pool, 3), Status::ok);
        if (!job.step(grids)) break;
        ASSERT_EQ(job.finish().status, Status::unfinished);
        ASSERT_TRUE(before.same_nodes(pool));
    }
    GridScratch exact(used);
    EXPECT_EQ(exact.run(job, solid, options, nullptr, 3).status, Status::ok);
}

// Winding numbers that outgrow their words where no more scratch is.
TEST(GridConversionWork, ScratchForWindingNumbers) {
    std::vector<Box> nest;
    for (std::int32_t i = 1; i < 8; ++i) nest.push_back(box(i, 16 - i));
    const SmallSolid solid = boxes_solid(nest);
    for (const int depth : {3, 5}) { // the numbers grow in the last grid, and in the one above
        const ConvertOptions options = {depth, LeafRule::conservative, WindingRule::positive};
        GridConversion job;
        GridScratch enough(grid_scratch(solid.view(), depth, 3));
        ASSERT_EQ(enough.run(job, solid, options, nullptr, 3).status, Status::ok);
        for (std::uint32_t size = solid.face_count(); size < job.scratch_used(); ++size) {
            GridConversion small;
            GridScratch scratch(size);
            ASSERT_EQ(scratch.run(small, solid, options, nullptr, 3).status, Status::scratch_too_small)
                << size;
        }
    }
}

TEST(GridConversionWork, Refusals) {
    const SmallSolid solid = box_solid(box(2, 9));
    GridScratch scratch(grid_scratch(solid.view(), 6));
    GridConversion job;
    EXPECT_EQ(job.finish().status, Status::unfinished);
    EXPECT_FALSE(job.step(1));
    for (const int depth : {-1, 0, 21}) {
        EXPECT_EQ(scratch.run(job, solid, ConvertOptions{depth}, nullptr).status, Status::depth_out_of_range);
    }
    for (const int last_levels : {-1, 0, 6}) {
        EXPECT_EQ(scratch.run(job, solid, ConvertOptions{6}, nullptr, last_levels).status,
                  Status::depth_out_of_range);
    }
    const Octant off_the_grid = {Point{{1, 0, 0}}, 1};
    const Octant at_full_depth = {Point{{0, 0, 0}}, 6};
    for (const Octant& octant : {off_the_grid, at_full_depth}) {
        EXPECT_EQ(job.begin(solid.checked(), ConvertOptions{6}, scratch.words.data(), scratch.size(), nullptr,
                            {most_grid_levels, octant}),
                  Status::depth_out_of_range);
    }
    GridScratch too_few(18);
    ASSERT_EQ(too_few.run(job, solid, ConvertOptions{6}, nullptr).status, Status::scratch_too_small);
    EXPECT_EQ(job.finish().status, Status::scratch_too_small);
    EXPECT_EQ(too_few.begin(job, solid, ConvertOptions{0}, nullptr), Status::depth_out_of_range);
    EXPECT_EQ(job.finish().status, Status::unfinished);
    EXPECT_EQ(scratch.run(job, solid, ConvertOptions{20, LeafRule::centre}, nullptr).status,
              Status::depth_out_of_range);
}

// Lists longer than all that lies behind a grid: where one does not fit, nothing else has been refused
// before.
TEST(GridConversionWork, ScratchForLongLists) {
    SmallSolid solid;
    for (std::int32_t radius = 9; radius < 24; ++radius) {
        solid.add(octahedron_solid(Octahedron{{{700001, 100003, 400005}}, 1000 * radius}));
    }
    const ConvertOptions options = {9};
    HeapPool expected(20000);
    const TreeOutcome divided = converted(solid, options, &*expected);
    HeapPool pool(divided.nodes_needed + 3);
    pool.fill_to(3);
    const PoolImage before(pool);
    GridConversion job;
    GridScratch enough(grid_scratch(solid.view(), 9, 1));
    ASSERT_EQ(enough.run(job, solid, options, nullptr, 1).status, Status::ok);
    const std::uint32_t used = job.scratch_used();
    ASSERT_GT(used, 6 * solid.face_count() + 64);
    for (std::uint32_t size = 3 * solid.face_count(); size < used; size += 5) {
        GridScratch scratch(size);
        ASSERT_EQ(scratch.run(job, solid, options, &*pool, 1).status, Status::scratch_too_small) << size;
        ASSERT_TRUE(before.same_nodes(pool));
    }
    GridScratch exact(used);
    const TreeOutcome outcome = exact.run(job, solid, options, &*pool, 1);
    ASSERT_EQ(outcome.status, Status::ok);
    EXPECT_TRUE(same_leaves(outcome.tree, divided.tree));
}

TEST(GridConversionWork, ScratchForPlacedFaces) {
    const SmallSolid solid = dented_ball(9, 1);
    const ConvertOptions options = {5};
    GridConversion job;
    GridScratch enough(grid_scratch(solid.view(), 5, 3));
    ASSERT_EQ(enough.run(job, solid, options, nullptr, 3).status, Status::ok);
    const std::uint32_t used = job.scratch_used();
    EXPECT_LT(used, 3 * solid.face_count() + 64 * 4) << "a list of all faces above the last grid's rows";
    for (std::uint32_t size = solid.face_count() - 1; size < used; size += 7) {
        GridScratch scratch(size);
        ASSERT_EQ(scratch.run(job, solid, options, nullptr, 3).status, Status::scratch_too_small) << size;
    }
    GridScratch exact(used);
    EXPECT_EQ(exact.run(job, solid, options, nullptr, 3).status, Status::ok);
}

TEST(GridConversionWork, TheCountGrowsToTheNodesNeededAndThePoolIsKnownToHaveRunOut) {
    const SmallSolid solid = octahedron_solid(Octahedron{{{400001, 500003, 600005}}, 399999});
    const ConvertOptions options = {5};
    GridScratch scratch(grid_scratch(solid.view(), 5, 2));
    GridConversion job;
    const std::uint32_t needed = scratch.run(job, solid, options, nullptr, 2).nodes_needed;
    for (const std::uint32_t capacity : {needed / 2, needed}) {
        HeapPool pool(capacity);
        ASSERT_EQ(scratch.begin(job, solid, options, &*pool, 2), Status::ok);
        std::uint32_t counted = 0;
        bool exhausted = false;
        for (bool more = true; more;) {
            more = job.step(1);
            EXPECT_GE(job.nodes_counted(), counted);
            EXPECT_TRUE(job.exhausted() || !exhausted);
            EXPECT_TRUE(job.exhausted() || job.nodes_counted() <= capacity);
            counted = job.nodes_counted();
            exhausted = job.exhausted();
        }
        EXPECT_EQ(counted, needed);
        EXPECT_EQ(exhausted, capacity < needed);
        EXPECT_EQ(job.finish().status, capacity < needed ? Status::pool_exhausted : Status::ok);
    }
}

} // namespace

} // namespace osem::tests
