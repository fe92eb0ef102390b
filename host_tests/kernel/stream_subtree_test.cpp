// What goes by as a whole in a Boolean of streams: deep and uneven subtrees beside leaves, against trees of
// plain recursion.
#include "osem/stream_boolean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "support/stream_samples.hpp"
#include "support/stream_sink.hpp"

namespace osem::tests {

namespace {

constexpr Operator all_operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                      Operator::exclusive_or};

bool append(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& all = *static_cast<Bytes*>(context);
    all.insert(all.end(), bytes, bytes + count);
    return true;
}

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

// Beside a leaf all of a tree goes by. A pass begins and ends with a step that may be short.
TEST(StreamSubtree, AStepPassesNoMoreNodesThanAskedFor) {
    std::mt19937 random(11);
    StreamCombination job;
    const Bytes leaf = Sample{{Colour::white, {}}, 1}.bytes();
    constexpr std::size_t most_kept = 512; // what is written at a time, which may be what steps before left
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
                TestSink once;
                ASSERT_EQ(job.begin(Operator::unite, from.source, source_of(leaf, way / 6 != 0),
                                    once.replacing_sink()),
                          Status::ok);
                for (std::size_t before = once.bytes.size(); job.step(octants); before = once.bytes.size()) {
                    const std::size_t most = octants + (way % 3 == 0 ? 0 : way % 3 == 1 ? 46 : 50);
                    ASSERT_LE(once.bytes.size() - before, 2 * most + most_kept) << octants << ", way " << way;
                }
                EXPECT_EQ(once.bytes, bytes) << way;
            }
        }
    }
}

} // namespace

} // namespace osem::tests
