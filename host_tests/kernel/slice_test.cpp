// Slices against a grid in which every pixel is found by looking at its cells one by one.
#include <gtest/gtest.h>

#include <vector>

#include "osem/slice.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/slices.hpp"

namespace osem::tests {

namespace {

// Runs, and how many of them a sink takes before it refuses.
struct TakenRuns {
    std::vector<PixelRun> runs;
    std::size_t most = SIZE_MAX;

    static bool take(void* context, const PixelRun& run) {
        auto& self = *static_cast<TakenRuns*>(context);
        if (self.runs.size() == self.most) return false;
        self.runs.push_back(run);
        return true;
    }
    RunSink sink() { return {take, this}; }
};

struct TakenRows {
    std::vector<std::vector<std::uint8_t>> rows;
    std::size_t most = SIZE_MAX;

    static bool take(void* context, std::int32_t row, const std::uint8_t* bytes, std::size_t count) {
        auto& self = *static_cast<TakenRows*>(context);
        EXPECT_EQ(static_cast<std::size_t>(row), self.rows.size());
        if (self.rows.size() == self.most) return false;
        self.rows.emplace_back(bytes, bytes + count);
        return true;
    }
    RowSink sink() { return {take, this}; }
};

bool same_run(const PixelRun& a, const PixelRun& b) {
    return a.row == b.row && a.start == b.start && a.length == b.length && a.colour == b.colour;
}

void expect_walk(const Octree& tree, const Slice& slice, const Rows& expected) {
    RowWalk walk;
    ASSERT_EQ(walk.begin(tree, slice), Status::ok);
    PixelRun run = {};
    ASSERT_FALSE(walk.next(run));
    ASSERT_EQ(walk.rows(), 1 << slice.level);
    for (int row = walk.rows() - 1; row >= 0; --row) { // in any order
        walk.enter(row);
        for (const PixelRun& wanted : runs_of(expected[static_cast<std::size_t>(row)], row, true)) {
            ASSERT_TRUE(walk.next(run));
            ASSERT_TRUE(same_run(run, wanted)) << "row " << row << ", pixel " << run.start;
        }
        ASSERT_FALSE(walk.next(run));
        ASSERT_FALSE(walk.next(run));
    }
}

void expect_runs(const Octree& tree, const Slice& slice, const Rows& expected, std::uint32_t budget) {
    std::vector<PixelRun> wanted;
    for (std::size_t row = 0; row < expected.size(); ++row) {
        const std::vector<PixelRun> more = runs_of(expected[row], static_cast<int>(row), false);
        wanted.insert(wanted.end(), more.begin(), more.end());
    }
    TakenRuns taken;
    RunSlicing job;
    ASSERT_EQ(job.begin(tree, slice, taken.sink()), Status::ok);
    while (job.step(budget)) {
    }
    const SliceOutcome outcome = job.finish();
    ASSERT_EQ(outcome.status, Status::ok);
    ASSERT_EQ(outcome.rows, 1 << slice.level);
    ASSERT_EQ(taken.runs.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_TRUE(same_run(taken.runs[i], wanted[i])) << i;
}

void expect_bitmap(const Octree& tree, const Slice& slice, const Rows& expected, Bits bits,
                   std::uint32_t budget) {
    std::vector<std::uint8_t> buffer(slice_buffer(slice.level, bits), 0xaa);
    TakenRows taken;
    BitmapSlicing job;
    ASSERT_EQ(job.begin(tree, slice, bits, buffer.data(), buffer.size(), taken.sink()), Status::ok);
    while (job.step(budget)) {
    }
    ASSERT_EQ(job.finish().status, Status::ok);
    ASSERT_EQ(taken.rows.size(), expected.size());
    for (std::size_t row = 0; row < expected.size(); ++row) {
        std::vector<std::uint8_t> wanted;
        for (const bool inner : {false, true}) {
            if (bits == (inner ? Bits::outer : Bits::inner)) continue;
            const std::vector<std::uint8_t> more = bits_of(expected[row], inner);
            wanted.insert(wanted.end(), more.begin(), more.end());
        }
        ASSERT_EQ(taken.rows[row], wanted) << "row " << row;
    }
}

// Every axis, every layer of cells with its first and its last cell of side 1, every level.
template <class Check>
void for_every_slice(const DenseGrid& grid, const Check& check) {
    for (const Axis axis : {axis_x, axis_y, axis_z}) {
        for (int layer = 0; layer < 1 << grid.depth(); ++layer) {
            for (int level = 0; level <= grid.depth(); ++level) {
                const std::int32_t first = layer * grid.cell_side();
                const std::int32_t cell = (layer + level) % 2 == 0 ? first : first + grid.cell_side() - 1;
                const Slice slice = {axis, cell, static_cast<std::uint8_t>(level)};
                check(slice, expected_rows(grid, slice));
                if (testing::Test::HasFatalFailure()) {
                    FAIL() << "axis " << int{axis} << ", layer " << layer << ", level " << level;
                }
            }
        }
    }
}

TEST(Slices, EveryLayerAxisAndLevelInEveryForm) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(6000);
        const Octree tree = planted(grid, *pool);
        for_every_slice(grid, [&](const Slice& slice, const Rows& expected) {
            const std::uint32_t budget = 1 + seed % 5;
            ASSERT_NO_FATAL_FAILURE(expect_walk(tree, slice, expected));
            ASSERT_NO_FATAL_FAILURE(expect_runs(tree, slice, expected, budget));
            for (const Bits bits : {Bits::outer, Bits::inner, Bits::both}) {
                ASSERT_NO_FATAL_FAILURE(expect_bitmap(tree, slice, expected, bits, budget));
            }
        });
        ASSERT_FALSE(testing::Test::HasFatalFailure()) << "seed " << seed;
    }
}

TEST(Slices, AUniformRootIsOneRunARow) {
    HeapPool pool(1);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const Octree tree = Octree::uniform(*pool, colour);
        for (std::uint8_t level = 0; level <= 1; ++level) {
            const Rows rows(std::size_t{1} << level, Row(std::size_t{1} << level, colour));
            const Slice slice = {axis_y, root_side - 1, level};
            expect_walk(tree, slice, rows);
            expect_runs(tree, slice, rows, 1);
            expect_bitmap(tree, slice, rows, Bits::both, 1);
        }
    }
}

