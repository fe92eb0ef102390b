// Booleans from stream to stream: their bytes are those of the pool's Booleans, and those of combined grids.
#include "osem/stream_boolean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <unordered_map>

#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/stream_sink.hpp"
#include "support/stream_source.hpp"

namespace osem::tests {

namespace {

constexpr Operator all_operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                      Operator::exclusive_or};

// Runs a job, `octants` a step. The progress must never fall, and not exceed the root's volume.
StreamCombinationOutcome run(StreamCombination& job, std::uint32_t octants) {
    std::uint64_t decided = 0;
    while (job.step(octants)) {
        EXPECT_GE(job.decided_volume(), decided);
        decided = job.decided_volume();
        EXPECT_LE(decided, root_volume);
    }
    EXPECT_GE(job.decided_volume(), decided);
    EXPECT_LE(job.decided_volume(), root_volume);
    return job.finish();
}

TEST(StreamBoolean, BytesAreThoseOfTheCombinedGrids) {
    StreamCombination job;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const DenseGrid a = grid_of(seed);
        const DenseGrid b = grid_of(1000 + 7 * seed); // of another depth, often
        const int depth = std::max(a.depth(), b.depth());
        const Bytes bytes_a = stream_of(a);
        const Bytes bytes_b = stream_of(b);
        for (const Operator op : all_operators) {
            TestSink to;
            const StreamCombinationOutcome outcome =
                combine(job, op, source_of(bytes_a), source_of(bytes_b), to.sink());
            ASSERT_EQ(outcome.status, Status::ok) << describe(outcome.status);
            const Bytes expected = stream_of(combined(op, refined(a, depth), refined(b, depth)));
            ASSERT_EQ(to.bytes, expected) << "seed " << seed << ", operator " << static_cast<int>(op);
            EXPECT_EQ(stream_size(outcome.header.nodes), expected.size());
            EXPECT_EQ(job.decided_volume(), root_volume);
        }
        TestSink to;
        ASSERT_EQ(complement(job, source_of(bytes_a), to.sink()).status, Status::ok);
        ASSERT_EQ(to.bytes, stream_of(complemented(a))) << "seed " << seed;
    }
}

TEST(StreamBoolean, BytesAreThoseOfThePool) {
    StreamCombination job;
    Combination in_pool;
    StreamHeader header = {};
    header.leaf_rule = 1;
    for (std::size_t i = 0; i < 4; ++i) header.frame[i] = 100 + i;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        HeapPool pool(40000);
        const Octree a = planted(grid_of(seed), *pool);
        const Octree b = planted(grid_of(500 + seed), *pool);
        const Bytes bytes_a = written(a, header);
        const Bytes bytes_b = written(b, header);
        for (const Operator op : all_operators) {
            TestSink to;
            ASSERT_EQ(combine(job, op, source_of(bytes_a), source_of(bytes_b), to.sink()).status, Status::ok);
            EXPECT_EQ(to.bytes, written(combine(in_pool, op, a, b, *pool).tree, header));
        }
    }
}

// Beside a boundary leaf the other operand's colours become one: an octant that is one leaf, behind a leaf of
// another colour in an octant that is known to be grey only from there on.
TEST(StreamBoolean, AnOctantBecomesALeafBehindALeafOfAnotherColour) {
    StreamCombination job;
    for (const Colour first : {Colour::white, Colour::black}) {
        for (std::size_t child = 1; child < 8; ++child) {
            DenseGrid a(3, first);
            DenseGrid b(3, Colour::white); // divided twice where a has a boundary leaf
            for (std::size_t cell = 0; cell < 64; ++cell) a[64 * child + cell] = Colour::boundary;
            b[64 * child + 3] = Colour::boundary;
            const Bytes bytes_a = stream_of(a);
            const Bytes bytes_b = stream_of(b);
            for (const Operator op : all_operators) {
                TestSink to;
                ASSERT_EQ(combine(job, op, source_of(bytes_a), source_of(bytes_b), to.sink()).status,
                          Status::ok);
                EXPECT_EQ(to.bytes, stream_of(combined(op, a, b)))
                    << "child " << child << ", operator " << static_cast<int>(op);
                TestSink turned;
                ASSERT_EQ(combine(job, op, source_of(bytes_b), source_of(bytes_a), turned.sink()).status,
                          Status::ok);
                EXPECT_EQ(turned.bytes, stream_of(combined(op, b, a)));
            }
        }
    }
}

