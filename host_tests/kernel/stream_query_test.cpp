// What is asked of a tree in a stream, against the same question asked of a pool's tree and of a dense grid.
#include "osem/stream_query.hpp"

#include <gtest/gtest.h>

#include "osem/stream_cursor.hpp"
#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/stream_source.hpp"

namespace osem::tests {

namespace {

TEST(StreamQuery, ThePointsLeafIsThatOfThePool) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        const Bytes bytes = stream_of(grid);
        for (std::size_t cell = 0; cell < grid.size(); ++cell) {
            const std::int32_t last = grid.cell_side() - 1;
            Point at = grid.corner(cell);
            if (cell % 2 != 0) at = Point{{at.x() + last, at.y() + last, at.z() + last}};
            const StreamPointOutcome outcome = leaf_at(source_of(bytes), at);
            const PointOutcome expected = leaf_at(tree, at);
            ASSERT_EQ(outcome.point.status, Status::ok);
            ASSERT_EQ(outcome.point.leaf.colour, grid[cell]);
            ASSERT_EQ(outcome.point.leaf.octant.corner, expected.leaf.octant.corner);
            ASSERT_EQ(outcome.point.leaf.octant.level, expected.leaf.octant.level);
            ASSERT_GE(outcome.point.visited, expected.leaf.octant.level + 1U);
        }
    }
}

TEST(StreamQuery, APointsCostAndItsRefusals) {
    // Child 3 of the root is grey: a point in child 1 is met after root, child 0 and child 1.
    const Bytes bytes = StreamModel(2, Masks{{0x02, 0x08}, {0x01, 0x01}}).bytes();
    EXPECT_EQ(leaf_at(source_of(bytes), Point{{root_side / 2, 0, 0}}).point.visited, 3U);
    // The octant of eight leaves counts once: a point in child 4.
    EXPECT_EQ(leaf_at(source_of(bytes), Point{{0, 0, root_side / 2}}).point.visited, 6U);
    for (const std::int32_t bad : {-1, root_side}) {
        for (int axis = 0; axis < 3; ++axis) {
            Point at = {{0, 0, 0}};
            at.at[axis] = bad;
            const StreamPointOutcome outcome = leaf_at(source_of(bytes), at);
            EXPECT_EQ(outcome.point.status, Status::point_off_root);
            EXPECT_EQ(outcome.point.leaf.colour, Colour::boundary);
        }
    }
}

TEST(StreamQuery, MeasuresAndDigestAreThoseOfThePool) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Measures expected = measure(planted(grid, *pool));
        const Bytes bytes = stream_of(grid);
        const StreamMeasures outcome = measure(source_of(bytes));
        ASSERT_EQ(outcome.status, Status::ok);
        const Measures& m = outcome.measures;
        EXPECT_EQ(m.nodes, expected.nodes);
        EXPECT_EQ(m.white_leaves, expected.white_leaves);
        EXPECT_EQ(m.black_leaves, expected.black_leaves);
        EXPECT_EQ(m.boundary_leaves, expected.boundary_leaves);
        EXPECT_EQ(m.inner_volume, expected.inner_volume);
        EXPECT_EQ(m.outer_volume, expected.outer_volume);
        const StreamDigest found = digest(source_of(bytes));
        EXPECT_EQ(found.status, Status::ok);
        EXPECT_EQ(found.digest, expected_digest(grid));
    }
}

TEST(StreamQuery, UniformRoots) {
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const DenseGrid grid(2, colour);
        const Bytes bytes = stream_of(grid);
        HeapPool pool(0);
        const Measures expected = measure(Octree::uniform(*pool, colour));
        const Measures m = measure(source_of(bytes)).measures;
        EXPECT_EQ(m.nodes, 1U);
        EXPECT_EQ(m.inner_volume, expected.inner_volume);
        EXPECT_EQ(m.outer_volume, expected.outer_volume);
        EXPECT_EQ(digest(source_of(bytes)).digest, expected_digest(grid));
        EXPECT_EQ(leaf_at(source_of(bytes), Point{{7, 8, 9}}).point.leaf.colour, colour);
    }
}

// The grid and what it is after a change of one cell.
TEST(StreamQuery, EqualityIsThatOfTheGrids) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid a = grid_of(seed);
        DenseGrid changed = a;
        const std::size_t cell = seed % a.size();
        changed[cell] = a[cell] == Colour::black ? Colour::white : Colour::black;
        const DenseGrid deeper = refined(a, a.depth() + 1);
        for (const DenseGrid* b : std::initializer_list<const DenseGrid*>{&a, &changed, &deeper}) {
            const bool same = b != &changed;
            const Bytes bytes_a = stream_of(a);
            const Bytes bytes_b = stream_of(*b);
            HeapPool pool(40000);
            for (const StreamComparison& outcome : {same_leaves(source_of(bytes_a), source_of(bytes_b)),
                                                    same_leaves(source_of(bytes_b), source_of(bytes_a)),
                                                    same_leaves(source_of(bytes_a), planted(*b, *pool))}) {
                EXPECT_EQ(outcome.status, Status::ok);
                EXPECT_EQ(outcome.same, same) << "seed " << seed;
            }
        }
    }
}