TEST(Slices, TheSinkRefusesAtEveryRowAndEveryRun) {
    const DenseGrid grid = random_grid(4, 11, three_colours);
    HeapPool pool(6000);
    const Octree tree = planted(grid, *pool);
    const Slice slice = {axis_x, root_side / 2, 4};
    std::vector<std::uint8_t> buffer(slice_buffer(4, Bits::both));
    for (std::size_t most = 0; most < 16; ++most) {
        TakenRows taken;
        taken.most = most;
        BitmapSlicing job;
        ASSERT_EQ(job.begin(tree, slice, Bits::both, buffer.data(), buffer.size(), taken.sink()), Status::ok);
        while (job.step(3)) {
        }
        EXPECT_FALSE(job.step(3));
        const SliceOutcome outcome = job.finish();
        EXPECT_EQ(outcome.status, Status::sink_refused);
        EXPECT_EQ(outcome.rows, static_cast<std::int32_t>(most));
        EXPECT_EQ(taken.rows.size(), most);
    }
    TakenRuns all;
    RunSlicing whole;
    ASSERT_EQ(whole.begin(tree, slice, all.sink()), Status::ok);
    EXPECT_FALSE(whole.step(UINT32_MAX));
    ASSERT_GT(all.runs.size(), 20U);
    for (std::size_t most = 0; most < all.runs.size(); ++most) {
        TakenRuns taken;
        taken.most = most;
        RunSlicing job;
        ASSERT_EQ(job.begin(tree, slice, taken.sink()), Status::ok);
        EXPECT_FALSE(job.step(UINT32_MAX));
        const SliceOutcome outcome = job.finish();
        EXPECT_EQ(outcome.status, Status::sink_refused);
        EXPECT_EQ(outcome.rows, all.runs[most].row);
        EXPECT_EQ(taken.runs.size(), most);
    }
}