TEST(StreamBoolean, UniformRootsAndItself) {
    StreamCombination job;
    const DenseGrid grid = random_grid(3, 9, three_colours);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const DenseGrid flat(3, colour);
        for (const auto& [a, b] : {std::pair{&grid, &flat}, std::pair{&flat, &grid}, std::pair{&flat, &flat},
                                   std::pair{&grid, &grid}}) {
            for (const Operator op : all_operators) {
                TestSink to;
                const Bytes bytes_a = stream_of(*a);
                const Bytes bytes_b = stream_of(*b);
                ASSERT_EQ(combine(job, op, source_of(bytes_a), source_of(bytes_b), to.sink()).status,
                          Status::ok);
                EXPECT_EQ(to.bytes, stream_of(combined(op, *a, *b)));
            }
        }
    }
}

TEST(StreamBoolean, EveryStepBudgetGivesTheSame) {
    const Bytes a = stream_of(random_grid(3, 21, three_colours));
    const Bytes b = stream_of(random_grid(4, 22, three_colours));
    for (const Operator op : all_operators) {
        StreamCombination job;
        TestSink expected;
        ASSERT_EQ(combine(job, op, source_of(a), source_of(b), expected.sink()).status, Status::ok);
        for (const std::uint32_t octants : {1U, 2U, 3U, 7U}) {
            TestSink to;
            ASSERT_EQ(job.begin(op, source_of(a), source_of(b), to.sink()), Status::ok);
            EXPECT_TRUE(job.step(0));
            ASSERT_EQ(run(job, octants).status, Status::ok);
            EXPECT_EQ(to.bytes, expected.bytes);
        }
    }
}

TEST(StreamBoolean, ASinkThatCanReplaceTakesOnePass) {
    StreamCombination job;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const Bytes a = stream_of(grid_of(seed));
        const Bytes b = stream_of(grid_of(1000 + 7 * seed));
        for (std::uint32_t op = 0; op < 5; ++op) {
            TestSource source_a(a);
            TestSource source_b(b);
            const auto begun = [&](const Sink& sink) {
                return op == 4 ? job.begin_complement(source_a.source(), sink)
                               : job.begin(all_operators[op], source_a.source(), source_b.source(), sink);
            };
            TestSink twice;
            ASSERT_EQ(begun(twice.sink()), Status::ok);
            const StreamCombinationOutcome expected = run(job, UINT32_MAX);
            const std::size_t reads = source_a.reads + source_b.reads;
            TestSink once;
            source_a.reads = 0;
            source_b.reads = 0;
            ASSERT_EQ(begun(once.replacing_sink()), Status::ok);
            const StreamCombinationOutcome outcome = run(job, 1 + seed % 3);
            ASSERT_EQ(outcome.status, Status::ok);
            ASSERT_EQ(once.bytes, twice.bytes) << "seed " << seed << ", operator " << op;
            EXPECT_EQ(outcome.header.nodes, expected.header.nodes);
            EXPECT_EQ(outcome.header.depth, expected.header.depth);
            EXPECT_TRUE(once.replaced);
            EXPECT_EQ(job.decided_volume(), root_volume);
            EXPECT_EQ(2 * (source_a.reads + source_b.reads), reads);
        }
    }
}

