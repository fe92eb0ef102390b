// Jobs asked for a result they do not have, begun twice, or given tables that lie.
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "osem/osem.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

// Vectors of exact length, so that a read past an entry not yet checked is one the sanitizer sees.
Status check_tables(const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& ring_starts,
                    const std::vector<std::uint32_t>& face_rings) {
    const std::vector<Point> vertices = {{{0, 0, 0}}, {{8, 0, 0}}, {{0, 8, 0}}};
    const Solid solid = {vertices.data(),
                         3,
                         corners.data(),
                         static_cast<std::uint32_t>(corners.size()),
                         ring_starts.data(),
                         face_rings.data(),
                         static_cast<std::uint32_t>(face_rings.size() - 1)};
    std::vector<Edge> scratch(check_scratch(solid));
    return check(solid, scratch.data(), check_scratch(solid)).status;
}

TEST(HostileTables, AreRefusedWithoutReadingPastThem) {
    const std::vector<std::uint32_t> two_triangles = {0, 1, 2, 2, 1, 0};
    EXPECT_EQ(check_tables(two_triangles, {0, 3, 6}, {0, 1, 2}), Status::ok);
    for (const auto& face_rings : {std::vector<std::uint32_t>{0, 1000, 2}, {1, 0, 2}, {0, 0, 2}, {0, 2, 2}}) {
        EXPECT_EQ(check_tables(two_triangles, {0, 3, 6}, face_rings), Status::ring_table_invalid);
    }
    for (const auto& ring_starts :
         {std::vector<std::uint32_t>{0, 1000, 6}, {3, 0, 6}, {0, 3, 7}, {0, 3, 0xffffffff}}) {
        EXPECT_EQ(check_tables(two_triangles, ring_starts, {0, 1, 2}), Status::ring_table_invalid);
    }
    EXPECT_EQ(check_tables(two_triangles, {0, 3, 5}, {0, 1, 2}), Status::ring_too_short);
}

TEST(HostileTables, OneTableWithoutTheOtherIsRefused) {
    const Point vertices[] = {{{0, 0, 0}}, {{8, 0, 0}}, {{0, 8, 0}}};
    const std::uint32_t corners[] = {0, 1, 2, 2, 1, 0};
    const std::uint32_t table[] = {0, 3, 6};
    Edge scratch[6];
    EXPECT_EQ(check(Solid{vertices, 3, corners, 6, table, nullptr, 2}, scratch, 6).status,
              Status::ring_table_invalid);
    EXPECT_EQ(check(Solid{vertices, 3, corners, 6, nullptr, table, 2}, scratch, 6).status,
              Status::ring_table_invalid);
    EXPECT_EQ(check(Solid{vertices, 3, corners, 5, nullptr, nullptr, 2}, scratch, 6).status,
              Status::ring_table_invalid);
    // Three corners a face are 2^32 + 2.
    EXPECT_EQ(check(Solid{vertices, 3, corners, 2, nullptr, nullptr, 0x55555556}, scratch, 6).status,
              Status::ring_table_invalid);
}

TEST(Misuse, FinishingWhatWasNeverBegun) {
    Conversion conversion;
    Combination combination;
    StreamReader reader;
    TreeBuilder builder;
    EXPECT_FALSE(conversion.step(1));
    EXPECT_EQ(conversion.finish().status, Status::unfinished);
    EXPECT_FALSE(combination.step(1));
    EXPECT_EQ(combination.finish().status, Status::unfinished);
    EXPECT_EQ(reader.finish().built.status, Status::unfinished);
    const std::uint8_t byte = 'O';
    EXPECT_EQ(reader.feed(&byte, 1), Status::unfinished);
    EXPECT_FALSE(reader.has_header());
    EXPECT_EQ(reader.finish().built.status, Status::unfinished);
    EXPECT_EQ(builder.finish(1).status, Status::unfinished);
    EXPECT_EQ(builder.finish(1).status, Status::unfinished);
}

TEST(Misuse, ARefusedBeginLeavesNoOldResult) {
    HeapPool pool(100);
    HeapPool other(1);
    const Octree black = Octree::uniform(*pool, Colour::black);
    Combination job;
    ASSERT_EQ(combine(job, Operator::unite, black, black, *pool).status, Status::ok);
    ASSERT_EQ(job.begin(Operator::unite, black, Octree::uniform(*other, Colour::black), *pool),
              Status::pools_differ);
    EXPECT_EQ(job.finish().status, Status::unfinished);

    Conversion conversion;
    ConvertOptions options;
    ASSERT_EQ(convert(conversion, CheckedSolid::vouched(Solid{}), options, nullptr, 0, &*pool).status,
              Status::ok);
    options.depth = 99;
    ASSERT_EQ(conversion.begin(CheckedSolid::vouched(Solid{}), options, nullptr, 0, &*pool),
              Status::depth_out_of_range);
    EXPECT_EQ(conversion.finish().status, Status::unfinished);
}

