#include "osem/octree.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

#include "osem/query.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr std::uint32_t seeds = 60;

TEST(Octree, LeafQueriesGiveTheGridBack) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        EXPECT_EQ(expand(planted(grid, *pool), grid.depth()), grid) << "seed " << seed;
    }
}

TEST(Octree, LeavesTileTheRootInMortonOrder) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        LeafWalk walk(planted(grid, *pool));
        Leaf leaf = {};
        std::size_t next = 0;
        while (walk.next(leaf)) {
            const std::size_t cells = grid.size() >> (3 * leaf.octant.level);
            ASSERT_EQ(leaf.octant.corner, grid.corner(next)) << "seed " << seed;
            ASSERT_EQ(next % cells, 0U);
            ASSERT_EQ(grid.uniform_colour(next, cells), leaf.colour);
            next += cells;
        }
        ASSERT_EQ(next, grid.size()) << "seed " << seed;
        ASSERT_FALSE(walk.next(leaf));
    }
}

TEST(Octree, NodesComeInPreorderWithTheirOctants) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        const Masks masks = preorder_masks(grid);
        std::size_t i = 0;
        for (NodeWalk walk(tree); !walk.done(); walk.next(), ++i) {
            ASSERT_LT(i, masks.size());
            ASSERT_EQ(walk.node().may, masks[i].first) << "seed " << seed;
            ASSERT_EQ(walk.node().must, masks[i].second) << "seed " << seed;
            const Octant octant = walk.octant();
            for (unsigned k = 0; k < 8; ++k) { // the octant is the right one if its children's colours are
                if (walk.node().colour(k) == Colour::grey) continue;
                ASSERT_EQ(leaf_at(tree, octant.child(k).corner).leaf.colour, walk.node().colour(k));
            }
        }
        ASSERT_EQ(i, masks.size()) << "seed " << seed;
    }
}

// Skipping every node of one level visits exactly the nodes above it and on it.
TEST(Octree, SkipLeavesASubtreeOut) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        HeapPool pool(5000);
        const Octree tree = planted(random_grid(4, seed, three_colours), *pool);
        for (int level = 0; level < 4; ++level) {
            std::vector<Octant> expected;
            for (NodeWalk walk(tree); !walk.done(); walk.next()) {
                if (walk.octant().level <= level) expected.push_back(walk.octant());
            }
            std::size_t i = 0;
            for (NodeWalk walk(tree); !walk.done(); ++i) {
                ASSERT_LT(i, expected.size());
                ASSERT_EQ(walk.octant().corner, expected[i].corner);
                ASSERT_EQ(walk.octant().level, expected[i].level);
                walk.octant().level == level ? walk.skip() : walk.next();
            }
            ASSERT_EQ(i, expected.size());
        }
    }
}

TEST(Octree, MeasuresAgreeWithTheGrid) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        std::uint64_t leaves[4] = {};
        LeafWalk walk(tree);
        Leaf leaf = {};
        while (walk.next(leaf)) ++leaves[static_cast<unsigned>(leaf.colour)];
        const Measures m = measure(tree);
        EXPECT_EQ(m.nodes, preorder_masks(grid).size()) << "seed " << seed;
        EXPECT_EQ(m.white_leaves, leaves[0]);
        EXPECT_EQ(m.boundary_leaves, leaves[1]);
        EXPECT_EQ(m.black_leaves, leaves[3]);
        EXPECT_EQ(m.inner_volume, grid.volume(Colour::black)) << "seed " << seed;
        EXPECT_EQ(m.outer_volume, grid.volume(Colour::black) + grid.volume(Colour::boundary));
    }
}

TEST(Octree, DigestIsFnv1aOfTheMasks) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        EXPECT_EQ(digest(planted(grid, *pool)), expected_digest(grid)) << "seed " << seed;
    }
    EXPECT_EQ(expected_digest(Masks{}), 0xcbf29ce484222325U);
    EXPECT_EQ(expected_digest(Masks{{'f', 'o'}, {'o', 'b'}, {'a', 'r'}}), 0x85944171f73967e8U); // FNV's own
}

