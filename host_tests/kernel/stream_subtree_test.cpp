// What goes by as a whole in a Boolean of streams: deep and uneven subtrees beside leaves, against trees of
// plain recursion.
#include "osem/stream_boolean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "osem/stream_cursor.hpp"
#include "osem/stream_query.hpp"
#include "support/byte_stream.hpp"
#include "support/stream_sink.hpp"
#include "support/stream_source.hpp"

namespace osem::tests {

namespace {

constexpr Operator all_operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                      Operator::exclusive_or};

// An octant: a leaf, or grey with eight children. Never eight equal leaves.
struct Part {
    Colour colour = Colour::white;
    std::vector<Part> children;
};

Part joined(std::vector<Part> children) {
    const Colour first = children.front().colour;
    const bool one_leaf =
        first != Colour::grey && std::all_of(children.begin(), children.end(),
                                             [first](const Part& child) { return child.colour == first; });
    if (one_leaf) return {first, {}};
    return {Colour::grey, std::move(children)};
}

// Each octant is grey with a chance of `grey` in 16; thin trees reach deep, dense ones are full of leaf
// groups.
Part random_part(int levels, unsigned grey, const std::vector<Colour>& palette, std::mt19937& random) {
    if (levels == 0 || random() % 16 >= grey) return {palette[random() % palette.size()], {}};
    std::vector<Part> children;
    for (unsigned k = 0; k < 8; ++k) children.push_back(random_part(levels - 1, grey, palette, random));
    return joined(std::move(children));
}

// One that is grey, mostly.
Part grey_part(int levels, unsigned grey, const std::vector<Colour>& palette, std::mt19937& random) {
    std::vector<Part> children;
    for (unsigned k = 0; k < 8; ++k) children.push_back(random_part(levels - 1, grey, palette, random));
    return joined(std::move(children));
}

Part combined(Operator op, const Part& a, const Part& b) {
    if (a.children.empty() && b.children.empty()) return {combine_colours(op, a.colour, b.colour), {}};
    std::vector<Part> children;
    for (std::size_t k = 0; k < 8; ++k) {
        children.push_back(
            combined(op, a.children.empty() ? a : a.children[k], b.children.empty() ? b : b.children[k]));
    }
    return joined(std::move(children));
}

void append_colours(std::vector<Colour>& colours, const Part& part) {
    colours.push_back(part.colour);
    for (const Part& child : part.children) append_colours(colours, child);
}

std::vector<Colour> colours_of(const Part& part) {
    std::vector<Colour> colours;
    append_colours(colours, part);
    return colours;
}

struct Sample {
    Part part;
    int depth;