// What is written before a fault is met begins with 0s, and no reader takes it for a stream.
TEST(StreamBoolean, InOnePassAFaultLeavesNoStream) {
    const Bytes good = stream_of(random_grid(4, 5, three_colours));
    StreamCombination job;
    for (std::size_t at = 0; at < good.size(); ++at) {
        Bytes bad = good;
        bad[at] = static_cast<std::uint8_t>(bad[at] ^ (1U << (at % 8)));
        for (const Operator op : all_operators) {
            for (const unsigned operand : {0U, 1U}) {
                const auto combined_to = [&](const Sink& sink) {
                    return operand == 0 ? combine(job, op, source_of(bad), source_of(good), sink)
                                        : combine(job, op, source_of(good), source_of(bad), sink);
                };
                TestSink twice;
                const StreamCombinationOutcome expected = combined_to(twice.sink());
                TestSink once;
                const StreamCombinationOutcome outcome = combined_to(once.replacing_sink());
                EXPECT_NE(outcome.status, Status::ok);
                EXPECT_EQ(outcome.status, expected.status) << at;
                EXPECT_EQ(outcome.offset, expected.offset) << at;
                EXPECT_EQ(outcome.operand, expected.operand) << at;
                EXPECT_FALSE(once.replaced);
                const Bytes begun(std::min(once.bytes.size(), stream_header_size), 0);
                EXPECT_TRUE(std::equal(begun.begin(), begun.end(), once.bytes.begin()));
            }
        }
    }
}

// A checksum that is wrong is seen behind the last octant.
TEST(StreamBoolean, ProgressIsWholeWhereOnlyTheChecksumIsWrong) {
    const Bytes good = stream_of(random_grid(3, 21, three_colours));
    Bytes bad = good;
    bad.back() = static_cast<std::uint8_t>(bad.back() ^ 1U);
    for (const bool once : {false, true}) {
        StreamCombination job;
        TestSink to;
        ASSERT_EQ(job.begin(Operator::unite, source_of(good), source_of(bad),
                            once ? to.replacing_sink() : to.sink()),
                  Status::ok);
        std::uint64_t decided = 0;
        while (job.step(1)) {
            EXPECT_GE(job.decided_volume(), decided);
            decided = job.decided_volume();
        }
        EXPECT_EQ(job.decided_volume(), once ? root_volume : root_volume / 2);
        EXPECT_EQ(job.finish().status, Status::stream_payload_damaged);
    }
}

TEST(StreamBoolean, ProgressIsNotThatOfTheJobBefore) {
    const Bytes good = stream_of(random_grid(3, 21, three_colours));
    Bytes bad = good;
    bad[stream_header_size - 1] = static_cast<std::uint8_t>(bad[stream_header_size - 1] ^ 1U);
    StreamCombination job;
    TestSink to;
    ASSERT_EQ(job.begin(Operator::unite, source_of(good), source_of(good), to.sink()), Status::ok);
    EXPECT_TRUE(job.step(40));
    EXPECT_GT(job.decided_volume(), 0U);
    EXPECT_NE(job.begin(Operator::unite, source_of(bad), source_of(good), to.sink()), Status::ok);
    EXPECT_EQ(job.decided_volume(), 0U);
}

TEST(StreamBoolean, UnfinishedWorkIsSaidToBe) {
    const Bytes a = stream_of(random_grid(3, 21, three_colours));
    StreamCombination job;
    EXPECT_EQ(job.finish().status, Status::unfinished);
    TestSink to;
    ASSERT_EQ(job.begin(Operator::unite, source_of(a), source_of(a), to.sink()), Status::ok);
    EXPECT_TRUE(job.step(5));
    EXPECT_EQ(job.finish().status, Status::unfinished);
    EXPECT_FALSE(job.step(5));
    EXPECT_TRUE(to.bytes.empty()) << "the first pass writes nothing";
}

// One read or write after the other fails, whatever is known of the operands, in one pass or two: the fault
// is named, progress does not fall and stays what it was, and nothing more is written.
struct Faults {
    Known known;
    bool once;