TEST(Octree, UniformTrees) {
    HeapPool pool(0);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const Octree tree = Octree::uniform(*pool, colour);
        LeafWalk walk(tree);
        Leaf leaf = {};
        ASSERT_TRUE(walk.next(leaf));
        EXPECT_EQ(leaf.octant.level, 0);
        EXPECT_EQ(leaf.octant.corner, (Point{{0, 0, 0}}));
        EXPECT_EQ(leaf.colour, colour);
        EXPECT_FALSE(walk.next(leaf));
        EXPECT_FALSE(walk.next(leaf));

        const PointOutcome found = leaf_at(tree, Point{{5, 6, 7}});
        EXPECT_EQ(found.leaf.octant.level, 0);
        EXPECT_EQ(found.leaf.colour, colour);
        EXPECT_EQ(found.visited, 1U);

        const Measures m = measure(tree);
        EXPECT_EQ(m.nodes, 1U);
        EXPECT_EQ(m.white_leaves, colour == Colour::white ? 1U : 0U);
        EXPECT_EQ(m.boundary_leaves, colour == Colour::boundary ? 1U : 0U);
        EXPECT_EQ(m.black_leaves, colour == Colour::black ? 1U : 0U);
        EXPECT_EQ(m.inner_volume, colour == Colour::black ? std::uint64_t{1} << 60 : 0);
        EXPECT_EQ(m.outer_volume, colour == Colour::white ? 0 : std::uint64_t{1} << 60);
        EXPECT_EQ(digest(tree), expected_digest(DenseGrid(2, colour)));
    }
}

TEST(Octree, SameLeavesIsEqualityOfGrids) {
    HeapPool pool(60000);
    HeapPool other(60000);
    std::vector<DenseGrid> grids;
    for (std::uint32_t seed = 0; seed < 40; ++seed) grids.push_back(random_grid(2, seed, three_colours));
    grids.emplace_back(2, Colour::white);
    grids.emplace_back(2, Colour::black);
    grids.emplace_back(2, Colour::boundary);
    for (std::size_t i = 0; i < 20; ++i) { // and some that differ from another in one cell
        grids.push_back(grids[i]);
        Colour& cell = grids.back()[(i * 37) % 64];
        cell = cell == Colour::white ? Colour::black : Colour::white;
    }
    std::vector<Octree> trees;
    std::vector<Octree> others;
    for (const DenseGrid& grid : grids) trees.push_back(planted(grid, *pool));
    for (const DenseGrid& grid : grids) others.push_back(planted(grid, *other));
    for (std::size_t i = 0; i < grids.size(); ++i) {
        for (std::size_t j = 0; j < grids.size(); ++j) {
            const bool equal = grids[i] == grids[j];
            EXPECT_EQ(same_leaves(trees[i], trees[j]), equal) << i << " " << j;
            EXPECT_EQ(same_leaves(trees[i], others[j]), equal) << i << " " << j;
        }
    }
}

// Two pools in which the same index stands for different nodes.
TEST(Octree, SameLeavesLooksIntoBothPools) {
    DenseGrid a(2);
    DenseGrid b(2);
    a[0] = Colour::black;
    b[1] = Colour::black;
    HeapPool pool(1);
    HeapPool other(1);
    const Octree in_pool = planted(a, *pool);
    const Octree in_other = planted(b, *other);
    ASSERT_EQ(in_pool.top, in_other.top);
    EXPECT_FALSE(same_leaves(in_pool, in_other));
    EXPECT_TRUE(same_leaves(in_pool, in_pool));
}

