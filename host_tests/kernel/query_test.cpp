// Queries, against grids of cells and against the arithmetic of single cubes.
#include "osem/query.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr std::uint32_t query_seeds = 60;

// At points inside the cells, and the leaf around them: one colour, but no such leaf around its parent.
TEST(PointQuery, FindsTheWholeLeaf) {
    std::mt19937 random(7);
    for (std::uint32_t seed = 0; seed < query_seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        for (int i = 0; i < 200; ++i) {
            const std::size_t cell = random() % grid.size();
            Point p = grid.corner(cell);
            for (std::int32_t& c : p.at) c += static_cast<std::int32_t>(random()) & (grid.cell_side() - 1);
            const PointOutcome found = leaf_at(tree, p);
            ASSERT_EQ(found.status, Status::ok);
            ASSERT_LE(found.visited, tree.depth);
            ASSERT_EQ(found.visited, found.leaf.octant.level == 0 ? 1 : found.leaf.octant.level);
            for (int axis = 0; axis < 3; ++axis) {
                const std::int32_t offset = p.at[axis] - found.leaf.octant.corner.at[axis];
                ASSERT_TRUE(offset >= 0 && offset < found.leaf.octant.side());
            }
            const std::size_t cells = grid.size() >> (3 * found.leaf.octant.level);
            const std::size_t first = cell / cells * cells;
            ASSERT_EQ(grid.uniform_colour(first, cells), found.leaf.colour) << "seed " << seed;
            if (found.leaf.octant.level > 0) {
                ASSERT_FALSE(grid.uniform_colour(cell / (8 * cells) * (8 * cells), 8 * cells)) << seed;
            }
        }
    }
}

TEST(PointQuery, RefusesPointsOffTheRoot) {
    HeapPool pool(0);
    const Octree tree = Octree::uniform(*pool, Colour::black);
    for (int axis = 0; axis < 3; ++axis) {
        for (const std::int32_t bad : {-1, INT32_MIN, root_side, root_side + 1, INT32_MAX}) {
            Point p = {{0, 0, 0}};
            p.at[axis] = bad;
            const PointOutcome outside = leaf_at(tree, p);
            EXPECT_EQ(outside.status, Status::point_off_root);
            // Whoever forgets the status errs on the safe side.
            EXPECT_EQ(outside.leaf.colour, Colour::boundary);
        }
    }
    EXPECT_EQ(leaf_at(tree, Point{{0, 0, 0}}).status, Status::ok);
    EXPECT_EQ(leaf_at(tree, Point{{root_side - 1, root_side - 1, root_side - 1}}).status, Status::ok);
}

std::int32_t random_below(std::mt19937& random, std::int32_t end) {
    return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(end));
}

// A bound of a box: often on or next to a border of cells of the given side, or an end of the root.
std::int32_t random_bound(std::mt19937& random, std::int32_t side) {
    const std::int32_t border = random_below(random, root_side / side + 1) * side;
    switch (random() % 8) {
    case 0:
        return 0;
    case 1:
        return root_side;
    case 2:
        return random_below(random, root_side + 1);
    case 3:
        return std::max(border - 1, 0);
    case 4:
        return std::min(border + 1, root_side);
    default:
        return border;
    }
}

CellBox box_of_cells(std::mt19937& random, std::int32_t side) {
    CellBox box = {};
    for (unsigned axis = 0; axis < 3; ++axis) {
        std::int32_t low = random_bound(random, side);
        std::int32_t high = random() % 4 == 0 ? low + 1 : random_bound(random, side);
        if (low > high) std::swap(low, high);
        if (low == root_side) --low;
        if (low == high) ++high;
        box.low.at[axis] = low;
        box.high.at[axis] = std::min(high, root_side);
    }
    return box;
}

bool share_a_cell(const CellBox& box, const Point& corner, std::int32_t side) {
    bool share = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
        share = share && corner.at[axis] < box.high.at[axis] && corner.at[axis] + side > box.low.at[axis];
    }
    return share;
}

bool share_a_point(const CellBox& box, const Point& corner, std::int32_t side) {
    bool share = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
        share = share && corner.at[axis] <= box.high.at[axis] && corner.at[axis] + side >= box.low.at[axis];
    }
    return share;
}