    StreamCombinationOutcome run(StreamCombination& job, Operator op, TestSource& a, TestSource& b,
                                 TestSink& to, std::uint32_t octants) const {
        know(a);
        know(b);
        std::uint64_t decided = 0;
        if (job.begin(op, a.source(), b.source(), once ? to.replacing_sink() : to.sink()) == Status::ok) {
            while (job.step(octants)) {
                EXPECT_GE(job.decided_volume(), decided);
                decided = job.decided_volume();
            }
        }
        EXPECT_GE(job.decided_volume(), decided);
        const StreamCombinationOutcome outcome = job.finish();
        if (outcome.status == Status::ok) {
            EXPECT_EQ(job.decided_volume(), root_volume);
        } else {
            EXPECT_LE(job.decided_volume(), root_volume);
        }
        return outcome;
    }

  private:
    void know(TestSource& source) const {
        source.checked = known != Known::nothing;
        if (known != Known::indexed) return;
        static std::map<Bytes, Bytes> indexes;
        Bytes& index = indexes[source.bytes];
        if (index.empty()) index = index_of(source.bytes);
        source.index = index.data();
    }
};

void PrintTo(const Faults& faults, std::ostream* out) {
    *out << (faults.known == Known::nothing   ? "unknown"
             : faults.known == Known::checked ? "checked"
                                              : "indexed")
         << (faults.once ? " in one pass" : "");
}

class StreamBooleanFaults : public testing::TestWithParam<Faults> {};

INSTANTIATE_TEST_SUITE_P(All, StreamBooleanFaults,
                         testing::Values(Faults{Known::nothing, false}, Faults{Known::nothing, true},
                                         Faults{Known::checked, false}, Faults{Known::checked, true},
                                         Faults{Known::indexed, false}, Faults{Known::indexed, true}));

TEST_P(StreamBooleanFaults, ASinkMayRefuseEveryWrite) {
    const Bytes a = stream_of(random_grid(5, 31, three_colours));
    const Bytes b = stream_of(random_grid(5, 32, three_colours));
    StreamCombination job;
    for (const Operator op : all_operators) {
        std::size_t writes = 0;
        for (std::size_t at = 0;; ++at) {
            TestSource source_a(a);
            TestSource source_b(b);
            TestSink to;
            to.refuse_at = at;
            const StreamCombinationOutcome outcome = GetParam().run(job, op, source_a, source_b, to, 100);
            writes = to.writes;
            EXPECT_EQ(to.writes, at);
            if (outcome.status == Status::ok) break;
            EXPECT_EQ(outcome.status, Status::sink_refused);
            EXPECT_TRUE(to.refused);
        }
        EXPECT_GT(writes, 4U);
    }
}

// So many grey octants, as deep as can be and behind all others; the last octant's leaves are the last codes.
std::vector<Colour> colours_of_nodes(std::size_t& nodes, int level, unsigned number) {
    if (nodes == 0 || level == 6) return {number % 2 == 0 ? Colour::white : Colour::black};
    --nodes;
    std::vector<std::vector<Colour>> children(8);
    for (unsigned child = 8; child-- > 0;) children[child] = colours_of_nodes(nodes, level + 1, child);
    std::vector<Colour> colours = {Colour::grey};
    for (const auto& child : children) colours.insert(colours.end(), child.begin(), child.end());
    return colours;
}

Bytes stream_of_nodes(std::size_t nodes) { return StreamModel(6, colours_of_nodes(nodes, 0, 0)).bytes(); }

// The last octant fills the last piece: it is refused, and what follows must not be taken for the end.
TEST_P(StreamBooleanFaults, ARefusalAtTheLastOctant) {
    StreamCombination job;
    const Bytes white = StreamModel(1, {Colour::white}).bytes();
    for (std::size_t nodes = 30; nodes < 300; ++nodes) {
        const Bytes bytes = stream_of_nodes(nodes);
        for (const bool beside : {true, false}) { // copied as a whole, or octant by octant
            for (std::size_t at = 0;; ++at) {
                TestSource source_a(bytes);
                TestSource source_b(beside ? white : bytes);
                TestSink to;
                to.refuse_at = at;
                const StreamCombinationOutcome outcome =
                    GetParam().run(job, Operator::unite, source_a, source_b, to, 1000);
                if (outcome.status == Status::ok) {
                    EXPECT_EQ(to.bytes, bytes);
                    break;
                }
                ASSERT_EQ(outcome.status, Status::sink_refused) << nodes << ", write " << at;
            }
        }
    }
}

