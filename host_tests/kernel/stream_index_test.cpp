// An index of a stream: what it says of where subtrees end, and what is passed by it.
#include "osem/stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "osem/stream_boolean.hpp"
#include "osem/stream_cursor.hpp"
#include "osem/stream_query.hpp"
#include "support/stream_samples.hpp"
#include "support/stream_sink.hpp"

namespace osem::tests {

namespace {

// What is to come, octant by octant.
Bytes plain_index(const std::vector<Colour>& colours) {
    constexpr std::size_t block = 256; // octants
    Bytes index;
    unsigned to_come = 1;
    for (std::size_t first = 0; first < colours.size(); first += block) {
        const unsigned before = to_come;
        unsigned least = to_come;
        for (std::size_t at = first; at < std::min(first + block, colours.size()); ++at) {
            to_come += colours[at] == Colour::grey ? 7U : ~0U;
            least = std::min(least, to_come);
        }
        index.push_back(static_cast<std::uint8_t>(before));
        index.push_back(static_cast<std::uint8_t>(least));
    }
    return index;
}

TEST(SubtreeIndex, AnIndexSaysWhatIsToCome) {
    std::size_t most = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const Sample sample = sample_of(seed);
        const Bytes bytes = sample.bytes();
        const Bytes expected = plain_index(colours_of(sample.part));
        ASSERT_EQ(index_of(bytes), expected) << seed;
        most = std::max(most, expected.size());
        Bytes index(expected.size() - 1);
        Source known = source_of(bytes, true);
        known.index = expected.data();
        const StreamCheckOutcome refused = check_stream(known, index.data(), index.size());
        EXPECT_EQ(refused.status, Status::scratch_too_small);
        EXPECT_FALSE(refused.source.checked);
        EXPECT_EQ(refused.source.index, nullptr);
        EXPECT_TRUE(std::all_of(index.begin(), index.end(), [](std::uint8_t byte) { return byte == 0; }));
    }
    EXPECT_GT(most, 40U);
}

// The fault is that which is found without an index; then there is none.
TEST(SubtreeIndex, DamagedStreamsHaveNoIndex) {
    std::mt19937 random(13);
    const Bytes whole = Sample{grey_part(4, 10, three_colours, random), 4}.bytes();
    for (std::size_t size = 0; size < whole.size() + 2; ++size) {
        Bytes bytes = whole;
        bytes.resize(size);
        if (size >= whole.size())
            bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1 + random() % 255);
        Bytes index(size);
        const StreamCheckOutcome plain = check_stream(source_of(bytes));
        const StreamCheckOutcome outcome = check_stream(source_of(bytes), index.data(), index.size());
        ASSERT_NE(outcome.status, Status::ok);
        EXPECT_EQ(outcome.status, plain.status) << size;
        EXPECT_EQ(outcome.offset, plain.offset) << size;
        EXPECT_FALSE(outcome.source.checked);
        EXPECT_EQ(outcome.source.index, nullptr);
        EXPECT_EQ(outcome.source.size, size);
    }
}

TEST(SubtreeIndex, AReadThatFailsLeavesNoIndex) {
    const Bytes bytes = sample_of(3).bytes();
    Bytes index(bytes.size());
    for (std::size_t at = 0;; ++at) {
        TestSource source(bytes);
        source.fail_at = at;
        const StreamCheckOutcome outcome = check_stream(source.source(), index.data(), index.size());
        if (outcome.status == Status::ok) {
            EXPECT_GT(at, 2U);
            break;
        }
        EXPECT_EQ(outcome.status, Status::source_failed);
        EXPECT_EQ(outcome.offset, source.asked_at);
        EXPECT_EQ(outcome.source.index, nullptr);
    }
}

// Most of it is not even read.
TEST(SubtreeIndex, AnIndexSavesReads) {
    std::mt19937 random(14);
    const Bytes bytes = Sample{grey_part(6, 12, two_colours, random), 6}.bytes();
    const Place from(bytes, Known::indexed, true);
    ASSERT_GT(bytes.size(), 10000U);
    for (const Known known : {Known::checked, Known::indexed}) {
        TestSource source(bytes);
        source.checked = true;
        source.index = known == Known::indexed ? from.reader.index : nullptr;
        const Point last = {{root_side - 1, root_side - 1, root_side - 1}};
        ASSERT_EQ(leaf_at(source.source(), last).point.leaf.colour,
                  leaf_at(source_of(bytes), last).point.leaf.colour);
        if (known == Known::checked) {
            EXPECT_GT(source.reads, bytes.size() / 64);
        } else {
            EXPECT_LT(source.reads, 130U); // two a child that goes by
        }
    }
}