// Wherever they differ: a leaf, its octant and the ones above it may be divided in one of them only.
TEST(StreamQuery, AStreamIsComparedWithATreeCellByCell) {
    const DenseGrid grid = random_grid(3, 11, three_colours);
    const Bytes bytes = stream_of(grid);
    HeapPool pool(2000);
    const std::uint32_t mark = pool->used();
    EXPECT_TRUE(same_leaves(source_of(bytes), planted(grid, *pool)).same);
    int different = 0;
    const auto compare_with = [&](const DenseGrid& other) {
        const Bytes other_bytes = stream_of(other);
        const bool same = bytes == other_bytes;
        pool->roll_back(mark);
        EXPECT_EQ(same_leaves(source_of(bytes), planted(other, *pool)).same, same);
        pool->roll_back(mark);
        EXPECT_EQ(same_leaves(source_of(other_bytes), planted(grid, *pool)).same, same);
        if (!same) ++different;
    };
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        DenseGrid changed = grid;
        changed[cell] = grid[cell] == Colour::white ? Colour::boundary : Colour::white;
        compare_with(changed);
    }
    for (const Colour colour : three_colours) {
        compare_with(DenseGrid(3, colour));
        const DenseGrid flat(3, colour);
        pool->roll_back(mark);
        EXPECT_TRUE(same_leaves(source_of(stream_of(flat)), planted(flat, *pool)).same);
    }
    for (std::size_t part = 0; part < 8; ++part) { // an octant of one colour, or divided
        DenseGrid changed = grid;
        for (std::size_t cell = 0; cell < 64; ++cell) changed[64 * part + cell] = Colour::black;
        compare_with(changed);
    }
    EXPECT_GT(different, 515); // each cell and each colour
}

// Every query says of a damaged stream what the reader into a pool says.
TEST(StreamQuery, FaultsAreThoseOfTheReader) {
    const DenseGrid grid = random_grid(3, 5, three_colours);
    HeapPool pool(5000);
    const Octree tree = planted(grid, *pool);
    const Bytes whole = stream_of(grid);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        Bytes bytes = whole;
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 0x10U);
        HeapPool room(1000);
        StreamReader reader;
        const StreamOutcome read = read_stream(reader, bytes, &*room);
        ASSERT_NE(read.built.status, Status::ok);
        const StreamMeasures measured = measure(source_of(bytes));
        EXPECT_EQ(measured.status, read.built.status);
        EXPECT_EQ(measured.offset, read.offset);
        const StreamDigest digested = digest(source_of(bytes));
        EXPECT_EQ(digested.status, read.built.status);
        EXPECT_EQ(digested.offset, read.offset);
        for (const StreamComparison& outcome :
             {same_leaves(source_of(bytes), source_of(whole)),
              same_leaves(source_of(whole), source_of(bytes)), same_leaves(source_of(bytes), tree)}) {
            EXPECT_FALSE(outcome.same);
            if (at < stream_header_size || at >= whole.size() - stream_trailer_size) {
                EXPECT_EQ(outcome.status, read.built.status);
                EXPECT_EQ(outcome.offset, read.offset);
            }
        }
    }
    EXPECT_TRUE(same_leaves(source_of(whole), source_of(Bytes())).in_second);
    EXPECT_FALSE(same_leaves(source_of(Bytes()), source_of(whole)).in_second);
}

TEST(StreamQuery, ASourceMayFailAtEveryRead) {
    const DenseGrid grid = random_grid(4, 3, three_colours);
    const Bytes bytes = stream_of(grid);
    const auto ask = [&](TestSource& source, int which) {
        const Point last = {{root_side - 1, root_side - 1, root_side - 1}};
        if (which == 0) return leaf_at(source.source(), last).point.status;
        if (which == 1) return measure(source.source()).status;
        if (which == 2) return digest(source.source()).status;
        return same_leaves(source_of(bytes), source.source()).status;
    };
    for (int which = 0; which < 4; ++which) {
        TestSource whole(bytes);
        ASSERT_EQ(ask(whole, which), Status::ok);
        for (std::size_t at = 0; at < whole.reads; ++at) {
            if (which == 2 && at > 40) break; // digest reads ahead over and over
            TestSource source(bytes);
            source.fail_at = at;
            EXPECT_EQ(ask(source, which), Status::source_failed) << which << ", read " << at;
        }
    }
}

// A digest looks ahead, and reads again what it saw: a read refused the first time alone is a fault all the
// same.
TEST(StreamQuery, AReadRefusedOnceInALookAheadIsNamed) {
    struct Once {
        const Bytes& bytes;
        std::size_t left; // reads answered before the one that is refused
        std::uint64_t refused_at = UINT64_MAX;
        static bool read(void* context, std::uint64_t offset, std::uint8_t* to, std::size_t count) {
            auto& self = *static_cast<Once*>(context);
            if (self.left-- == 0) {
                self.refused_at = offset;
                return false;
            }
            std::copy_n(self.bytes.begin() + static_cast<std::ptrdiff_t>(offset), count, to);
            return true;
        }
    };
    const Bytes bytes = stream_of(random_grid(4, 3, three_colours));
    TestSource whole(bytes);
    ASSERT_EQ(digest(whole.source()).status, Status::ok);
    for (std::size_t at = 0; at < whole.reads; at += 1 + at / 100) {
        Once once = {bytes, at};
        const StreamDigest outcome = digest(Source{Once::read, &once, bytes.size()});
        ASSERT_EQ(outcome.status, Status::source_failed) << "read " << at;
        ASSERT_EQ(outcome.offset, once.refused_at);
    }
}

} // namespace

} // namespace osem::tests
