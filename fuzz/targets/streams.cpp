// Streams: raw bytes, streams of trees, and those with a few bytes changed, their checksums put right again
// or not. What is accepted is what the writer writes; Booleans and questions on streams are those on trees.
#include <algorithm>
#include <vector>

#include "osem/boolean.hpp"
#include "osem/stream.hpp"
#include "osem/stream_boolean.hpp"
#include "osem/stream_cursor.hpp"
#include "osem/stream_query.hpp"
#include "support/any_grid.hpp"
#include "support/building.hpp"
#include "support/byte_stream.hpp"
#include "support/heap_pool.hpp"
#include "support/stream_source.hpp"
#include "support/target.hpp"

namespace osem::fuzz {

namespace {

using tests::Bytes;
using tests::source_of;
using tests::TestSource;

/// Collects bytes and refuses a write.
struct Collector {
    Bytes bytes;
    std::size_t writes = 0;
    std::size_t refuse_at = SIZE_MAX;
    bool can_replace = false;
    bool replaced = false;
    Sink sink() { return {write, this, can_replace ? replace : nullptr}; }

    /// Whether these are the first of some bytes, but for a header that is to come.
    bool begins(const Bytes& all) const {
        const bool headless = can_replace && !replaced;
        const std::size_t head = headless ? std::min(bytes.size(), stream_header_size) : 0;
        return bytes.size() <= all.size() &&
               std::all_of(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(head),
                           [](std::uint8_t byte) { return byte == 0; }) &&
               std::equal(bytes.begin() + static_cast<std::ptrdiff_t>(head), bytes.end(),
                          all.begin() + static_cast<std::ptrdiff_t>(head));
    }

  private:
    bool take() {
        EXPECT_LE(writes, refuse_at) << "written to after a refusal";
        EXPECT_FALSE(replaced) << "written to behind the last write";
        return writes++ != refuse_at;
    }
    static bool write(void* context, const std::uint8_t* bytes, std::size_t count) {
        auto& self = *static_cast<Collector*>(context);
        if (!self.take()) return false;
        self.bytes.insert(self.bytes.end(), bytes, bytes + count);
        return true;
    }
    static bool replace(void* context, const std::uint8_t* bytes, std::size_t count) {
        auto& self = *static_cast<Collector*>(context);
        if (!self.take()) return false;
        self.replaced = true;
        EXPECT_LE(count, self.bytes.size());
        std::copy_n(bytes, count, self.bytes.begin());
        return true;
    }
};

void put_crc(Bytes& bytes, std::size_t first, std::size_t count, std::size_t at) {
    const std::uint32_t crc = tests::plain_crc(bytes.data() + first, count);
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(crc >> (8 * i));
}

/// Makes the two checksums right.
void repair(Bytes& bytes) {
    if (bytes.size() < stream_header_size) return;
    put_crc(bytes, 0, 44, 44);
    if (bytes.size() < stream_header_size + 5) return;
    put_crc(bytes, stream_header_size, bytes.size() - stream_header_size - 4, bytes.size() - 4);
}

StreamHeader any_header(Choices& choices) {
    StreamHeader header = {};
    header.leaf_rule = choices.byte() & 1U;
    for (std::uint64_t& word : header.frame) word = choices.below(4) == 0 ? choices.wide() : 0;
    return header;
}

/// A tree's stream, by the writer and by the model, which agree.
Bytes stream_of(const tests::DenseGrid& grid, Choices& choices) {
    tests::HeapPool pool(5000);
    const StreamHeader header = any_header(choices);
    const Bytes bytes = tests::written(tests::planted(grid, *pool), header);
    tests::StreamModel model(grid.depth(), tests::preorder_masks(grid));
    model.leaf_rule = header.leaf_rule;
    std::copy(std::begin(header.frame), std::end(header.frame), std::begin(model.frame));
    EXPECT_TRUE(bytes == model.bytes());
    return bytes;
}

void change_bytes(Bytes& bytes, Choices& choices) {
    for (std::uint32_t changes = choices.below(4); changes > 0; --changes) {
        const auto size = static_cast<std::uint32_t>(bytes.size());
        const std::uint32_t at = choices.below(size + 1);
        switch (choices.below(4)) {
        case 0:
            if (at < size) bytes[at] = choices.byte();
            break;
        case 1:
            if (at < size) bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << choices.below(8)));
            break;
        case 2:
            bytes.insert(bytes.begin() + at, choices.byte());
            break;
        default:
            bytes.resize(at);
        }
    }
    if (choices.flag()) repair(bytes);
}

