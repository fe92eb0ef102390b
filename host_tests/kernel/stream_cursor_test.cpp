// Walking a stream where it lies, against the colours the stream was made of.
#include "osem/stream_cursor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/stream_source.hpp"

namespace osem::tests {

namespace {

constexpr std::uint32_t sample_count = 60;

// The last one takes many reads, with nodes wherever there can be one.
DenseGrid sample_of(std::uint32_t seed) {
    if (seed + 1 < sample_count) return grid_of(seed);
    DenseGrid grid(5);
    std::mt19937 random(seed);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        grid[cell] = three_colours[random() % three_colours.size()];
    }
    return grid;
}

// The octants of a grid's tree in preorder, by plain recursion.
struct Place {
    Octant octant;
    Colour colour;
    std::size_t behind; ///< the place behind its subtree
};

void append_places(std::vector<Place>& places, const std::vector<Colour>& colours, const Octant& octant) {
    const std::size_t at = places.size();
    places.push_back({octant, colours.at(at), 0});
    for (unsigned k = 0; k < 8 && colours[at] == Colour::grey; ++k) {
        append_places(places, colours, octant.child(k));
    }
    places[at].behind = places.size();
}

std::vector<Place> places_of(const DenseGrid& grid) {
    std::vector<Place> places;
    append_places(places, preorder_colours(preorder_masks(grid)), root_octant);
    return places;
}

void expect_at(const StreamCursor& cursor, const std::vector<Place>& places, std::size_t at) {
    ASSERT_EQ(cursor.done(), at == places.size()) << at;
    ASSERT_EQ(cursor.status(), Status::ok) << at;
    if (at == places.size()) return;
    const Octant& octant = places[at].octant;
    ASSERT_EQ(cursor.colour(), places[at].colour) << at;
    ASSERT_EQ(cursor.octant().corner, octant.corner) << at;
    ASSERT_EQ(cursor.level(), octant.level) << at;
    ASSERT_EQ(cursor.offset(), stream_header_size + at / 4) << at;
    std::uint16_t codes = 0;
    bool leaves = places[at].colour == Colour::grey;
    unsigned expected = 0;
    for (unsigned k = 0; leaves && k < 8; ++k) {
        leaves = places[at + 1 + k].colour != Colour::grey;
        expected |= static_cast<unsigned>(places[at + 1 + k].colour) << (2 * k);
    }
    ASSERT_EQ(cursor.leaf_children(codes), leaves) << at;
    if (leaves) {
        ASSERT_EQ(codes, expected) << at;
    }
}

// Of the bytes as they come, and of those that were checked before.
class StreamCursorOf : public testing::TestWithParam<bool> {
  protected:
    static Source source_to_walk(const Bytes& bytes) {
        if (!GetParam()) return source_of(bytes);
        const StreamCheckOutcome checked = check_stream(source_of(bytes));
        EXPECT_EQ(checked.status, Status::ok);
        EXPECT_EQ(checked.offset, bytes.size());
        return checked.source;
    }
};

TEST_P(StreamCursorOf, MeetsEveryOctantInPreorder) {
    for (std::uint32_t seed = 0; seed < sample_count; ++seed) {
        const DenseGrid grid = sample_of(seed);
        const Bytes bytes = stream_of(grid);
        const std::vector<Place> places = places_of(grid);
        StreamCursor cursor;
        ASSERT_EQ(cursor.begin(source_to_walk(bytes)), Status::ok);
        EXPECT_EQ(cursor.header().depth, grid.depth());
        for (std::size_t at = 0; at < places.size(); ++at, cursor.next()) expect_at(cursor, places, at);
        expect_at(cursor, places, places.size());
        EXPECT_EQ(cursor.offset(), bytes.size());
        std::uint32_t checksum = 0; // the last four bytes
        for (std::size_t i = 1; i <= 4; ++i) checksum = checksum << 8 | bytes[bytes.size() - i];
        EXPECT_EQ(cursor.checksum(), checksum);
    }
}

TEST_P(StreamCursorOf, SkipsAndLeafGroupsLeadToTheSamePlaces) {
    for (std::uint32_t seed = 0; seed < sample_count; ++seed) {
        const DenseGrid grid = sample_of(seed);
        const Bytes bytes = stream_of(grid);
        const std::vector<Place> places = places_of(grid);
        StreamCursor walk;
        ASSERT_EQ(walk.begin(source_to_walk(bytes)), Status::ok);
        for (std::size_t at = 0; at < places.size(); ++at, walk.next()) {
            StreamCursor cursor = walk; // from every octant
            cursor.skip();
            expect_at(cursor, places, places[at].behind);
            cursor = walk;
            std::uint16_t codes = 0;
            const bool leaves = cursor.leaf_children(codes);
            cursor.next_or_leaves();
            expect_at(cursor, places, leaves ? places[at].behind : at + 1);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, StreamCursorOf, testing::Bool());

TEST(StreamCursor, ASourceMayFailAtEveryRead) {
    const Bytes bytes = stream_of(random_grid(4, 3, three_colours));
    for (const unsigned way : {0U, 1U, 2U, 3U}) {
        const auto walk = [&](TestSource& source) {
            source.checked = way % 2 != 0;
            StreamCursor cursor;
            cursor.begin(source.source());
            while (!cursor.done()) way / 2 != 0 ? cursor.skip() : cursor.next();
            return cursor;
        };
        TestSource whole(bytes);
        ASSERT_EQ(walk(whole).status(), Status::ok);
        ASSERT_GT(whole.reads, 3U);
        for (std::size_t at = 0; at < whole.reads; ++at) {
            TestSource source(bytes);
            source.fail_at = at;
            const StreamCursor cursor = walk(source);
            EXPECT_EQ(cursor.status(), Status::source_failed);
            EXPECT_EQ(cursor.offset(), source.asked_at);
            EXPECT_EQ(source.reads, at) << "a read after a refusal";
        }
    }
}

// What the reader says of a stream, a walk says of it too: at any length, and after a change of any byte.
void expect_like_reader(const Bytes& bytes, const std::string& what) {
    StreamReader reader;
    StreamOutcome expected = read_stream(reader, bytes, nullptr);
    const bool sized = !reader.has_header() || bytes.size() == stream_size(reader.header().nodes);
    if (!sized) { // the walk is told the size and need not go there
        const std::uint64_t size = stream_size(reader.header().nodes);
        expected.built.status =
            bytes.size() < size ? Status::stream_truncated : Status::stream_trailing_bytes;
        expected.offset = std::min<std::uint64_t>(bytes.size(), size);
    }
    for (void (StreamCursor::*const go_on)() :
         {&StreamCursor::next, &StreamCursor::next_or_leaves, &StreamCursor::skip}) {
        StreamCursor cursor;
        cursor.begin(source_of(bytes));
        while (!cursor.done()) (cursor.*go_on)();
        EXPECT_EQ(cursor.status(), expected.built.status) << what << ": " << describe(cursor.status());
        EXPECT_EQ(cursor.offset(), expected.offset) << what;
    }
    const StreamCheckOutcome checked = check_stream(source_of(bytes));
    EXPECT_EQ(checked.status, expected.built.status) << what;
    EXPECT_EQ(checked.offset, expected.offset) << what;
    EXPECT_EQ(checked.source.checked, checked.status == Status::ok) << what;
}

TEST(StreamCursor, DamageIsFoundAsByTheReader) {
    const Bytes whole = stream_of(random_grid(3, 5, three_colours));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        expect_like_reader(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)),
                           "length " + std::to_string(length));
    }
    Bytes longer = whole;
    longer.push_back(0);
    expect_like_reader(longer, "a byte too many");
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (unsigned change = 1; change < 256; ++change) {
            Bytes bytes = whole;
            bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ change);
            expect_like_reader(bytes, "byte " + std::to_string(at) + " changed by " + std::to_string(change));
        }
    }
}

