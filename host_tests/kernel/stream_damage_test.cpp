// Streams that nobody should have sent: damaged, truncated, hostile. Each is refused, and the pool stays.
#include <gtest/gtest.h>

#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

Masks sample_masks() { return preorder_masks(random_grid(3, 5, three_colours)); }
Bytes sample_bytes() { return StreamModel(3, sample_masks()).bytes(); }

// Reads into a pool in use, which must come out as it went in.
StreamOutcome expect_refused(const Bytes& bytes, const std::string& what, std::size_t chunk = SIZE_MAX) {
    static StreamReader reader; // what one stream left behind must not help or harm the next
    HeapPool pool(1500);
    pool.fill_to(6);
    const PoolImage before(pool);
    const StreamOutcome outcome = read_stream(reader, bytes, &*pool, chunk);
    EXPECT_NE(outcome.built.status, Status::ok) << what;
    EXPECT_NE(outcome.built.status, Status::pool_exhausted) << what;
    EXPECT_EQ(outcome.built.nodes_missing, 0U) << what;
    EXPECT_TRUE(before.same_nodes(pool))
        << what << ": " << describe(outcome.built.status) << ", " << pool->used() << " nodes in use";
    const StreamOutcome counted = read_stream(reader, bytes, nullptr);
    EXPECT_EQ(counted.built.status, outcome.built.status) << what << ": without a pool";
    EXPECT_EQ(counted.offset, outcome.offset) << what;
    return outcome;
}

void expect_status(const Bytes& bytes, Status status, std::uint64_t offset, const std::string& what) {
    const StreamOutcome outcome = expect_refused(bytes, what);
    EXPECT_EQ(outcome.built.status, status) << what << ": " << describe(outcome.built.status);
    EXPECT_EQ(outcome.offset, offset) << what;
    EXPECT_EQ(expect_refused(bytes, what, 1).built.status, status) << what;
}

TEST(StreamDamage, TruncatedAtEveryByte) {
    const Bytes whole = sample_bytes();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        expect_status(bytes, Status::stream_truncated, length, "length " + std::to_string(length));
    }
}

TEST(StreamDamage, EveryBitFlipped) {
    const Bytes whole = sample_bytes();
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        Bytes bytes = whole;
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
        const StreamOutcome outcome = expect_refused(bytes, "bit " + std::to_string(bit));
        if (bit < 40) {
            EXPECT_EQ(outcome.built.status, Status::stream_not_osem);
            EXPECT_EQ(outcome.offset, bit / 8);
        } else if (bit < 8 * stream_header_size) {
            EXPECT_EQ(outcome.built.status, Status::stream_header_damaged);
        } else if (bit >= 8 * (whole.size() - 4)) {
            EXPECT_EQ(outcome.built.status, Status::stream_payload_damaged);
        }
    }
}

TEST(StreamDamage, TrailingBytes) {
    Bytes bytes = sample_bytes();
    const std::size_t size = bytes.size();
    bytes.push_back(0);
    expect_status(bytes, Status::stream_trailing_bytes, size, "one byte too many");
    const Bytes once = sample_bytes();
    bytes.assign(once.begin(), once.end());
    bytes.insert(bytes.end(), once.begin(), once.end());
    expect_status(bytes, Status::stream_trailing_bytes, size, "two streams in one");
}

TEST(StreamDamage, HostileHeaders) {
    const Masks masks = sample_masks();
    StreamModel model(3, masks);
    for (const unsigned depth : {0U, 21U, 255U}) {
        model.depth = static_cast<std::uint8_t>(depth);
        expect_status(model.bytes(), Status::depth_out_of_range, 5, "depth " + std::to_string(depth));
    }
    model = StreamModel(3, masks);
    model.leaf_rule = 2;
    expect_status(model.bytes(), Status::stream_header_damaged, 6, "leaf rule");
    model = StreamModel(3, masks);
    model.zero = 1;
    expect_status(model.bytes(), Status::stream_header_damaged, 7, "the byte that is 0");
    model = StreamModel(3, masks);
    model.nodes = 0;
    expect_status(model.bytes(), Status::stream_count_mismatch, 40, "no nodes");
    model = StreamModel(3, masks);
    model.magic[4] = 2;
    expect_status(model.bytes(), Status::stream_not_osem, 4, "version 2");
}