// Begins, goes on a few steps, and is refused when it begins again.
template <class Job, class Begin>
void expect_no_old_progress(const char* what, Begin begin) {
    const auto job = std::make_unique<Job>();
    EXPECT_EQ(job->decided_volume(), 0U) << what;
    ASSERT_EQ(begin(*job, true), Status::ok) << what;
    std::uint64_t decided = 0;
    for (int i = 0; i < 100 && decided == 0; ++i) {
        ASSERT_TRUE(job->step(1)) << what;
        decided = job->decided_volume();
    }
    ASSERT_NE(decided, 0U) << what;
    EXPECT_NE(begin(*job, false), Status::ok) << what;
    EXPECT_EQ(job->decided_volume(), 0U) << what;
    EXPECT_FALSE(job->step(1)) << what;
}

TEST(Misuse, ARefusedBeginLeavesNoOldProgress) {
    HeapPool pool(10000);
    HeapPool other(10000);
    const Octree tree = planted(random_grid(4, 5, two_colours), *pool);
    const Octree with = planted(random_grid(4, 6, two_colours), *pool);
    const Octree foreign = planted(random_grid(4, 5, two_colours), *other);
    const SmallSolid solid = box_solid({{{100, 200, 300}}, {{700000, 600000, 500000}}, 1});
    std::vector<std::uint32_t> scratch(static_cast<std::size_t>(grid_scratch(solid.checked().view(), 6)));
    const auto words = static_cast<std::uint32_t>(scratch.size());
    const auto options = [](bool good) {
        ConvertOptions all;
        all.depth = good ? 6 : 0;
        return all;
    };
    expect_no_old_progress<Conversion>("conversion", [&](Conversion& job, bool good) {
        return job.begin(solid.checked(), options(good), scratch.data(), words, &*pool);
    });
    expect_no_old_progress<GridConversion>("grids", [&](GridConversion& job, bool good) {
        const Status status = job.begin(solid.checked(), options(good), scratch.data(), words, &*pool, {1});
        EXPECT_EQ(job.scratch_used(), 0U);
        EXPECT_EQ(job.grids_visited(), 0U);
        EXPECT_EQ(job.nodes_counted(), 0U);
        return status;
    });
    expect_no_old_progress<Combination>("Boolean", [&](Combination& job, bool good) {
        return job.begin(Operator::unite, tree, good ? with : foreign, *pool);
    });
    expect_no_old_progress<Coarsening>("coarsening", [&](Coarsening& job, bool good) {
        return job.begin(tree, good ? 3 : 0, Coarse::certified, *pool);
    });
    expect_no_old_progress<Reorientation>("reorientation", [&](Reorientation& job, bool good) {
        return job.begin(good ? tree : foreign, Symmetry::nth(1), *pool);
    });
    expect_no_old_progress<Translation>("translation", [&](Translation& job, bool good) {
        Placement placement;
        placement.cut_at_root = true;
        placement.by = {{root_side / 16, 0, 0}};
        return job.begin(good ? tree : foreign, placement, *pool);
    });
    expect_no_old_progress<Fitting>("fitting", [&](Fitting& job, bool good) {
        return job.begin(solid.checked(), options(good), scratch.data(), words, *pool);
    });
    const CsgToken token = CsgToken::of(0);
    CsgTree walked(tree);
    const CsgOperand operand(walked);
    expect_no_old_progress<CsgConversion>("expression", [&](CsgConversion& job, bool good) {
        CsgOptions all;
        all.depth = good ? 4 : 0;
        return job.begin(&token, 1, &operand, 1, all, &*other).status;
    });
}

TEST(Misuse, BeginningAgainGivesUpWhatWasOpen) {
    HeapPool pool(100);
    TreeBuilder builder;
    for (int round = 0; round < 3; ++round) {
        builder.begin(&*pool);
        builder.open(0);
        builder.open(3);
        builder.leaf(1, Colour::black);
        builder.close();
        builder.close(); // writes a node
        EXPECT_EQ(pool->used(), 1U);
    }
    EXPECT_EQ(builder.finish(3).status, Status::unfinished);
    EXPECT_EQ(pool->used(), 0U);
}

TEST(Misuse, FinishingTwiceGivesTheSameTree) {
    HeapPool pool(100);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.open(0);
    builder.leaf(1, Colour::black);
    builder.close();
    builder.close();
    const TreeOutcome first = builder.finish(2);
    const TreeOutcome second = builder.finish(2);
    ASSERT_EQ(first.status, Status::ok);
    ASSERT_EQ(second.status, Status::ok);
    EXPECT_EQ(first.tree.top, second.tree.top);
    EXPECT_EQ(pool->used(), 1U);
}

} // namespace

} // namespace osem::tests