TEST(StreamCursor, HostileFormsWithRightChecksums) {
    const Masks masks = preorder_masks(random_grid(3, 5, three_colours));
    for (std::size_t at = 0; at < 2 * masks.size() + 1; ++at) {
        for (unsigned change = 1; change < 256; ++change) {
            StreamModel model(3, masks);
            model.payload[at] = static_cast<std::uint8_t>(model.payload[at] ^ change);
            expect_like_reader(model.bytes(), "payload " + std::to_string(at));
        }
    }
    for (const std::uint32_t nodes : {0U, 1U, static_cast<std::uint32_t>(masks.size()) + 1, UINT32_MAX}) {
        StreamModel model(3, masks);
        model.nodes = nodes;
        model.payload.resize(std::min<std::size_t>(2 * std::size_t{nodes} + 1, 400));
        expect_like_reader(model.bytes(), std::to_string(nodes) + " nodes");
    }
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        std::vector<Colour> eight_alike(9, colour);
        eight_alike[0] = Colour::grey;
        expect_like_reader(StreamModel(3, eight_alike).bytes(), "eight equal leaves");
    }
}

TEST(StreamCursor, NothingBegunIsDone) {
    const StreamCursor cursor;
    EXPECT_TRUE(cursor.done());
    EXPECT_EQ(cursor.status(), Status::unfinished);
}

} // namespace

} // namespace osem::tests
