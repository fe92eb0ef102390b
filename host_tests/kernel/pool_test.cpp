#include "osem/node_pool.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr NodeIndex widest = static_cast<NodeIndex>(~NodeIndex{0});

// Static storage, without a constructor that runs: the pool is usable before main.
StaticNodePool<5> static_pool;

TEST(Node, HoldsItsIndexAndMasks) {
    for (const NodeIndex first : {NodeIndex{0}, NodeIndex{1}, NodeIndex{0x8001}, NodeIndex{0xfffe}, widest,
                                  static_cast<NodeIndex>(widest ^ 0x5a5a)}) {
        const Node node = Node::of(0xa5, 0x3c, first);
        EXPECT_EQ(node.first(), first);
        EXPECT_EQ(node.may, 0xa5);
        EXPECT_EQ(node.must, 0x3c);
        EXPECT_EQ(node.grey(), 0x18); // in must alone
    }
    EXPECT_EQ(sizeof(Node), sizeof(NodeIndex) + 2);
    EXPECT_EQ(alignof(Node), 2U);
}

TEST(Node, ColoursFollowTheTwoBits) {
    const Node node = Node::of(0b00001010, 0b00000110, 0); // children 0 to 3: white, black, grey, boundary
    EXPECT_EQ(node.colour(0), Colour::white);
    EXPECT_EQ(node.colour(1), Colour::black);
    EXPECT_EQ(node.colour(2), Colour::grey);
    EXPECT_EQ(node.colour(3), Colour::boundary);
    EXPECT_EQ(node.colour(7), Colour::white);
}

TEST(Node, UniformNodes) {
    unsigned uniform = 0;
    for (unsigned may = 0; may < 256; ++may) {
        for (unsigned must = 0; must < 256; ++must) {
            const Node node = Node::of(static_cast<std::uint8_t>(may), static_cast<std::uint8_t>(must), 0);
            bool is_one_colour = node.colour(0) != Colour::grey;
            for (unsigned k = 1; k < 8; ++k)
                is_one_colour = is_one_colour && node.colour(k) == node.colour(0);
            EXPECT_EQ(node.is_uniform(), is_one_colour) << may << " " << must;
            uniform += node.is_uniform() ? 1U : 0U;
        }
    }
    EXPECT_EQ(uniform, 3U);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        EXPECT_TRUE(Node::uniform(colour).is_uniform());
        for (unsigned k = 0; k < 8; ++k) EXPECT_EQ(Node::uniform(colour).colour(k), colour);
    }
}

TEST(Node, EqualityLooksAtEverything) {
    const Node node = Node::of(0x01, 0x02, 3);
    EXPECT_EQ(node, Node::of(0x01, 0x02, 3));
    EXPECT_NE(node, Node::of(0x00, 0x02, 3));
    EXPECT_NE(node, Node::of(0x01, 0x03, 3));
    EXPECT_NE(node, Node::of(0x01, 0x02, 4));
    EXPECT_NE(node, Node::of(0x01, 0x02, static_cast<NodeIndex>(widest - 3)));
}

TEST(Node, CountsBits) {
    for (unsigned mask = 0; mask < 256; ++mask) {
        unsigned bits = 0;
        for (unsigned k = 0; k < 8; ++k) bits += (mask >> k) & 1U;
        EXPECT_EQ(count_bits(static_cast<std::uint8_t>(mask)), bits);
    }
}

TEST(NodePool, AppendsInARow) {
    HeapPool pool(10);
    EXPECT_EQ(pool->capacity(), 10U);
    EXPECT_EQ(pool->used(), 0U);
    const Node nodes[3] = {Node::of(1, 2, 3), Node::of(4, 5, 6), Node::of(7, 8, 9)};
    NodeIndex first = 77;
    ASSERT_EQ(pool->append(nodes, 2, first), Status::ok);
    EXPECT_EQ(first, 0);
    ASSERT_EQ(pool->append(nodes, 3, first), Status::ok);
    EXPECT_EQ(first, 2);
    EXPECT_EQ(pool->used(), 5U);
    for (NodeIndex i = 0; i < 2; ++i) EXPECT_EQ(pool->at(i), nodes[i]);
    for (NodeIndex i = 0; i < 3; ++i) EXPECT_EQ(pool->at(static_cast<NodeIndex>(2 + i)), nodes[i]);
}