/// A payload of any codes under a right header and right checksums.
Bytes any_codes(Choices& choices) {
    std::vector<Colour> colours;
    for (std::uint32_t n = 1 + choices.below(400); n > 0 && !choices.done(); --n) {
        const std::uint8_t codes = choices.byte();
        for (unsigned i = 0; i < 4; ++i) colours.push_back(static_cast<Colour>((codes >> (2 * i)) & 3U));
    }
    tests::StreamModel model(static_cast<int>(1 + choices.below(20)), colours);
    if (choices.below(4) == 0) model.nodes = choices.below(2000);
    return model.bytes();
}

void expect_same_point(const Source& source, const Octree& tree, Choices& choices) {
    const Point cell = any_cell(4, choices);
    const PointOutcome expected = leaf_at(tree, cell);
    const StreamPointOutcome found = leaf_at(source, cell);
    ASSERT_EQ(found.point.status, Status::ok);
    EXPECT_EQ(found.point.leaf.octant.corner, expected.leaf.octant.corner);
    EXPECT_EQ(found.point.leaf.octant.level, expected.leaf.octant.level);
    EXPECT_EQ(found.point.leaf.colour, expected.leaf.colour);
    EXPECT_EQ(leaf_at(source, Point{{cell.x(), -1, cell.z()}}).point.status, Status::point_off_root);
}

/// A stream that was checked before, or not, or indexed.
template <class AnySource>
void choose_known(AnySource& source, const Bytes& bytes, Bytes& index, Choices& choices) {
    const std::uint32_t known = choices.below(3);
    source.checked = known != 0;
    if (known < 2) return;
    index = tests::index_of(bytes);
    source.index = index.data();
}

void expect_accepted(const Bytes& bytes, const StreamHeader& header, const Octree& tree, Choices& choices) {
    EXPECT_TRUE(tests::written(tree, header) == bytes) << "accepted, but the writer writes something else";
    Bytes index;
    Source source = source_of(bytes);
    choose_known(source, bytes, index, choices);
    const StreamMeasures measured = measure(source);
    ASSERT_EQ(measured.status, Status::ok);
    const Measures m = measure(tree);
    EXPECT_EQ(measured.measures.nodes, m.nodes);
    EXPECT_EQ(measured.measures.white_leaves, m.white_leaves);
    EXPECT_EQ(measured.measures.black_leaves, m.black_leaves);
    EXPECT_EQ(measured.measures.boundary_leaves, m.boundary_leaves);
    EXPECT_EQ(measured.measures.inner_volume, m.inner_volume);
    EXPECT_EQ(measured.measures.outer_volume, m.outer_volume);
    const StreamDigest digested = digest(source);
    EXPECT_EQ(digested.status, Status::ok);
    EXPECT_EQ(digested.digest, digest(tree));
    const StreamComparison with_tree = same_leaves(source, tree);
    EXPECT_TRUE(with_tree.status == Status::ok && with_tree.same);
    const StreamComparison with_itself = same_leaves(source, source);
    EXPECT_TRUE(with_itself.status == Status::ok && with_itself.same);
    expect_same_point(source, tree, choices);
    Collector refusing;
    refusing.refuse_at = choices.below(4);
    refusing.can_replace = header.leaf_rule == 1;
    const Status status = write_stream(tree, header, refusing.sink());
    EXPECT_EQ(status, refusing.writes > refusing.refuse_at ? Status::sink_refused : Status::ok);
}

/// Walks by a choice of single octants, groups of leaves and skipped subtrees.
Status walk(const Bytes& bytes, Choices& choices) {
    TestSource watched(bytes);
    StreamCursor cursor;
    cursor.begin(watched.source());
    const std::uint32_t ways = choices.word();
    for (unsigned step = 0; !cursor.done(); ++step) {
        EXPECT_LE(cursor.level(), cursor.header().depth);
        EXPECT_LT(cursor.offset(), bytes.size());
        EXPECT_TRUE(is_octant(cursor.octant()) && cursor.octant().level == cursor.level());
        switch ((ways >> (2 * (step % 16))) & 3U) {
        case 0:
            cursor.skip();
            break;
        case 1:
            cursor.next_or_leaves();
            break;
        default:
            cursor.next();
        }
    }
    EXPECT_LE(cursor.offset(), bytes.size());
    return cursor.status();
}