// What the box query has to answer, leaf by leaf.
struct Expected {
    bool holds[4] = {};
    bool near = false;

    void take(const CellBox& box, const Point& corner, std::int32_t side, Colour colour) {
        if (share_a_cell(box, corner, side)) holds[static_cast<unsigned>(colour)] = true;
        if (colour != Colour::white && share_a_point(box, corner, side)) near = true;
    }
    bool solid() const {
        return holds[static_cast<unsigned>(Colour::black)] || holds[static_cast<unsigned>(Colour::boundary)];
    }
    bool touches() const { return near && !solid(); }
};

Expected expected_in(const DenseGrid& grid, const CellBox& box) {
    Expected expected;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        expected.take(box, grid.corner(cell), grid.cell_side(), grid[cell]);
    }
    return expected;
}

::testing::AssertionResult agrees(const BoxOutcome& found, const Expected& expected) {
    bool same = found.status == Status::ok && found.touches == expected.touches();
    int colours = 0;
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const bool holds = expected.holds[static_cast<unsigned>(colour)];
        colours += holds ? 1 : 0;
        same = same && found.holds(colour) == holds;
    }
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        same = same && found.all(colour) == (colours == 1 && found.holds(colour));
    }
    same = same && found.mixed() == (colours > 1) && !found.holds(Colour::grey) &&
           found.clear() == !expected.near;
    if (same) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << describe(found.status) << ", colours " << int{found.colours} << ", touches " << found.touches;
}

// Nodes whose octant has a cell in the box grown by one cell.
std::uint32_t nodes_near(const Octree& tree, const CellBox& box) {
    CellBox grown = box;
    for (unsigned axis = 0; axis < 3; ++axis) {
        --grown.low.at[axis];
        ++grown.high.at[axis];
    }
    std::uint32_t count = 0;
    for (NodeWalk walk(tree); !walk.done();) {
        if (share_a_cell(grown, walk.octant().corner, walk.octant().side())) {
            ++count;
            walk.next();
        } else {
            walk.skip();
        }
    }
    return count;
}

TEST(BoxQuery, AgreesWithEveryCellOfTheGrid) {
    std::mt19937 random(11);
    unsigned touching = 0;
    unsigned clear = 0;
    for (std::uint32_t seed = 0; seed < 3 * query_seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        for (int i = 0; i < 100; ++i) {
            const CellBox box = box_of_cells(random, grid.cell_side());
            const BoxOutcome found = colours_in(tree, box);
            ASSERT_TRUE(agrees(found, expected_in(grid, box))) << "seed " << seed << ", box " << i;
            touching += found.touches ? 1U : 0U;
            clear += found.clear() ? 1U : 0U;
        }
    }
    EXPECT_GT(touching, 500U); // or the random boxes have missed the point
    EXPECT_GT(clear, 500U);
}

// In grids with little in them, where boxes often only touch, or miss by a cell.
TEST(BoxQuery, AgreesInSparseGrids) {
    std::mt19937 random(12);
    for (std::uint32_t seed = 0; seed < query_seeds; ++seed) {
        DenseGrid grid(3);
        for (std::uint32_t i = 0; i <= seed % 3; ++i) {
            grid[random() % grid.size()] = random() % 2 == 0 ? Colour::black : Colour::boundary;
        }
        HeapPool pool(100);
        const Octree tree = planted(grid, *pool);
        for (int i = 0; i < 200; ++i) {
            const CellBox box = box_of_cells(random, grid.cell_side());
            ASSERT_TRUE(agrees(colours_in(tree, box), expected_in(grid, box))) << seed << " " << i;
        }
    }
}

TEST(BoxQuery, ACellIsALeafQuery) {
    std::mt19937 random(13);
    for (std::uint32_t seed = 0; seed < query_seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        for (int i = 0; i < 100; ++i) {
            CellBox box = {};
            for (unsigned axis = 0; axis < 3; ++axis) {
                box.low.at[axis] = std::min(random_bound(random, grid.cell_side()), root_side - 1);
                box.high.at[axis] = box.low.at[axis] + 1;
            }
            ASSERT_TRUE(colours_in(tree, box).all(leaf_at(tree, box.low).leaf.colour)) << seed;
        }
    }
}