TEST_P(StreamBooleanFaults, ASourceMayFailAtEveryRead) {
    const Bytes a = stream_of(random_grid(4, 31, three_colours));
    const Bytes b = stream_of(random_grid(4, 32, three_colours));
    StreamCombination job;
    for (const Operator op : all_operators) {
        for (const unsigned operand : {0U, 1U}) {
            for (std::size_t at = 0;; ++at) {
                TestSource source_a(a);
                TestSource source_b(b);
                TestSource& failing = operand == 0 ? source_a : source_b;
                failing.fail_at = at;
                TestSink to;
                const StreamCombinationOutcome outcome =
                    GetParam().run(job, op, source_a, source_b, to, 1 + static_cast<std::uint32_t>(at % 9));
                if (outcome.status == Status::ok) {
                    EXPECT_GT(at, GetParam().once ? 7U : 8U);
                    break;
                }
                EXPECT_EQ(outcome.status, Status::source_failed);
                EXPECT_EQ(outcome.operand, operand);
                EXPECT_EQ(outcome.offset, failing.asked_at);
            }
        }
    }
}

TEST(StreamBoolean, ProgressDoesNotFallWhereAFaultIsMet) {
    const Bytes a = stream_of(random_grid(3, 31, three_colours));
    StreamCombination job;
    std::uint64_t furthest = 0;
    for (std::size_t at = 0;; ++at) {
        TestSource failing(a);
        failing.fail_at = at;
        TestSink to;
        if (job.begin(Operator::unite, source_of(a), failing.source(), to.sink()) != Status::ok) continue;
        std::uint64_t decided = job.decided_volume();
        while (job.step(3)) {
            EXPECT_GE(job.decided_volume(), decided);
            decided = job.decided_volume();
        }
        EXPECT_GE(job.decided_volume(), decided) << "read " << at;
        furthest = decided;
        if (job.finish().status == Status::ok) break;
    }
    EXPECT_GT(furthest, root_volume / 2) << "no fault in the second pass";
}

// Every operand is read whole before anything is written, so a fault is found wherever it is.
TEST(StreamBoolean, DamageInEitherOperandIsNamedBeforeAnythingIsWritten) {
    const Bytes good = stream_of(random_grid(3, 5, three_colours));
    const Bytes leaf = stream_of(DenseGrid(1, Colour::black)); // decides, and would leave the rest unread
    StreamCombination job;
    for (std::size_t at = 0; at < good.size(); ++at) {
        Bytes bad = good;
        bad[at] = static_cast<std::uint8_t>(bad[at] ^ (1U << (at % 8)));
        HeapPool pool(1000);
        StreamReader reader;
        const StreamOutcome walk = read_stream(reader, bad, &*pool);
        for (const Operator op : all_operators) {
            for (const Bytes* other : {&good, &leaf}) {
                for (const unsigned operand : {0U, 1U}) {
                    TestSink to;
                    const Source sources[2] = {source_of(operand == 0 ? bad : *other),
                                               source_of(operand == 0 ? *other : bad)};
                    static_cast<void>(job.begin(op, sources[0], sources[1], to.sink()));
                    const StreamCombinationOutcome outcome = run(job, static_cast<std::uint32_t>(1 + at % 3));
                    EXPECT_EQ(outcome.status, walk.built.status) << at;
                    EXPECT_EQ(outcome.offset, walk.offset) << at;
                    EXPECT_EQ(outcome.operand, operand) << at;
                    EXPECT_TRUE(to.bytes.empty());
                }
            }
        }
        TestSink to;
        EXPECT_EQ(complement(job, source_of(bad), to.sink()).status, walk.built.status);
    }
}

// Bytes that turn into others once the header is asked for a second time.
struct ChangingSource {
    const Bytes& first;
    const Bytes& second;
    int passes = 0;

    Source source() { return Source{read, this, first.size()}; }