    Bytes bytes() const { return StreamModel(depth, colours_of(part)).bytes(); }
};

// Of every depth and of two or three colours; dense ones are flat.
Sample sample_of(std::uint32_t seed) {
    std::mt19937 random(seed);
    const int depth = 1 + static_cast<int>(random() % max_depth);
    const unsigned grey = depth > 7 ? 2 : 3 + static_cast<unsigned>(random() % (depth > 4 ? 3 : 10));
    return {grey_part(depth, grey, random() % 2 == 0 ? two_colours : three_colours, random), depth};
}

bool append(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& all = *static_cast<Bytes*>(context);
    all.insert(all.end(), bytes, bytes + count);
    return true;
}

// A stream that lies in memory, or one that must be read.
struct Place {
    Place(const Bytes& bytes, Known known, bool read)
        : exact(bytes), index(known == Known::indexed ? index_of(bytes) : Bytes()), reader(bytes) {
        reader.checked = known != Known::nothing;
        reader.index = index.empty() ? nullptr : index.data();
        source = read ? reader.source() : source_of(exact, reader.checked);
        source.index = reader.index;
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    Bytes exact; // no memory behind its last byte, so that a sanitizer sees what is read there
    Bytes index;
    TestSource reader;
    Source source;
};

TEST(StreamSubtree, UnevenTreesByEveryOperator) {
    StreamCombination job;
    std::size_t read = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        const Sample a = sample_of(seed);
        const Sample b = sample_of(10000 + seed);
        const Bytes bytes_a = a.bytes();
        const Bytes bytes_b = b.bytes();
        read += bytes_a.size() + bytes_b.size();
        const int depth = std::max(a.depth, b.depth);
        for (const Operator op : all_operators) {
            const Bytes expected = Sample{combined(op, a.part, b.part), depth}.bytes();
            for (unsigned way = 0; way < 18; ++way) { // each operand in each way, in memory or not
                Bytes result;
                const Place from_a(bytes_a, all_known[way % 3], way / 9 != 0);
                const Place from_b(bytes_b, all_known[way / 3 % 3], way / 9 != 0);
                ASSERT_EQ(combine(job, op, from_a.source, from_b.source, Sink{append, &result}).status,
                          Status::ok);
                ASSERT_EQ(result, expected) << seed << ", way " << way;
            }
        }
        const Part black = {Colour::black, {}};
        const Bytes expected = Sample{combined(Operator::exclusive_or, a.part, black), a.depth}.bytes();
        for (const bool checked : {false, true}) {
            Bytes result;
            ASSERT_EQ(complement(job, source_of(bytes_a, checked), Sink{append, &result}).status, Status::ok);
            ASSERT_EQ(result, expected) << seed << ", checked " << checked;
        }
    }
    EXPECT_GT(read, 100000U) << "the samples are hardly more than leaves";
}

// More than goes by at once where it lies in memory.
TEST(StreamSubtree, ALargeTreeBesideALeaf) {
    std::mt19937 random(12);
    StreamCombination job;
    const Bytes bytes = Sample{grey_part(6, 12, three_colours, random), 6}.bytes();
    ASSERT_GT(bytes.size(), 10000U);
    const Bytes leaf = Sample{{Colour::white, {}}, 1}.bytes();
    for (unsigned way = 0; way < 6; ++way) {
        const Place from(bytes, all_known[way % 3], way / 3 != 0);
        const Place beside(leaf, all_known[way % 3], way / 3 != 0);
        Bytes result;
        ASSERT_EQ(combine(job, Operator::unite, from.source, beside.source, Sink{append, &result}).status,
                  Status::ok);
        EXPECT_EQ(result, bytes) << way;
    }
}

// An index leads to the last block, which may begin with the payload's last byte: what is copied before it is
// looked at beyond its last code, but not beyond the stream. The result lies at other bits than the operand.
TEST(StreamSubtree, AnIndexLeadsNoFurtherThanTheStream) {
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
            Bytes result;
            ASSERT_EQ(combine(job, Operator::unite, from.source, other.source, Sink{append, &result}).status,
                      Status::ok);
            ASSERT_EQ(result, expected) << round;
        }
    }
}

TEST(StreamSubtree, EveryLeafBesideATree) {
    StreamCombination job;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const Sample sample = sample_of(seed);
        const Bytes bytes = sample.bytes();
        for (const Colour colour : three_colours) {
            const Sample leaf = {{colour, {}}, 1};
            const Bytes leaf_bytes = leaf.bytes();
            for (const Operator op : all_operators) {
                const Bytes expected_left =
                    Sample{combined(op, sample.part, leaf.part), sample.depth}.bytes();
                const Bytes expected_right =
                    Sample{combined(op, leaf.part, sample.part), sample.depth}.bytes();
                for (const bool checked : {false, true}) {
                    Bytes left;
                    Bytes right;
                    const Source tree = source_of(bytes, checked);
                    const Source one = source_of(leaf_bytes, checked);
                    ASSERT_EQ(combine(job, op, tree, one, Sink{append, &left}).status, Status::ok);
                    ASSERT_EQ(combine(job, op, one, tree, Sink{append, &right}).status, Status::ok);
                    EXPECT_EQ(left, expected_left);
                    EXPECT_EQ(right, expected_right);
                }
            }
        }
    }
}