TEST(NodePool, RefusesWhatDoesNotFit) {
    HeapPool pool(4);
    const std::vector<Node> nodes(5, Node::of(1, 1, 0));
    NodeIndex first = 77;
    EXPECT_EQ(pool->append(nodes.data(), 5, first), Status::pool_exhausted);
    EXPECT_EQ(pool->used(), 0U);
    EXPECT_EQ(pool->peak(), 0U);
    EXPECT_EQ(pool->refused(), 1U);
    ASSERT_EQ(pool->append(nodes.data(), 3, first), Status::ok);
    EXPECT_EQ(pool->append(nodes.data(), 2, first), Status::pool_exhausted);
    EXPECT_EQ(pool->refused(), 2U);
    EXPECT_EQ(pool->append(nodes.data(), 1, first), Status::ok);
    EXPECT_EQ(first, 3);
    EXPECT_EQ(pool->append(nodes.data(), 0, first), Status::ok);
    EXPECT_EQ(pool->append(nodes.data(), UINT32_MAX, first), Status::pool_exhausted);
    EXPECT_EQ(pool->used(), 4U);
    EXPECT_EQ(pool->refused(), 3U);
}

TEST(NodePool, RollsBackAndKeepsItsPeak) {
    HeapPool pool(8);
    const std::vector<Node> nodes(8, Node::of(1, 1, 0));
    NodeIndex first = 0;
    pool->append(nodes.data(), 6, first);
    pool->roll_back(2);
    EXPECT_EQ(pool->used(), 2U);
    EXPECT_EQ(pool->peak(), 6U);
    pool->append(nodes.data(), 3, first);
    EXPECT_EQ(first, 2);
    EXPECT_EQ(pool->peak(), 6U);
    pool->append(nodes.data(), 3, first);
    EXPECT_EQ(pool->peak(), 8U);
    pool->roll_back(8);
    EXPECT_EQ(pool->used(), 8U);
    pool->roll_back(0);
    EXPECT_EQ(pool->used(), 0U);
}

TEST(NodePool, ClipsItsCapacity) {
    static_assert(NodePool::max_capacity <= widest, "the widest index stands for no node");
    Node memory[1] = {};
    EXPECT_EQ(NodePool(memory, NodePool::max_capacity).capacity(), NodePool::max_capacity);
    EXPECT_EQ(NodePool(memory, NodePool::max_capacity - 1).capacity(), NodePool::max_capacity - 1);
    EXPECT_EQ(NodePool(memory, UINT32_MAX).capacity(), NodePool::max_capacity);
    EXPECT_EQ(NodePool(nullptr, 0).capacity(), 0U);
}

#if OSEM_NODE_INDEX_BITS == 16
TEST(NodePool, CanBeFilledToItsGreatestCapacity) {
    HeapPool pool(NodePool::max_capacity);
    pool.fill_to(NodePool::max_capacity);
    NodeIndex first = 0;
    const Node node = Node::of(1, 1, 0);
    EXPECT_EQ(pool->append(&node, 1, first), Status::pool_exhausted);
    EXPECT_EQ(pool->used(), NodePool::max_capacity);
    pool->roll_back(NodePool::max_capacity - 1);
    ASSERT_EQ(pool->append(&node, 1, first), Status::ok);
    EXPECT_EQ(first, NodePool::max_capacity - 1);
    EXPECT_EQ(pool->at(first), node);
}
#endif

TEST(NodePool, ChildrenStandInAscendingOrder) {
    HeapPool pool(20);
    for (std::uint8_t i = 0; i < 20; ++i) {
        const Node node = Node::of(i, 0, 0);
        NodeIndex first = 0;
        pool->append(&node, 1, first);
    }
    for (unsigned grey = 1; grey < 256; ++grey) {
        // The other children are leaves of all colours.
        const auto may = static_cast<std::uint8_t>(~grey & 0x3b);
        const auto must = static_cast<std::uint8_t>(grey | (may & 0x2a));
        const Node parent = Node::of(may, must, 12);
        ASSERT_EQ(parent.grey(), grey);
        std::uint8_t expected = 12;
        for (unsigned k = 0; k < 8; ++k) {
            if (((grey >> k) & 1U) == 0) continue;
            EXPECT_EQ(pool->child(parent, k).may, expected) << grey << " child " << k;
            ++expected;
        }
    }
}

TEST(StaticNodePool, LivesInStaticStorage) {
    EXPECT_EQ(static_pool.capacity(), 5U);
    const std::vector<Node> nodes(5, Node::of(3, 1, 0));
    NodeIndex first = 0;
    ASSERT_EQ(static_pool.append(nodes.data(), 5, first), Status::ok);
    EXPECT_EQ(static_pool.append(nodes.data(), 1, first), Status::pool_exhausted);
    for (NodeIndex i = 0; i < 5; ++i) EXPECT_EQ(static_pool.at(i), nodes[i]);
    const auto* begin = reinterpret_cast<const unsigned char*>(&static_pool);
    const auto* node = reinterpret_cast<const unsigned char*>(&static_pool.at(4));
    EXPECT_TRUE(node >= begin && node + sizeof(Node) <= begin + sizeof static_pool);
    static_pool.roll_back(0);
}

} // namespace

} // namespace osem::tests