/// Reads bytes in every way there is; true when they are a stream.
bool judge(const Bytes& bytes, Choices& choices) {
    StreamReader reader;
    reader.begin(nullptr);
    const std::size_t chunk = 1 + choices.below(100);
    const StreamOutcome checked = tests::read_stream(reader, bytes, nullptr, chunk);
    EXPECT_LE(checked.offset, bytes.size());
    EXPECT_EQ(walk(bytes, choices) == Status::ok, checked.built.status == Status::ok);
    EXPECT_EQ(check_stream(source_of(bytes)).status == Status::ok, checked.built.status == Status::ok);
    Bytes index(bytes.size()); // more than is needed
    const StreamCheckOutcome indexed = check_stream(source_of(bytes), index.data(), index.size());
    EXPECT_EQ(indexed.status == Status::ok, checked.built.status == Status::ok);
    if (checked.built.status != Status::ok) {
        tests::HeapPool pool(choices.byte());
        const tests::PoolImage before(pool);
        const StreamOutcome refused = tests::read_stream(reader, bytes, &*pool, 1 + choices.below(100));
        EXPECT_NE(refused.built.status, Status::ok);
        EXPECT_TRUE(before.same_nodes(pool));
        EXPECT_NE(measure(source_of(bytes)).status, Status::ok);
        EXPECT_NE(digest(source_of(bytes)).status, Status::ok);
        return false;
    }
    const BuiltTree tree = built(choices, [&](NodePool* pool) {
        return tests::read_stream(reader, bytes, pool, 1 + choices.below(100)).built;
    });
    EXPECT_EQ(tree.outcome.nodes_needed, checked.built.nodes_needed);
    expect_accepted(bytes, reader.header(), tree.outcome.tree, choices);
    return true;
}

/// The result of a Boolean on trees, as the writer writes it with the first operand's header.
Bytes expected_bytes(std::uint32_t op, const Bytes& a, const Bytes& b) {
    tests::HeapPool pool(20000);
    StreamReader reader;
    const Octree tree_b = tests::read_stream(reader, b, &*pool).built.tree;
    const Octree tree_a = tests::read_stream(reader, a, &*pool).built.tree;
    Combination job;
    const TreeOutcome outcome = op == 4 ? complement(job, tree_a, *pool)
                                        : combine(job, static_cast<Operator>(op), tree_a, tree_b, *pool);
    EXPECT_EQ(outcome.status, Status::ok);
    return tests::written(outcome.tree, reader.header());
}

void expect_combined(std::uint32_t op, const Bytes& a, const Bytes& b, Choices& choices) {
    StreamCombination job;
    TestSource source_a(a);
    TestSource source_b(b);
    Bytes index_a;
    Bytes index_b;
    choose_known(source_a, a, index_a, choices);
    if (op != 4) choose_known(source_b, b, index_b, choices);
    Collector collector;
    const std::uint32_t obstacle = choices.below(8); // mostly none
    if (obstacle == 0) source_a.fail_at = choices.below(40);
    if (obstacle == 1) source_b.fail_at = choices.below(40);
    if (obstacle == 2) collector.refuse_at = choices.below(8);
    const bool unary = op == 4;
    const std::uint32_t budget = choices.budget();
    collector.can_replace = choices.flag();
    Status status =
        unary ? job.begin_complement(source_a.source(), collector.sink())
              : job.begin(static_cast<Operator>(op), source_a.source(), source_b.source(), collector.sink());
    std::uint64_t decided = 0;
    while (status == Status::ok && job.step(budget)) {
        EXPECT_GE(job.decided_volume(), decided);
        decided = job.decided_volume();
    }
    const StreamCombinationOutcome outcome = job.finish();
    if (status == Status::ok) status = outcome.status;
    const Bytes expected = expected_bytes(op, a, unary ? a : b);
    EXPECT_TRUE(collector.begins(expected));
    if (status == Status::ok) {
        EXPECT_EQ(collector.bytes.size(), expected.size());
        EXPECT_EQ(job.decided_volume(), root_volume);
    } else {
        EXPECT_LT(obstacle, 3U);
        EXPECT_EQ(status, obstacle == 2 ? Status::sink_refused : Status::source_failed);
        if (obstacle < 2) {
            EXPECT_EQ(outcome.operand, obstacle);
        }
    }
}