// The volume before each octant, in preorder, and that of the root.
std::vector<std::uint64_t> volumes_before(const std::vector<Colour>& colours) {
    std::vector<std::uint64_t> volumes;
    std::vector<unsigned> left{1}; // octants to come, a level
    std::uint64_t volume = 0;
    for (const Colour colour : colours) {
        volumes.push_back(volume);
        --left.back();
        if (colour == Colour::grey) {
            left.push_back(8);
            continue;
        }
        volume += volume_at(static_cast<int>(left.size()) - 1);
        while (left.size() > 1 && left.back() == 0) left.pop_back();
    }
    volumes.push_back(volume);
    return volumes;
}

// Steps of so many octants, one after the other: the progress is that of an octant's beginning, and grows; in
// steps of one mostly from each to the next, where octants do not go by unseen.
void expect_exact_progress(StreamCombination& job, std::uint32_t octants,
                           const std::vector<std::uint64_t>& volumes, std::size_t most_octants,
                           bool checked) {
    std::uint64_t decided = 0;
    std::size_t steps = 0;
    std::size_t growths = 0;
    for (; job.step(octants); ++steps) {
        const std::uint64_t now = job.decided_volume();
        ASSERT_GE(now, decided);
        growths += now > decided ? 1U : 0U;
        ASSERT_LE(now, root_volume);
        decided = now;
        const std::uint64_t in_pass = (2 * now) % root_volume; // halves of a cell are cut off
        const auto at = std::lower_bound(volumes.begin(), volumes.end(), in_pass);
        ASSERT_TRUE(at != volumes.end() && *at <= in_pass + 1) << steps;
    }
    EXPECT_LE(steps * std::size_t{octants}, most_octants + std::size_t{2} * octants);
    if (octants == 1 && !checked) {
        EXPECT_GE(growths + 10, steps / 4);
    }
}

TEST(StreamSubtree, StepBudgetsChangeNothingAndProgressIsExact) {
    StreamCombination job;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const Sample a = sample_of(seed);
        const Sample b = sample_of(20000 + seed);
        const Bytes bytes_a = a.bytes();
        const Bytes bytes_b = b.bytes();
        std::vector<std::uint64_t> volumes = volumes_before(colours_of(a.part));
        const std::vector<std::uint64_t> volumes_b = volumes_before(colours_of(b.part));
        volumes.insert(volumes.end(), volumes_b.begin(), volumes_b.end());
        std::sort(volumes.begin(), volumes.end());
        const Operator op = all_operators[seed % 4];
        const Bytes expected = Sample{combined(op, a.part, b.part), std::max(a.depth, b.depth)}.bytes();
        const std::size_t most_octants = 2 * (colours_of(a.part).size() + colours_of(b.part).size());
        for (const std::uint32_t octants : {1U, 2U, 3U, 7U, 40U}) {
            for (unsigned way = 0; way < 6; ++way) {
                const Known known = all_known[way % 3];
                const Place from_a(bytes_a, known, way / 3 != 0);
                const Place from_b(bytes_b, known, way / 3 != 0);
                Bytes result;
                ASSERT_EQ(job.begin(op, from_a.source, from_b.source, Sink{append, &result}), Status::ok);
                expect_exact_progress(job, octants, volumes, most_octants, known != Known::nothing);
                EXPECT_EQ(job.finish().status, Status::ok);
                EXPECT_EQ(job.decided_volume(), root_volume);
                EXPECT_EQ(result, expected) << seed << ", way " << way;
            }
        }
    }
}

