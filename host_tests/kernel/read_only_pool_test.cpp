// Pools over constant nodes: read like any other, never written.
#include <gtest/gtest.h>

#include <vector>

#include "osem/boolean.hpp"
#include "osem/query.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

// A tree in read-only memory, where a write would end the program: the root's child 7 is divided, and so is
// child 1 of that; the leaves differ all along.
constexpr Node nodes[] = {Node::of(0x0f, 0x03, 0), Node::of(0x11, 0x03, 0)};
constexpr NodePool constant_pool = NodePool::over(nodes, 2);
constexpr Octree constant_tree = {&constant_pool, Node::of(0x0c, 0x84, 1), 3};

static_assert(constant_pool.used() == 2 && constant_pool.capacity() == 2 && constant_pool.peak() == 2);
static_assert(constant_pool.refused() == 0);
static_assert(constant_pool.at(1) == nodes[1], "readable at compile time");
static_assert(constant_pool.child(constant_tree.top, 7) == nodes[1]);
static_assert(&constant_pool.child(nodes[1], 1) == &nodes[0], "not copied");

// The same colours, cell by cell.
DenseGrid constant_grid() {
    DenseGrid grid(3);
    const auto fill = [&grid](std::size_t first, std::size_t count, const Node& node) {
        for (std::size_t i = 0; i < count; ++i) {
            const Colour colour = node.colour(static_cast<unsigned>(i / (count / 8)));
            if (colour != Colour::grey) grid[first + i] = colour;
        }
    };
    fill(0, 512, constant_tree.top);
    fill(7 * 64, 64, nodes[1]);
    fill(7 * 64 + 8, 8, nodes[0]);
    return grid;
}

TEST(ReadOnlyPool, ItsTreesAreReadLikeAnyOther) {
    const DenseGrid grid = constant_grid();
    HeapPool pool(10);
    const Octree copy = planted(grid, *pool);
    EXPECT_EQ(expand(constant_tree, 3), grid);
    EXPECT_EQ(digest(constant_tree), expected_digest(grid));
    EXPECT_TRUE(same_leaves(constant_tree, copy));
    EXPECT_TRUE(same_leaves(copy, constant_tree));
    EXPECT_EQ(measure(constant_tree).inner_volume, grid.volume(Colour::black));
    LeafWalk walk(constant_tree);
    Leaf leaf = {};
    std::uint64_t volume = 0;
    while (walk.next(leaf)) volume += volume_at(leaf.octant.level);
    EXPECT_EQ(volume, root_volume);
    EXPECT_TRUE(colours_in(constant_tree, {{{0, 0, 0}}, {{8, 8, 8}}}).clear());
}

TEST(ReadOnlyPool, AppendIsRefusedWhateverWasRolledBack) {
    NodePool pool = NodePool::over(nodes, 2);
    NodeIndex first = 77;
    EXPECT_EQ(pool.append(nodes, 1, first), Status::pool_exhausted);
    EXPECT_EQ(pool.append(nodes, UINT32_MAX, first), Status::pool_exhausted);
    for (const std::uint32_t mark : {2U, 1U, 0U}) {
        pool.roll_back(mark);
        EXPECT_EQ(pool.used(), 2U);
        EXPECT_EQ(pool.append(nodes, 1, first), Status::pool_exhausted);
    }
    EXPECT_EQ(pool.refused(), 5U);
    EXPECT_EQ(first, 77);
    EXPECT_EQ(pool.append(nodes, 0, first), Status::ok) << "nothing to write is no refusal, as everywhere";
    EXPECT_EQ(pool.at(1), nodes[1]);
}

TEST(ReadOnlyPool, BuildersFindNoRoom) {
    NodePool pool = NodePool::over(nodes, 2);
    const DenseGrid grid = constant_grid();
    const TreeOutcome outcome = plant(grid, &pool);
    EXPECT_EQ(outcome.status, Status::pool_exhausted);
    EXPECT_EQ(outcome.nodes_needed, 2U);
    EXPECT_EQ(outcome.nodes_missing, 2U);
    EXPECT_EQ(pool.used(), 2U);
    EXPECT_EQ(plant(DenseGrid(1, Colour::black), &pool).status, Status::ok) << "takes no node";
}

TEST(ReadOnlyPool, CompactionIsRefused) {
    NodePool pool = NodePool::over(nodes, 2);
    std::uint32_t scratch[1] = {0xdeadbeef};
    Octree tree = {&pool, constant_tree.top, 3};
    const auto before = bytes_of(tree);
    EXPECT_EQ(compact(pool, &tree, 1, scratch, 1), Status::pool_read_only);
    EXPECT_EQ(compact(pool, nullptr, 0, nullptr, 0), Status::pool_read_only);
    EXPECT_EQ(bytes_of(tree), before);
    EXPECT_EQ(scratch[0], 0xdeadbeefU);
    EXPECT_EQ(pool.used(), 2U);
}

TEST(ReadOnlyPool, BooleansWantTheOperandsInTheResultsPool) {
    HeapPool pool(100);
    const Octree other = planted(random_grid(3, 5, three_colours), *pool);
    const PoolImage before(pool);
    Combination job;
    EXPECT_EQ(combine(job, Operator::unite, constant_tree, other, *pool).status, Status::pools_differ);
    EXPECT_EQ(combine(job, Operator::unite, other, constant_tree, *pool).status, Status::pools_differ);
    EXPECT_EQ(combine(job, Operator::unite, constant_tree, constant_tree, *pool).status,
              Status::pools_differ);
    EXPECT_TRUE(before.same_nodes(pool));

    // In the pool itself only what shares everything has room.
    NodePool full = NodePool::over(nodes, 2);
    const Octree tree = {&full, constant_tree.top, 3};
    const TreeOutcome shared = combine(job, Operator::unite, tree, tree, full);
    EXPECT_EQ(shared.status, Status::ok);
    EXPECT_EQ(shared.tree.top, tree.top);
    EXPECT_EQ(complement(job, tree, full).status, Status::pool_exhausted);
}

TEST(ReadOnlyPool, ClipsItsCountAndMayBeEmpty) {
    EXPECT_EQ(NodePool::over(nodes, UINT32_MAX).used(), NodePool::max_capacity);
    EXPECT_EQ(NodePool::over(nodes, UINT32_MAX).capacity(), NodePool::max_capacity);
    NodePool empty = NodePool::over(nullptr, 0);
    NodeIndex first = 0;
    EXPECT_EQ(empty.append(nodes, 1, first), Status::pool_exhausted);
    EXPECT_EQ(empty.append(nodes, 0, first), Status::ok) << "no refusal, as everywhere";
    EXPECT_EQ(leaf_at(Octree::uniform(empty, Colour::black), Point{{1, 2, 3}}).leaf.colour, Colour::black);
}

} // namespace

} // namespace osem::tests
