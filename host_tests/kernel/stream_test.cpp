// Streams: the documented bytes, there and back.
#include "osem/stream.hpp"

#include <gtest/gtest.h>

#include "osem/stream_builder.hpp"
#include "stream/crc.hpp"
#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr StreamHeader sample_header = {
    0, 1, {0x3ff0000000000000U, 0xc000000000000000U, 0x0123456789abcdefU, 0x40f86a0000000001U}, 0};

TEST(Stream, ChecksumIsThatOfIeee8023) {
    const std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    EXPECT_EQ(crc_append(0, digits, 9), 0xcbf43926U);
    EXPECT_EQ(plain_crc(digits, 9), 0xcbf43926U);
    EXPECT_EQ(crc_append(0, digits, 0), 0U);
    EXPECT_EQ(crc_append(crc_append(0, digits, 4), digits + 4, 5), 0xcbf43926U);
    for (unsigned byte = 0; byte < 256; ++byte) {
        const auto b = static_cast<std::uint8_t>(byte);
        EXPECT_EQ(crc_append(0, b), plain_crc(&b, 1));
    }
}

// A tree of two nodes, written out by hand: child 3 of the root is grey, child 1 black, child 6 boundary;
// of the grey one child 0 is black and child 7 boundary.
TEST(Stream, BytesAreTheDocumentedOnes) {
    HeapPool pool(1);
    TreeBuilder builder;
    builder.begin(&*pool);
    builder.leaf(1, Colour::black);
    builder.leaf(6, Colour::boundary);
    builder.open(3);
    builder.leaf(0, Colour::black);
    builder.leaf(7, Colour::boundary);
    builder.close();
    builder.close();
    const Octree tree = builder.finish(5).tree;
    Bytes expected = {'O',  'S',  'E',  'M',  2,    5,    1,    0,                 // depth 5, centre leaves
                      0,    0,    0,    0,    0,    0,    0xf0, 0x3f,              // 1.0
                      0,    0,    0,    0,    0,    0,    0,    0xc0,              // -2.0
                      0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01,              // carried as they are
                      0x01, 0,    0,    0,    0,    0x6a, 0xf8, 0x40, 2, 0, 0, 0}; // two nodes
    const std::uint32_t header_crc = plain_crc(expected.data(), 44);
    for (unsigned i = 0; i < 4; ++i) expected.push_back(static_cast<std::uint8_t>(header_crc >> (8 * i)));
    // Root and children 0 to 2; child 3 and its children 0 to 2; 3 to 6; 7, children 4 to 6; child 7,
    // padding.
    const Bytes payload = {0b00'11'00'10, 0b00'00'11'10, 0b00'00'00'00, 0b01'00'00'01, 0b00'00'00'00};
    expected.insert(expected.end(), payload.begin(), payload.end());
    const std::uint32_t crc = plain_crc(payload.data(), payload.size());
    for (unsigned i = 0; i < 4; ++i) expected.push_back(static_cast<std::uint8_t>(crc >> (8 * i)));

    EXPECT_EQ(written(tree, sample_header), expected);
    EXPECT_EQ(expected.size(), stream_size(2));
}

TEST(Stream, WriterGivesTheBytesOfTheModel) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = random_grid(1 + static_cast<int>(seed % 4), seed, three_colours);
        HeapPool pool(5000);
        StreamModel model(grid.depth(), preorder_masks(grid));
        model.leaf_rule = sample_header.leaf_rule;
        for (std::size_t i = 0; i < 4; ++i) model.frame[i] = sample_header.frame[i];
        const Bytes bytes = written(planted(grid, *pool), sample_header);
        EXPECT_EQ(bytes, model.bytes()) << "seed " << seed;
        EXPECT_EQ(bytes.size(), stream_size(model.nodes));
        EXPECT_EQ(model.payload.size(), 2 * std::size_t{model.nodes} + 1);
    }
}