  private:
    static bool read(void* context, std::uint64_t offset, std::uint8_t* to, std::size_t count) {
        auto& self = *static_cast<ChangingSource*>(context);
        if (offset == 0) ++self.passes;
        const Bytes& bytes = self.passes < 2 ? self.first : self.second;
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), count, to);
        return true;
    }
};

// Both are well formed and have as many nodes, so only their checksums tell them apart.
TEST(StreamBoolean, ASourceThatChangesBetweenThePassesIsNamed) {
    const DenseGrid grid = random_grid(3, 5, two_colours);
    DenseGrid opposite = grid;
    for (std::size_t cell = 0; cell < opposite.size(); ++cell) {
        opposite[cell] = grid[cell] == Colour::black ? Colour::white : Colour::black;
    }
    const Bytes before = stream_of(grid);
    const Bytes after = stream_of(opposite);
    ASSERT_EQ(before.size(), after.size());
    const Bytes other = stream_of(random_grid(3, 6, two_colours));
    StreamCombination job;
    for (const Operator op : all_operators) {
        for (const unsigned operand : {0U, 1U}) {
            ChangingSource changing = {before, after};
            const Source a = operand == 0 ? changing.source() : source_of(other);
            const Source b = operand == 0 ? source_of(other) : changing.source();
            TestSink to;
            const StreamCombinationOutcome outcome = combine(job, op, a, b, to.sink());
            EXPECT_EQ(job.decided_volume(), root_volume);
            EXPECT_EQ(changing.passes, 2);
            EXPECT_EQ(outcome.status, Status::source_failed);
            EXPECT_EQ(outcome.operand, operand);
            EXPECT_EQ(outcome.offset, 0U);
        }
    }
    ChangingSource changing = {before, after};
    TestSink to;
    EXPECT_EQ(complement(job, changing.source(), to.sink()).status, Status::source_failed);
}

// Streams of 9 nodes whose payloads have one checksum, found among so many that there are some. An octant's
// first cell decides whether it becomes a black leaf in a union with `all_but_first`.
struct Twins {
    Bytes first;
    Bytes second;
};

std::size_t black_first_cells(const DenseGrid& grid) {
    std::size_t found = 0;
    for (std::size_t octant = 0; octant < 8; ++octant) found += grid[8 * octant] == Colour::black ? 1U : 0U;
    return found;
}

Twins find_twins() {
    std::mt19937 random(5);
    std::unordered_map<std::uint32_t, DenseGrid> seen;
    for (;;) {
        DenseGrid grid(2);
        for (std::size_t cell = 0; cell < grid.size(); ++cell) {
            // The last cell of an octant is none of the others' colours: so none is of one colour.
            grid[cell] = cell % 8 == 7 ? Colour::boundary : random() % 2 == 0 ? Colour::white : Colour::black;
        }
        const Bytes payload = StreamModel(2, preorder_masks(grid)).payload;
        const auto [place, is_new] = seen.try_emplace(plain_crc(payload.data(), payload.size()), grid);
        if (is_new || black_first_cells(place->second) == black_first_cells(grid)) continue;
        return {stream_of(place->second), stream_of(grid)};
    }
}

// A change that keeps the checksum is seen by the nodes of the result, if at all; the first operand is named.
TEST(StreamBoolean, AChangeThatKeepsTheChecksumIsSeenByTheResult) {
    const Twins twins = find_twins();
    ASSERT_NE(twins.first, twins.second);
    DenseGrid all_but_first(2, Colour::black);
    for (std::size_t octant = 0; octant < 8; ++octant) all_but_first[8 * octant] = Colour::white;
    const Bytes other = stream_of(all_but_first);
    ChangingSource changing = {twins.first, twins.second};
    StreamCombination job;
    TestSink to;
    const StreamCombinationOutcome outcome =
        combine(job, Operator::unite, changing.source(), source_of(other), to.sink());
    EXPECT_EQ(outcome.status, Status::source_failed);
    EXPECT_EQ(outcome.operand, 0U);
}

} // namespace

} // namespace osem::tests