TEST(BoxQuery, VisitsNoMoreThanTheNodesAround) {
    std::mt19937 random(14);
    bool ended_early = false;
    for (std::uint32_t seed = 0; seed < query_seeds; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(5000);
        const Octree tree = planted(grid, *pool);
        for (int i = 0; i < 50; ++i) {
            const CellBox box = box_of_cells(random, grid.cell_side());
            const BoxOutcome found = colours_in(tree, box);
            const std::uint32_t around = nodes_near(tree, box);
            ASSERT_GE(found.visited, 1U);
            ASSERT_LE(found.visited, around) << "seed " << seed;
            if (found.clear()) {
                ASSERT_EQ(found.visited, around) << "only all of them can tell";
            }
            ended_early = ended_early || found.visited < around;
        }
    }
    EXPECT_TRUE(ended_early);
}

// The root's children are leaves but for one in the box, 2, and one beside it, 3, both divided.
TEST(BoxQuery, VisitsNothingThatCannotChangeTheAnswer) {
    constexpr std::int32_t half = root_side / 2;
    const CellBox box = {{{0, 0, 0}}, {{half, root_side, half}}}; // children 0 and 2; 1 and 3 are beside them
    const auto visited = [&box](Colour in_box, Colour beside, Colour divided) {
        DenseGrid grid(3);
        for (std::size_t i = 0; i < 64; ++i) {
            grid[i] = in_box;
            grid[64 + i] = beside;
        }
        for (const std::size_t child : {2U, 3U}) {
            grid[64 * child] = divided;
            grid[64 * child + 63] = divided == Colour::white ? Colour::black : Colour::white;
        }
        HeapPool pool(100);
        const Octree tree = planted(grid, *pool);
        const BoxOutcome found = colours_in(tree, box);
        EXPECT_TRUE(agrees(found, expected_in(grid, box)));
        return found.visited;
    };
    // The top, child 2 and its last eighth; child 3 only where nothing solid was known before.
    EXPECT_EQ(visited(Colour::black, Colour::white, Colour::boundary), 3U);
    EXPECT_EQ(visited(Colour::boundary, Colour::white, Colour::black), 3U);
    EXPECT_EQ(visited(Colour::white, Colour::black, Colour::black), 3U);
    EXPECT_EQ(visited(Colour::white, Colour::white, Colour::black), 4U);

    // All three colours in the top's own leaves.
    DenseGrid grid(2);
    for (std::size_t i = 0; i < 8; ++i) {
        grid[i] = Colour::black;
        grid[8 + i] = Colour::boundary;
    }
    grid[24] = Colour::black;
    HeapPool pool(10);
    const BoxOutcome found =
        colours_in(planted(grid, *pool), {{{0, 0, 0}}, {{root_side, root_side, root_side}}});
    EXPECT_EQ(found.visited, 1U);
    EXPECT_TRUE(found.mixed() && found.holds(Colour::boundary));
}

