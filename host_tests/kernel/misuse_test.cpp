// Jobs asked for a result they do not have, begun twice, or given tables that lie.
#include <vector>

#include <gtest/gtest.h>

#include "osem/osem.hpp"
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