// Small subtrees beside leaves, and nothing else: one is copied when the sink refuses, and none behind it.
TEST(StreamSubtree, ARefusalEndsTheWalkBehindASmallSubtree) {
    const auto grey_of = [](const Part& child) { return Part{Colour::grey, std::vector<Part>(8, child)}; };
    const Part leaves = {Colour::grey, {{Colour::black, {}}, {}, {Colour::black, {}}, {}, {}, {}, {}, {}}};
    const Part a = grey_of(grey_of(grey_of(grey_of(leaves))));
    const Part b = grey_of(grey_of(leaves));
    const Bytes bytes_a = Sample{a, 5}.bytes();
    const Bytes bytes_b = Sample{b, 3}.bytes();
    StreamCombination job;
    TestSink all;
    ASSERT_EQ(combine(job, Operator::unite, source_of(bytes_a, true), source_of(bytes_b, true),
                      all.replacing_sink())
                  .status,
              Status::ok);
    ASSERT_GT(all.writes, 4U) << "the header's two, the checksum, and more";
    for (std::size_t taken = 1; taken < all.writes - 2; ++taken) {
        TestSink by_one;
        by_one.refuse_at = taken;
        ASSERT_EQ(job.begin(Operator::unite, source_of(bytes_a, true), source_of(bytes_b, true),
                            by_one.replacing_sink()),
                  Status::ok);
        std::uint64_t before = 0; // a step of one octant: to the end of a subtree and into the next at most
        while (job.step(1)) before = job.decided_volume();
        EXPECT_EQ(job.finish().status, Status::sink_refused);
        TestSink at_once;
        at_once.refuse_at = taken;
        ASSERT_EQ(job.begin(Operator::unite, source_of(bytes_a, true), source_of(bytes_b, true),
                            at_once.replacing_sink()),
                  Status::ok);
        EXPECT_FALSE(job.step(UINT32_MAX));
        EXPECT_LE(job.decided_volume(), before + 2 * (root_volume / 512)) << taken;
        EXPECT_EQ(job.finish().status, Status::sink_refused);
    }
}

// What the reader says of a stream, a Boolean says of it too, whichever operand it is and whatever leaf
// stands beside it.
void expect_like_reader(StreamCombination& job, Operator op, const StreamModel& model,
                        const std::string& what) {
    const Bytes bytes = model.bytes();
    StreamReader reader;
    const StreamOutcome expected = read_stream(reader, bytes, nullptr);
    const bool good = expected.built.status == Status::ok;
    for (const Colour colour : three_colours) {
        const Bytes leaf = Sample{{colour, {}}, 1}.bytes();
        for (const std::uint8_t operand : {std::uint8_t{0}, std::uint8_t{1}}) {
            Bytes result;
            const StreamCombinationOutcome outcome =
                combine(job, op, source_of(operand == 0 ? bytes : leaf),
                        source_of(operand == 0 ? leaf : bytes), Sink{append, &result});
            ASSERT_EQ(outcome.status, expected.built.status) << what;
            EXPECT_EQ(outcome.offset, good ? 0 : expected.offset) << what;
            EXPECT_EQ(outcome.operand, good ? 0 : operand) << what;
            EXPECT_EQ(result.empty(), !good) << what;
        }
    }
}

TEST(StreamSubtree, HostileFormsBesideEveryLeaf) {
    StreamCombination job;
    std::mt19937 random(7);
    const std::vector<Colour> colours = colours_of(grey_part(4, 10, three_colours, random));
    ASSERT_GT(colours.size(), 700U) << "more than one read";
    const StreamModel whole(4, colours);
    for (std::size_t at = 0; at < whole.payload.size(); ++at) {
        for (const unsigned change :
             {1U, 2U, 3U, 12U, 48U, 192U, 255U, 1 + static_cast<unsigned>(random() % 255)}) {
            StreamModel model = whole;
            model.payload[at] = static_cast<std::uint8_t>(model.payload[at] ^ change);
            expect_like_reader(job, all_operators[at % 4], model,
                               "byte " + std::to_string(at) + " changed by " + std::to_string(change));
        }
    }
}

TEST(StreamSubtree, EightEqualLeavesInAnyPlace) {
    StreamCombination job;
    std::mt19937 random(8);
    std::vector<Colour> colours = colours_of(grey_part(3, 10, two_colours, random));
    std::size_t groups = 0;
    for (std::size_t at = 0; at + 8 < colours.size(); ++at) {
        const auto first = colours.begin() + static_cast<std::ptrdiff_t>(at);
        if (*first != Colour::grey || std::find(first + 1, first + 9, Colour::grey) != first + 9) continue;
        ++groups;
        for (const Colour colour : three_colours) {
            std::vector<Colour> changed = colours;
            std::fill_n(changed.begin() + (first - colours.begin()) + 1, 8, colour);
            for (const Operator op : all_operators) {
                expect_like_reader(job, op, StreamModel(3, changed), "octant " + std::to_string(at));
            }
        }
    }
    EXPECT_GT(groups, 20U);
    for (const Colour colour : three_colours) { // at the root
        std::vector<Colour> equal(9, colour);
        equal[0] = Colour::grey;
        for (const Operator op : all_operators) expect_like_reader(job, op, StreamModel(1, equal), "root");
    }
}