TEST(Slices, WhatIsOutOfRangeIsRefused) {
    HeapPool pool(100);
    const Octree tree = planted(random_grid(2, 5, two_colours), *pool);
    std::uint8_t buffer[2] = {};
    TakenRows rows;
    TakenRuns runs;
    for (const std::int32_t cell : {-1, root_side}) {
        RunSlicing job;
        EXPECT_EQ(job.begin(tree, {axis_x, cell, 2}, runs.sink()), Status::point_off_root);
        EXPECT_FALSE(job.step(1));
        EXPECT_EQ(job.finish().status, Status::unfinished);
    }
    BitmapSlicing job;
    EXPECT_EQ(job.begin(tree, {axis_x, 0, 3}, Bits::outer, buffer, 2, rows.sink()),
              Status::level_out_of_range);
    EXPECT_EQ(job.begin(tree, {axis_x, 0, 2}, Bits::both, buffer, 1, rows.sink()), Status::scratch_too_small);
    EXPECT_FALSE(job.step(1));
    EXPECT_EQ(job.finish().status, Status::unfinished);
    EXPECT_EQ(job.begin(tree, {axis_x, 0, 2}, Bits::both, buffer, 2, rows.sink()), Status::ok);
    EXPECT_TRUE(job.step(3));
    EXPECT_EQ(job.finish().status, Status::unfinished);
    EXPECT_EQ(rows.rows.size(), 3U);
    EXPECT_TRUE(runs.runs.empty());
}

// Two cells of side 1 in a tree of depth 20, one at each end of the root's diagonal.
Octree two_cells(NodePool& pool) {
    TreeBuilder builder;
    builder.begin(&pool);
    for (const unsigned child : {0U, 7U}) {
        for (int level = 1; level < max_depth; ++level) builder.open(child);
        builder.leaf(child, Colour::black);
        for (int level = 1; level < max_depth; ++level) builder.close();
    }
    builder.close();
    return builder.finish(max_depth).tree;
}

TEST(Slices, ExactAtDepth20) {
    HeapPool pool(200);
    const Octree tree = two_cells(*pool);
    for (const Axis axis : {axis_x, axis_y, axis_z}) {
        for (const std::int32_t end : {0, root_side - 1}) {
            RowWalk walk;
            ASSERT_EQ(walk.begin(tree, {axis, end, max_depth}), Status::ok);
            walk.enter(end);
            PixelRun first = {};
            PixelRun second = {};
            ASSERT_TRUE(walk.next(first));
            ASSERT_TRUE(walk.next(second));
            const PixelRun& cell = end == 0 ? first : second;
            const PixelRun& rest = end == 0 ? second : first;
            EXPECT_TRUE(same_run(cell, {end, end, 1, Colour::black}));
            EXPECT_TRUE(same_run(rest, {end, end == 0 ? 1 : 0, root_side - 1, Colour::white}));
            EXPECT_FALSE(walk.next(first));
            EXPECT_EQ(walk.nodes_visited(), 20U);
            walk.enter(root_side / 2); // in a child that has no node in the layer
            ASSERT_TRUE(walk.next(first));
            EXPECT_TRUE(same_run(first, {root_side / 2, 0, root_side, Colour::white}));
        }
    }
    TakenRuns taken;
    RunSlicing job;
    ASSERT_EQ(job.begin(tree, {axis_z, 0, max_depth}, taken.sink()), Status::ok);
    EXPECT_TRUE(job.step(1));
    ASSERT_EQ(taken.runs.size(), 1U);
    std::vector<std::uint8_t> buffer(slice_buffer(max_depth, Bits::inner), 0xff);
    EXPECT_EQ(buffer.size(), 131072U);
    TakenRows rows;
    BitmapSlicing bitmap;
    ASSERT_EQ(
        bitmap.begin(tree, {axis_z, 0, max_depth}, Bits::inner, buffer.data(), buffer.size(), rows.sink()),
        Status::ok);
    EXPECT_TRUE(bitmap.step(2));
    ASSERT_EQ(rows.rows.size(), 2U);
    EXPECT_EQ(rows.rows[0][0], 0x80);
    EXPECT_EQ(rows.rows[1], std::vector<std::uint8_t>(131072));
}