// One leaf at the end of the longest path of every depth, and boxes that reach it, touch it or miss it by one
// cell on each side along each axis.
TEST(BoxQuery, EveryDepth) {
    std::mt19937 random(15);
    for (int depth = 1; depth <= max_depth; ++depth) {
        const Colour colour = depth % 2 == 0 ? Colour::black : Colour::boundary;
        Octant leaf = root_octant;
        HeapPool pool(max_depth);
        TreeBuilder builder;
        builder.begin(&*pool);
        for (int level = 1; level <= depth; ++level) {
            const unsigned child = random() % 8;
            level < depth ? builder.open(child) : builder.leaf(child, colour);
            leaf = leaf.child(child);
        }
        for (int level = 0; level < depth; ++level) builder.close();
        const Octree tree = builder.finish(depth).tree;
        for (int i = 0; i < 5000; ++i) {
            CellBox box = {};
            for (unsigned axis = 0; axis < 3; ++axis) {
                const std::int32_t begin = leaf.corner.at[axis];
                const std::int32_t end = begin + leaf.side();
                const std::int32_t before[] = {0, begin - 1, begin, end - 1, end, end + 1};
                box.low.at[axis] = std::clamp(before[random() % 6], 0, root_side - 1);
                const std::int32_t behind[] = {begin - 1, begin, begin + 1, end, end + 1, root_side};
                box.high.at[axis] = std::clamp(behind[random() % 6], box.low.at[axis] + 1, root_side);
            }
            Expected expected;
            expected.take(box, leaf.corner, leaf.side(), colour);
            bool inside = true; // the box in the leaf
            for (unsigned axis = 0; axis < 3; ++axis) {
                inside = inside && box.low.at[axis] >= leaf.corner.at[axis] &&
                         box.high.at[axis] <= leaf.corner.at[axis] + leaf.side();
            }
            expected.holds[static_cast<unsigned>(Colour::white)] = !inside;
            const BoxOutcome found = colours_in(tree, box);
            ASSERT_TRUE(agrees(found, expected)) << "depth " << depth;
            ASSERT_LE(found.visited, static_cast<std::uint32_t>(depth));
        }
    }
}

TEST(BoxQuery, UniformTrees) {
    HeapPool pool(0);
    std::mt19937 random(16);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const Octree tree = Octree::uniform(*pool, colour);
        for (int i = 0; i < 100; ++i) {
            const CellBox box = i == 0 ? CellBox{{{0, 0, 0}}, {{root_side, root_side, root_side}}}
                                       : box_of_cells(random, 1024);
            const BoxOutcome found = colours_in(tree, box);
            ASSERT_EQ(found.status, Status::ok);
            EXPECT_TRUE(found.all(colour));
            EXPECT_FALSE(found.mixed());
            EXPECT_FALSE(found.touches);
            EXPECT_EQ(found.clear(), colour == Colour::white);
            EXPECT_EQ(found.visited, 1U);
        }
    }
}

TEST(BoxQuery, RefusesBoxesOffTheRootAndEmptyOnes) {
    HeapPool pool(0);
    const Octree tree = Octree::uniform(*pool, Colour::black);
    const CellBox whole = {{{0, 0, 0}}, {{root_side, root_side, root_side}}};
    const auto refused = [&tree](const CellBox& box, Status status) {
        const BoxOutcome found = colours_in(tree, box);
        return found.status == status && found.colours == 0 && !found.touches && found.visited == 0;
    };
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (const std::int32_t bad : {-1, INT32_MIN, root_side + 1, INT32_MAX}) {
            CellBox box = whole;
            box.low.at[axis] = bad;
            EXPECT_TRUE(refused(box, Status::point_off_root)) << bad;
            box = whole;
            box.high.at[axis] = bad;
            EXPECT_TRUE(refused(box, Status::point_off_root)) << bad;
            box.low.at[(axis + 1) % 3] = root_side; // empty as well
            EXPECT_TRUE(refused(box, Status::point_off_root)) << bad;
        }
        for (const std::int32_t at : {0, 1, 77, root_side}) {
            CellBox box = whole;
            box.low.at[axis] = at;
            box.high.at[axis] = at;
            EXPECT_TRUE(refused(box, Status::box_empty)) << at;
            if (at > 0) box.high.at[axis] = at - 1;
            EXPECT_TRUE(refused(box, Status::box_empty)) << at;
        }
    }
    EXPECT_EQ(colours_in(tree, whole).status, Status::ok);
}

// A firmware decides on these; they are constant expressions.
static_assert(BoxOutcome{Status::ok, 1, false, 1}.clear() && !BoxOutcome{Status::ok, 1, true, 1}.clear());
static_assert(!BoxOutcome{Status::box_empty, 0, false, 0}.all(Colour::white), "a refusal is not clear");
static_assert(!BoxOutcome{Status::box_empty, 0, false, 0}.clear(), "a refusal is not clear");
static_assert(BoxOutcome{Status::ok, 9, false, 1}.mixed() && !BoxOutcome{Status::ok, 8, false, 1}.mixed());

} // namespace

} // namespace osem::tests