// Whatever is passed: the rest of what is looked at first, and the blocks before and behind its end.
TEST(SubtreeIndex, ASkipByAnIndexReadsThreeTimesAtMost) {
    std::mt19937 random(17);
    for (int round = 0; round < 6; ++round) {
        const Bytes bytes = Sample{grey_part(6, 7, two_colours, random), 6}.bytes();
        Place from(bytes, Known::indexed, true);
        StreamCursor cursor;
        std::size_t skips = 0;
        for (cursor.begin(from.source); !cursor.done(); cursor.next()) {
            StreamCursor skipping = cursor;
            from.reader.reads = 0;
            skips += cursor.colour() == Colour::grey ? 1U : 0U;
            skipping.skip();
            ASSERT_EQ(skipping.status(), Status::ok);
            ASSERT_LE(from.reader.reads, skipping.done() ? 4U : 3U) << "the trailer is read by itself";
        }
        EXPECT_GT(skips, 100U);
    }
}

// An index leads to the last block, which may begin with the payload's last byte: what is copied before it is
// looked at beyond its last code, but not beyond the stream. The result lies at other bits than the operand.
TEST(SubtreeIndex, AnIndexLeadsNoFurtherThanTheStream) {
    std::mt19937 random(16);
    StreamCombination job;
    std::size_t full = 0;
    for (int round = 0; round < 400 || full < 20; ++round) {
        const Part part = grey_part(4 + round % 2, 5, two_colours, random);
        const Bytes bytes = Sample{part, 5}.bytes();
        if (part.children.empty()) continue;
        const std::size_t payload = bytes.size() - stream_header_size - stream_trailer_size;
        full += payload % 64 == 1 && payload > 200 ? 1U : 0U;
        for (std::size_t removed = 0; removed < 8; ++removed) {
            std::vector<Part> children(8, Part{Colour::white, {}});
            children[removed].colour = Colour::black;
            const Part beside = {Colour::grey, children};
            const Bytes expected = Sample{combined(Operator::unite, part, beside), 5}.bytes();
            const Place from(bytes, Known::indexed, false);
            const Bytes beside_bytes = Sample{beside, 1}.bytes();
            const Place other(beside_bytes, Known::checked, false);
            TestSink result;
            ASSERT_EQ(combine(job, Operator::unite, from.source, other.source, result.sink()).status,
                      Status::ok);
            ASSERT_EQ(result.bytes, expected) << round;
        }
    }
}

TEST(SubtreeIndex, APointsLeafIsTheSameHoweverMuchIsKnown) {
    std::mt19937 random(15);
    for (int round = 0; round < 40; ++round) {
        const int depth = 1 + round % 6;
        const Bytes bytes = Sample{grey_part(depth, 9, three_colours, random), depth}.bytes();
        for (int i = 0; i < 40; ++i) {
            Point cell;
            for (std::int32_t& coordinate : cell.at)
                coordinate = static_cast<std::int32_t>(random() % root_side);
            const StreamPointOutcome expected = leaf_at(source_of(bytes), cell);
            for (const unsigned way : {1U, 2U, 4U, 5U}) {
                const Place from(bytes, all_known[way % 3], way / 3 != 0);
                const StreamPointOutcome outcome = leaf_at(from.source, cell);
                ASSERT_EQ(outcome.point.status, Status::ok);
                ASSERT_EQ(outcome.point.leaf.colour, expected.point.leaf.colour);
                ASSERT_EQ(outcome.point.leaf.octant.corner, expected.point.leaf.octant.corner);
                ASSERT_EQ(outcome.point.leaf.octant.level, expected.point.leaf.octant.level);
                ASSERT_EQ(outcome.offset, expected.offset);
                ASSERT_LE(outcome.point.visited, expected.point.visited);
                ASSERT_LE(outcome.point.visited, 1U + 8U * static_cast<unsigned>(depth));
            }
        }
    }
}

} // namespace

} // namespace osem::tests