void expect_combined_at_once(std::uint32_t op, const Bytes& a, const Bytes& b, Choices& choices) {
    StreamCombination job;
    Collector collector;
    Bytes index_a;
    Bytes index_b;
    Source source_a = source_of(a);
    Source source_b = source_of(b);
    choose_known(source_a, a, index_a, choices);
    if (op != 4) choose_known(source_b, b, index_b, choices);
    const StreamCombinationOutcome outcome =
        op == 4 ? complement(job, source_a, collector.sink())
                : combine(job, static_cast<Operator>(op), source_a, source_b, collector.sink());
    EXPECT_EQ(outcome.status, Status::ok);
    EXPECT_EQ(collector.bytes.size(), stream_size(outcome.header.nodes));
    EXPECT_TRUE(collector.bytes == expected_bytes(op, a, op == 4 ? a : b));
}

/// With an operand at fault nothing is written, or in one pass what begins with 0s.
void expect_fault(std::uint32_t op, const Bytes& a, const Bytes& b, bool a_is_good, bool b_is_good,
                  Choices& choices) {
    StreamCombination job;
    Collector collector;
    const std::uint32_t budget = choices.budget();
    collector.can_replace = choices.flag();
    Status status = job.begin(static_cast<Operator>(op), source_of(a, a_is_good && choices.flag()),
                              source_of(b, b_is_good && choices.flag()), collector.sink());
    while (status == Status::ok && job.step(budget)) {
    }
    const StreamCombinationOutcome outcome = job.finish();
    EXPECT_NE(outcome.status, Status::ok);
    EXPECT_TRUE(outcome.operand == 0 ? !a_is_good : !b_is_good);
    EXPECT_FALSE(collector.replaced);
    EXPECT_TRUE(collector.bytes.empty() || (collector.can_replace && collector.bytes[0] == 0));
}

void test_booleans(Choices& choices) {
    Bytes streams[2];
    bool good[2] = {true, true};
    for (Bytes& bytes : streams)
        bytes = stream_of(any_grid(1 + static_cast<int>(choices.below(4)), choices), choices);
    const std::uint32_t op = choices.below(5);
    if (choices.below(4) == 0) {
        for (unsigned i = 0; i < 2; ++i) {
            change_bytes(streams[i], choices);
            good[i] = judge(streams[i], choices);
        }
    }
    if (good[0] && (good[1] || op == 4)) {
        if (choices.below(8) == 0) {
            expect_combined_at_once(op, streams[0], streams[1], choices);
        } else {
            expect_combined(op, streams[0], streams[1], choices);
        }
    } else if (op < 4) {
        expect_fault(op, streams[0], streams[1], good[0], good[1], choices);
    }
    if (good[0] && good[1]) {
        const StreamComparison same = same_leaves(source_of(streams[0]), source_of(streams[1]));
        EXPECT_EQ(same.status, Status::ok);
        EXPECT_EQ(same.same, digest(source_of(streams[0])).digest == digest(source_of(streams[1])).digest);
    }
}

} // namespace

void run(Choices& choices) {
    const std::uint32_t kind = choices.below(8);
    if (kind < 2) {
        Choices whole = choices;
        Bytes raw = choices.rest();
        if (kind == 1) repair(raw);
        judge(raw, whole);
    } else if (kind < 4) {
        const osem::tests::DenseGrid grid = any_grid(1 + static_cast<int>(choices.below(4)), choices);
        Bytes stream = stream_of(grid, choices);
        const Bytes untouched = stream;
        change_bytes(stream, choices);
        const bool accepted = judge(stream, choices);
        EXPECT_TRUE(accepted || stream != untouched) << "the writer's own stream is refused";
    } else if (kind == 4) {
        judge(any_codes(choices), choices);
    } else {
        test_booleans(choices);
    }
}

} // namespace osem::fuzz