TEST(StreamDamage, WrongCounts) {
    const Masks masks = sample_masks();
    for (const std::int64_t off : {-1, 1, 2, -5, 100000}) {
        StreamModel model(3, masks);
        model.nodes = static_cast<std::uint32_t>(model.nodes + off);
        const StreamOutcome outcome = expect_refused(model.bytes(), "count off by " + std::to_string(off));
        EXPECT_EQ(outcome.built.status, Status::stream_count_mismatch) << off;
    }
    StreamModel model(3, masks);
    model.nodes = UINT32_MAX;
    EXPECT_EQ(expect_refused(model.bytes(), "count 2^32 - 1").built.status, Status::stream_count_mismatch);

    StreamModel uniform(3, Masks{{0xff, 0xff}});
    uniform.nodes = 2;
    EXPECT_EQ(expect_refused(uniform.bytes(), "uniform").built.status, Status::stream_count_mismatch);
    StreamModel two(3, Masks{{0xff, 0xff}, {0x01, 0x00}});
    EXPECT_EQ(expect_refused(two.bytes(), "a node after all").built.status, Status::stream_count_mismatch);
}

TEST(StreamDamage, NodesThatAreNotCanonical) {
    for (const auto& node : Masks{{0x00, 0x00}, {0xff, 0x00}, {0xff, 0xff}}) {
        const StreamModel below_the_top(3, Masks{{0x00, 0x01}, node});
        expect_status(below_the_top.bytes(), Status::stream_not_canonical, 51, "eight equal leaves");
        const StreamModel deeper(3, Masks{{0x00, 0x81}, {0x01, 0x80}, {0x02, 0x02}, node});
        expect_status(deeper.bytes(), Status::stream_not_canonical, 55, "eight equal leaves, later");
    }
}

TEST(StreamDamage, NodesBelowTheStatedDepth) {
    for (int depth = 1; depth <= max_depth; ++depth) {
        Masks masks(static_cast<std::size_t>(depth), {0x00, 0x20});
        masks.emplace_back(std::uint8_t{0x20}, std::uint8_t{0x20});
        const StreamModel model(depth, masks);
        const auto fault =
            static_cast<std::uint64_t>(stream_header_size) + 2 * static_cast<unsigned>(depth) - 1;
        expect_status(model.bytes(), Status::stream_too_deep, fault, "depth " + std::to_string(depth));
    }
    // As deep as can be, and on and on.
    const StreamModel endless(20, Masks(500, {0x00, 0xff}));
    EXPECT_EQ(expect_refused(endless.bytes(), "endless").built.status, Status::stream_too_deep);
}

TEST(StreamDamage, TheFirstFaultStays) {
    StreamReader reader;
    reader.begin(nullptr);
    const std::uint8_t bad = 'X';
    EXPECT_EQ(reader.feed(&bad, 1), Status::stream_not_osem);
    const Bytes good = sample_bytes();
    EXPECT_EQ(reader.feed(good.data(), good.size()), Status::stream_not_osem);
    const StreamOutcome outcome = reader.finish();
    EXPECT_EQ(outcome.built.status, Status::stream_not_osem);
    EXPECT_EQ(outcome.offset, 0U);
    EXPECT_FALSE(reader.has_header());
}

// A damaged stream is reported as such even if the pool had run out before the damage was seen.
TEST(StreamDamage, DamageAfterExhaustion) {
    const Bytes whole = sample_bytes();
    for (const bool is_cut : {false, true}) {
        Bytes bytes = whole;
        is_cut ? bytes.pop_back() : bytes.push_back(0);
        HeapPool pool(2);
        StreamReader reader;
        const StreamOutcome outcome = read_stream(reader, bytes, &*pool);
        EXPECT_EQ(outcome.built.status, is_cut ? Status::stream_truncated : Status::stream_trailing_bytes);
        EXPECT_EQ(outcome.built.nodes_missing, 0U);
        EXPECT_EQ(pool->used(), 0U);
    }
}

} // namespace

} // namespace osem::tests
