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
    for (const std::size_t other : {1U, 2U, 5U}) {
        const StreamOutcome apart = read_stream(reader, bytes, nullptr, other);
        EXPECT_EQ(apart.built.status, outcome.built.status) << what << ": in chunks of " << other;
        EXPECT_EQ(apart.offset, outcome.offset) << what << ": in chunks of " << other;
    }
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
    expect_status(model.bytes(), Status::stream_count_mismatch, 48, "no nodes");
    for (const unsigned version : {0U, 1U, 3U}) {
        model = StreamModel(3, masks);
        model.magic[4] = static_cast<std::uint8_t>(version);
        expect_status(model.bytes(), Status::stream_not_osem, 4, "version " + std::to_string(version));
    }
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
    const StreamModel two(3, std::vector<Colour>{Colour::black, Colour::grey});
    expect_status(two.bytes(), Status::stream_count_mismatch, 48, "a node after all");
}

TEST(StreamDamage, NodesThatAreNotCanonical) {
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        std::vector<Colour> leaves(8, colour);
        std::vector<Colour> grey_root{Colour::grey};
        grey_root.insert(grey_root.end(), leaves.begin(), leaves.end());
        expect_status(StreamModel(3, grey_root).bytes(), Status::stream_not_canonical, 50, "a grey root");
        for (std::size_t before = 0; before < 8; ++before) {
            std::vector<Colour> colours(1 + before,
                                        Colour::white); // the root, and children before the grey one
            colours[0] = Colour::grey;
            colours.push_back(Colour::grey);
            colours.insert(colours.end(), leaves.begin(), leaves.end());
            const std::uint64_t fault = stream_header_size + (colours.size() - 1) / 4;
            colours.resize(17, Colour::black);
            expect_status(StreamModel(3, colours).bytes(), Status::stream_not_canonical, fault,
                          "child " + std::to_string(before));
        }
    }
}

TEST(StreamDamage, BitsBehindTheLastCode) {
    for (const Masks& masks : {sample_masks(), Masks{{0xff, 0xff}}}) {
        for (unsigned bit = 2; bit < 8; ++bit) {
            StreamModel model(3, masks);
            model.payload.back() = static_cast<std::uint8_t>(model.payload.back() | (1U << bit));
            expect_status(model.bytes(), Status::stream_payload_damaged,
                          stream_header_size + model.payload.size() - 1, "bit " + std::to_string(bit));
        }
    }
}

TEST(StreamDamage, NodesBelowTheStatedDepth) {
    for (std::size_t depth = 1; depth <= max_depth; ++depth) {
        Masks masks(depth, {0x00, 0x20}); // child 5 is grey, and so on
        masks.emplace_back(std::uint8_t{0x20}, std::uint8_t{0x20});
        const StreamModel model(static_cast<int>(depth), masks);
        expect_status(model.bytes(), Status::stream_too_deep, stream_header_size + 6 * depth / 4,
                      "depth " + std::to_string(depth));
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