TEST(Stream, RoundTripIntoAnotherPool) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const DenseGrid grid = random_grid(1 + static_cast<int>(seed % 4), seed, three_colours);
        HeapPool from(5000);
        HeapPool to(5000);
        to.fill_to(seed);
        const Octree tree = planted(grid, *from);
        const Bytes bytes = written(tree, sample_header);
        StreamReader reader;
        const StreamOutcome outcome = read_stream(reader, bytes, &*to);
        ASSERT_EQ(outcome.built.status, Status::ok) << "seed " << seed;
        EXPECT_TRUE(same_leaves(tree, outcome.built.tree));
        EXPECT_EQ(digest(outcome.built.tree), expected_digest(grid));
        EXPECT_EQ(expand(outcome.built.tree, grid.depth()), grid);
        EXPECT_EQ(outcome.built.tree.depth, grid.depth());
        EXPECT_EQ(outcome.built.tree.pool, &*to);
        EXPECT_EQ(outcome.built.nodes_needed, preorder_masks(grid).size() - 1);
        EXPECT_EQ(to->used(), seed + outcome.built.nodes_needed);
        EXPECT_EQ(outcome.offset, bytes.size());
        ASSERT_TRUE(reader.has_header());
        EXPECT_EQ(reader.header().depth, grid.depth());
        EXPECT_EQ(reader.header().leaf_rule, 1);
        const bool is_leaf = grid == DenseGrid(grid.depth(), grid[0]);
        EXPECT_EQ(reader.header().nodes, is_leaf ? 0 : preorder_masks(grid).size());
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(reader.header().frame[i], sample_header.frame[i]);
        EXPECT_EQ(written(outcome.built.tree, reader.header()), bytes);
    }
}

TEST(Stream, UniformTreesAndGreatestDepth) {
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        HeapPool pool(0);
        const Bytes bytes = written(Octree::uniform(*pool, colour), StreamHeader{});
        EXPECT_EQ(bytes, StreamModel(1, preorder_masks(DenseGrid(1, colour))).bytes());
        StreamReader reader;
        const StreamOutcome outcome = read_stream(reader, bytes, &*pool);
        ASSERT_EQ(outcome.built.status, Status::ok);
        EXPECT_EQ(outcome.built.tree.top, Node::uniform(colour));
        EXPECT_EQ(reader.header().nodes, 0U);
        EXPECT_EQ(bytes.size(), stream_size(0));
        EXPECT_EQ(bytes[stream_header_size], static_cast<std::uint8_t>(colour));
    }
    Masks path(19, {0x00, 0x20}); // child 5 is grey, 19 times; then it is black
    path.emplace_back(std::uint8_t{0x20}, std::uint8_t{0x20});
    HeapPool pool(19);
    StreamReader reader;
    const StreamOutcome outcome = read_stream(reader, StreamModel(20, path).bytes(), &*pool);
    ASSERT_EQ(outcome.built.status, Status::ok);
    EXPECT_EQ(measure(outcome.built.tree).inner_volume, 1U);
    EXPECT_EQ(digest(outcome.built.tree), expected_digest(path));
}

TEST(Stream, EveryChunkSize) {
    const DenseGrid grid = random_grid(3, 77, three_colours);
    const Bytes bytes = StreamModel(3, preorder_masks(grid)).bytes();
    for (std::size_t chunk = 1; chunk <= 64; ++chunk) {
        HeapPool pool(2000);
        StreamReader reader;
        const StreamOutcome outcome = read_stream(reader, bytes, &*pool, chunk);
        ASSERT_EQ(outcome.built.status, Status::ok) << "chunks of " << chunk;
        EXPECT_EQ(digest(outcome.built.tree), expected_digest(grid));
    }
}

TEST(Stream, TheHeaderIsThereAsSoonAsItIsWhole) {
    const Bytes bytes = StreamModel(3, preorder_masks(random_grid(3, 78, three_colours))).bytes();
    StreamReader reader;
    reader.begin(nullptr);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        EXPECT_EQ(reader.has_header(), i >= stream_header_size);
        ASSERT_EQ(reader.feed(&bytes[i], 1), Status::ok);
    }
    EXPECT_EQ(reader.finish().built.status, Status::ok);
}

TEST(Stream, ReadingWithoutAPoolCounts) {
    const DenseGrid grid = random_grid(3, 79, three_colours);
    StreamReader reader;
    const StreamOutcome outcome = read_stream(reader, StreamModel(3, preorder_masks(grid)).bytes(), nullptr);
    EXPECT_EQ(outcome.built.status, Status::ok);
    EXPECT_EQ(outcome.built.nodes_needed, preorder_masks(grid).size() - 1);
}