// An octant of `levels` levels with at least one grey octant at each but the last, and at the two above that
// any number of grey children in any places.
Part bushy_part(int levels, const std::vector<Colour>& palette, std::mt19937& random) {
    std::vector<Part> children;
    const std::size_t greys = random() % 9;
    const std::size_t chosen = random() % 8;
    for (std::size_t k = 0; k < 8; ++k) {
        const bool grey = levels > 2 ? random() % 8 < 3 || k == chosen : (k * 5 + chosen) % 8 < greys;
        children.push_back(levels > 1 && grey ? bushy_part(levels - 1, palette, random)
                                              : Part{palette[random() % palette.size()], {}});
    }
    Part part = joined(std::move(children));
    return part.colour == Colour::grey ? part : bushy_part(levels, palette, random);
}

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
TEST(StreamSubtree, DeepestLevelsAreCheckedAsByTheReader) {
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

// Beside a leaf all of a tree goes by. A pass begins and ends with a step that may be short.
TEST(StreamSubtree, AStepPassesNoMoreNodesThanAskedFor) {
    std::mt19937 random(11);
    StreamCombination job;
    const Bytes leaf = Sample{{Colour::white, {}}, 1}.bytes();
    for (int round = 0; round < 8; ++round) {
        const Part part = grey_part(6, 12, two_colours, random);
        const Bytes bytes = Sample{part, 6}.bytes();
        ASSERT_GT(bytes.size(), 4000U);
        const std::vector<Colour> colours = colours_of(part);
        const auto nodes = static_cast<std::size_t>(std::count(colours.begin(), colours.end(), Colour::grey));
        for (const std::uint32_t octants : {1U, 2U, 3U, 7U, 95U, 255U, 1023U}) {
            for (unsigned way = 0; way < 12; ++way) {
                const Place from(bytes, all_known[way % 3], way / 3 % 2 != 0);
                Bytes result;
                ASSERT_EQ(job.begin(Operator::unite, from.source, source_of(leaf, way / 6 != 0),
                                    Sink{append, &result}),
                          Status::ok);
                std::size_t steps = 1;
                while (job.step(octants)) ++steps;
                const unsigned at_once = way % 3 == 0 ? 0 : way % 3 == 1 ? 31 : 50;
                EXPECT_GE(steps * (octants + at_once), 2 * nodes) << octants << ", way " << way;
                EXPECT_EQ(result, bytes) << way;
            }
        }
    }
}

// From every octant, so from every place in a byte and in a buffer.
TEST(StreamSubtree, SkippingLeadsBehindTheSubtree) {
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

TEST(StreamSubtree, AnIndexSaysWhatIsToCome) {
    std::size_t most = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const Sample sample = sample_of(seed);
        const Bytes bytes = sample.bytes();
        const Bytes expected = plain_index(colours_of(sample.part));
        ASSERT_EQ(index_of(bytes), expected) << seed;
        most = std::max(most, expected.size());
        Bytes index(expected.size() - 1);
        EXPECT_EQ(check_stream(source_of(bytes), index.data(), index.size()).status,
                  Status::scratch_too_small);
        EXPECT_TRUE(std::all_of(index.begin(), index.end(), [](std::uint8_t byte) { return byte == 0; }));
    }
    EXPECT_GT(most, 40U);
}

// The fault is that which is found without an index; then there is none.
TEST(StreamSubtree, DamagedStreamsHaveNoIndex) {
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

TEST(StreamSubtree, AReadThatFailsLeavesNoIndex) {
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
TEST(StreamSubtree, AnIndexSavesReads) {
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
TEST(StreamSubtree, ASkipByAnIndexReadsThreeTimesAtMost) {
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

TEST(StreamSubtree, APointsLeafIsTheSameHoweverMuchIsKnown) {
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