// At the tree's depth a row visits each node whose octant it passes through, and no other.
TEST(Slices, ARowVisitsTheNodesOnIt) {
    const DenseGrid grid = random_grid(4, 21, three_colours);
    HeapPool pool(6000);
    const Octree tree = planted(grid, *pool);
    for (const Axis axis : {axis_x, axis_y, axis_z}) {
        for (std::int32_t row = 0; row < 16; ++row) {
            const std::int32_t cell = (15 - row) * grid.cell_side();
            std::uint64_t met = 0;
            for (NodeWalk walk(tree); !walk.done(); walk.next()) {
                const Octant& o = walk.octant();
                const std::int32_t layer = cell - o.corner.at[axis];
                const std::int32_t line = row * grid.cell_side() - o.corner.at[slice_across[axis]];
                met += layer >= 0 && layer < o.side() && line >= 0 && line < o.side() ? 1U : 0U;
            }
            RowWalk walk;
            ASSERT_EQ(walk.begin(tree, {axis, cell, 4}), Status::ok);
            walk.enter(row);
            for (PixelRun run = {}; walk.next(run);) {
            }
            EXPECT_EQ(walk.nodes_visited(), met);
        }
    }
}

// A pixel of several leaves is boundary as soon as two colours of it are known.
TEST(Slices, APixelIsLookedIntoUpToItsSecondColour) {
    DenseGrid grid = random_grid(3, 22, two_colours);
    for (std::size_t cell = 0; cell < 16; ++cell) grid[cell] = cell < 8 ? Colour::white : Colour::black;
    HeapPool pool(1000);
    const Octree tree = planted(grid, *pool); // the first two octants of the first node below the top
    RowWalk walk;
    ASSERT_EQ(walk.begin(tree, {axis_z, 0, 0}), Status::ok);
    walk.enter(0);
    PixelRun run = {};
    ASSERT_TRUE(walk.next(run));
    EXPECT_EQ(run.colour, Colour::boundary);
    EXPECT_EQ(walk.nodes_visited(), 2U); // the top and that node
}

TEST(Slices, NoRowIsEnteredAtTheBeginning) {
    DenseGrid grid(2, Colour::white);
    grid[0] = Colour::black;
    HeapPool pool(10);
    const Octree tree = planted(grid, *pool);
    RowWalk walk;
    PixelRun run = {};
    for (int round = 0; round < 2; ++round) { // nor is what was left of another one
        ASSERT_EQ(walk.begin(tree, {axis_z, 0, 2}), Status::ok);
        EXPECT_FALSE(walk.next(run));
        walk.enter(0);
        EXPECT_TRUE(walk.next(run));
    }
}

// Rows of four bytes and more: runs that begin and end in any of them.
TEST(Slices, LongRunsFillTheBytesBetween) {
    for (const int level : {5, 6}) {
        const DenseGrid grid = make_grid(level, [](const Point& corner, std::int32_t side) {
            const std::int32_t pixels = root_side / side;
            const std::int32_t x = corner.x() / side;
            const std::int32_t y = corner.y() / side;
            if (corner.z() / side != pixels / 2) return Colour::white;
            return x >= y / 2 && x < pixels - y / 3 ? (y % 3 == 0 ? Colour::boundary : Colour::black)
                                                    : Colour::white;
        });
        HeapPool pool(6000);
        const Octree tree = planted(grid, *pool);
        const Slice slice = {axis_z, root_side / 2, static_cast<std::uint8_t>(level)};
        const Rows expected = expected_rows(grid, slice);
        for (const Bits bits : {Bits::outer, Bits::inner, Bits::both}) {
            expect_bitmap(tree, slice, expected, bits, 7);
        }
    }
}

} // namespace

} // namespace osem::tests
