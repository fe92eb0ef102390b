// Skipping subtrees of a stream.
#include "osem/stream_cursor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "support/stream_samples.hpp"

namespace osem::tests {

namespace {

// Skipping the root and what the reader finds octant by octant.
void expect_skip_like_reader(StreamReader& reader, const StreamModel& model, const std::string& what) {
    const Bytes bytes = model.bytes();
    const StreamOutcome expected = read_stream(reader, bytes, nullptr);
    StreamCursor cursor;
    if (cursor.begin(source_of(bytes)) == Status::ok) cursor.skip();
    ASSERT_TRUE(cursor.done()) << what;
    ASSERT_EQ(cursor.status(), expected.built.status) << what;
    ASSERT_EQ(cursor.offset(), expected.offset) << what;
}

// As deep as the header says, less deep, and deeper; with every code changed into each other one, and the
// eight behind it into equal ones.
TEST(StreamSkip, DeepestLevelsAreCheckedAsByTheReader) {
    StreamReader reader;
    std::mt19937 random(9);
    for (int round = 0; round < 8; ++round) {
        const int depth = 2 + round % 4;
        const std::vector<Colour> colours =
            colours_of(bushy_part(depth, round % 2 == 0 ? two_colours : three_colours, random));
        for (const int stated : {depth - 1, depth, depth + 1, depth + 2}) {
            const StreamModel whole(stated, colours);
            expect_skip_like_reader(reader, whole, "depth " + std::to_string(stated));
            for (std::size_t at = 0; at < colours.size(); ++at) {
                for (unsigned change = 1; change < 4; ++change) {
                    StreamModel model = whole;
                    const unsigned changed = model.payload[at / 4] ^ change << (2 * (at % 4));
                    model.payload[at / 4] = static_cast<std::uint8_t>(changed);
                    expect_skip_like_reader(reader, model,
                                            "depth " + std::to_string(stated) + ", octant " +
                                                std::to_string(at) + ", change " + std::to_string(change));
                }
                for (std::size_t k = 0; k < 3 && at + 8 < colours.size(); ++k) {
                    std::vector<Colour> changed = colours;
                    std::fill_n(changed.begin() + static_cast<std::ptrdiff_t>(at) + 1, 8, three_colours[k]);
                    StreamModel model(stated, changed);
                    model.nodes = whole.nodes;
                    expect_skip_like_reader(reader, model, "equal ones behind " + std::to_string(at));
                }
            }
        }
    }
}

// From every octant, so from every place in a byte and in a buffer.
TEST(StreamSkip, SkippingLeadsBehindTheSubtree) {
    std::mt19937 random(10);
    for (int round = 0; round < 12; ++round) {
        const int depth = 2 + round % 4;
        const Bytes bytes = Sample{bushy_part(depth, three_colours, random), depth}.bytes();
        const Place from(bytes, all_known[round % 3], round / 3 % 2 != 0);
        std::vector<StreamCursor> places(1);
        for (places[0].begin(from.source); !places.back().done();) {
            places.push_back(places.back());
            places.back().next();
        }
        ASSERT_EQ(places.back().status(), Status::ok);
        for (std::size_t at = 0; at + 1 < places.size(); ++at) {
            std::size_t behind = at + 1;
            while (!places[behind].done() && places[behind].level() > places[at].level()) ++behind;
            StreamCursor cursor = places[at];
            const StreamCursor& itself = cursor;
            cursor = itself;
            cursor.skip();
            ASSERT_EQ(cursor.done(), places[behind].done()) << at;
            ASSERT_EQ(cursor.status(), Status::ok) << at;
            ASSERT_EQ(cursor.offset(), places[behind].offset()) << at;
            if (cursor.done()) continue;
            ASSERT_EQ(cursor.level(), places[behind].level()) << at;
            ASSERT_EQ(cursor.octant().corner, places[behind].octant().corner) << at;
        }
    }
}

} // namespace

} // namespace osem::tests