// However it was built, a tree of the same leaves has the same nodes, and none below the top is uniform.
TEST(Octree, TreesAreCanonical) {
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(60000);
        const Octree by_blocks = planted(grid, *pool);
        const std::uint32_t used = pool->used();
        const TreeOutcome by_cells = plant_by_cells(grid, &*pool);
        const TreeOutcome refined_first = plant_by_cells(refined(grid, grid.depth() + 1), &*pool);
        ASSERT_EQ(by_cells.status, Status::ok);
        ASSERT_EQ(refined_first.status, Status::ok);
        EXPECT_EQ(used, preorder_masks(grid).size() - 1) << "the top is not in the pool; seed " << seed;
        for (const Octree& tree : {by_cells.tree, refined_first.tree}) {
            EXPECT_TRUE(same_leaves(by_blocks, tree)) << "seed " << seed;
            EXPECT_EQ(digest(by_blocks), digest(tree)) << "seed " << seed;
            for (NodeWalk walk(tree); !walk.done(); walk.next()) {
                EXPECT_FALSE(walk.octant().level > 0 && walk.node().is_uniform()) << "seed " << seed;
            }
        }
    }
}

// The deepest path there is: one black cell of side 1 in the far corner.
TEST(Octree, GreatestDepth) {
    for (const unsigned child : {0U, 7U, 5U}) {
        HeapPool pool(19);
        TreeBuilder builder;
        builder.begin(&*pool);
        for (int level = 1; level < 20; ++level) builder.open(child);
        builder.leaf(child, Colour::black);
        for (int level = 0; level < 20; ++level) builder.close();
        const TreeOutcome outcome = builder.finish(20);
        ASSERT_EQ(outcome.status, Status::ok);
        EXPECT_EQ(outcome.nodes_needed, 19U);
        const std::int32_t far = root_side - 1;
        const Point cell = {
            {(child & 1U) != 0 ? far : 0, (child & 2U) != 0 ? far : 0, (child & 4U) != 0 ? far : 0}};
        const PointOutcome found = leaf_at(outcome.tree, cell);
        EXPECT_EQ(found.leaf.colour, Colour::black);
        EXPECT_EQ(found.leaf.octant.level, 20);
        EXPECT_EQ(found.leaf.octant.corner, cell);
        EXPECT_EQ(found.visited, 20U);
        const Measures m = measure(outcome.tree);
        EXPECT_EQ(m.nodes, 20U);
        EXPECT_EQ(m.inner_volume, 1U);
        EXPECT_EQ(m.white_leaves, 20U * 7);
        LeafWalk walk(outcome.tree);
        Leaf leaf = {};
        std::uint64_t volume = 0;
        while (walk.next(leaf)) volume += volume_at(leaf.octant.level);
        EXPECT_EQ(volume, root_volume);
    }
}

TEST(Lattice, ChildrenAndParents) {
    std::mt19937 random(3);
    Octant octant = root_octant;
    std::vector<Octant> path;
    while (octant.level < max_depth) {
        path.push_back(octant);
        const unsigned child = random() % 8;
        const Octant next = octant.child(child);
        for (unsigned axis = 0; axis < 3; ++axis) {
            const std::int32_t half = root_side >> (octant.level + 1);
            EXPECT_EQ(next.corner.at[axis],
                      octant.corner.at[axis] + (((child >> axis) & 1U) != 0 ? half : 0));
        }
        octant = next;
    }
    EXPECT_EQ(octant.side(), 1);
    for (; octant.level > 0; path.pop_back()) {
        octant = octant.parent();
        EXPECT_EQ(octant.corner, path.back().corner);
        EXPECT_EQ(octant.level, path.back().level);
    }
}

TEST(Status, EveryStatusHasItsOwnPhrase) {
    std::set<std::string> phrases;
    const int last = static_cast<int>(Status::operand_repeated);
    for (int status = 0; status <= last; ++status) phrases.insert(describe(static_cast<Status>(status)));
    EXPECT_EQ(phrases.size(), static_cast<std::size_t>(last) + 1);
    EXPECT_EQ(phrases.count(describe(static_cast<Status>(255))), 0U);
}

} // namespace

} // namespace osem::tests