TEST(Stream, ExhaustionAtEveryCapacity) {
    const DenseGrid grid = random_grid(3, 80, three_colours);
    const Bytes bytes = StreamModel(3, preorder_masks(grid)).bytes();
    const auto needed = static_cast<std::uint32_t>(preorder_masks(grid).size() - 1);
    for (std::uint32_t room = 0; room < needed; ++room) {
        HeapPool pool(4 + room);
        pool.fill_to(4);
        const PoolImage before(pool);
        StreamReader reader; // reused below
        const StreamOutcome outcome = read_stream(reader, bytes, &*pool, 5);
        ASSERT_EQ(outcome.built.status, Status::pool_exhausted);
        EXPECT_EQ(outcome.built.nodes_needed, needed);
        EXPECT_EQ(outcome.built.nodes_missing, needed - room);
        EXPECT_TRUE(before.same_nodes(pool));
        EXPECT_GT(pool->refused(), before.refused());
        HeapPool enough(pool, 4 + room + outcome.built.nodes_missing);
        const StreamOutcome retry = read_stream(reader, bytes, &*enough);
        ASSERT_EQ(retry.built.status, Status::ok);
        EXPECT_EQ(digest(retry.built.tree), expected_digest(grid));
    }
}

struct CountingSink {
    std::size_t writes = 0;
    std::size_t refuse_at = SIZE_MAX; ///< the number of writes that are taken
    std::size_t bytes = 0;
    bool refused = false;

    static bool write(void* context, const std::uint8_t*, std::size_t count) {
        auto& self = *static_cast<CountingSink*>(context);
        EXPECT_FALSE(self.refused) << "a write after a refusal";
        self.refused = self.writes == self.refuse_at;
        if (self.refused) return false;
        ++self.writes;
        self.bytes += count;
        return true;
    }
};

TEST(Stream, ASinkMayRefuseEveryWrite) {
    // 64 nodes in all fill the writer's pieces exactly when a piece is a power of two of them.
    for (const std::uint32_t seed : {81U, 82U, 83U}) {
        HeapPool pool(5000);
        const Octree tree = planted(random_grid(3, seed, three_colours), *pool);
        CountingSink all;
        ASSERT_EQ(write_stream(tree, sample_header, Sink{CountingSink::write, &all}), Status::ok);
        EXPECT_EQ(all.bytes, stream_size(measure(tree).nodes));
        for (std::size_t at = 0; at < all.writes; ++at) {
            CountingSink sink;
            sink.refuse_at = at;
            EXPECT_EQ(write_stream(tree, sample_header, Sink{CountingSink::write, &sink}),
                      Status::sink_refused);
            EXPECT_TRUE(sink.refused);
            EXPECT_EQ(sink.writes, at);
        }
    }
}

// The parts of a writer's work that a caller may do by hand.
TEST(Stream, ABuilderKnowsWhereItIs) {
    StreamBuilder builder;
    builder.begin();
    EXPECT_EQ(builder.level(), 0);
    EXPECT_FALSE(builder.whole());
    builder.open();
    EXPECT_EQ(builder.level(), 1);
    builder.open();
    EXPECT_EQ(builder.level(), 2);
    for (unsigned k = 0; k < 8; ++k) builder.leaf(k == 3 ? Colour::black : Colour::white);
    EXPECT_EQ(builder.level(), 1);
    EXPECT_FALSE(builder.whole());
    EXPECT_EQ(builder.finish(), Status::unfinished);
    for (unsigned k = 1; k < 8; ++k) builder.leaf(Colour::boundary);
    EXPECT_TRUE(builder.whole());
    EXPECT_EQ(builder.nodes(), 2U);
    EXPECT_EQ(builder.finish(), Status::ok) << "a count needs no sink";
}

TEST(Stream, WhatWasGivenUpIsForgotten) {
    HeapPool pool(1);
    const Bytes bytes = written(Octree::uniform(*pool, Colour::black), sample_header);
    StreamReader reader;
    reader.begin(nullptr);
    ASSERT_EQ(reader.feed(bytes.data(), stream_header_size), Status::ok);
    EXPECT_TRUE(reader.has_header());
    reader.begin(nullptr);
    EXPECT_FALSE(reader.has_header());

    StreamBuilder builder;
    for (int round = 0; round < 2; ++round) { // the first one ends in an octant that stands for good
        builder.begin();
        builder.open();
        builder.leaf(Colour::black);
        for (unsigned k = 1; k < (round == 0 ? 2U : 8U); ++k) builder.leaf(Colour::white);
    }
    EXPECT_TRUE(builder.whole());
    EXPECT_EQ(builder.nodes(), 1U);
}

} // namespace

} // namespace osem::tests
