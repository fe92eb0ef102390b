// Transforms against dense grids whose cells are moved one by one, and the algebra of trees.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "osem/boolean.hpp"
#include "osem/transform.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/transforms.hpp"

namespace osem::tests {

namespace {

TEST(Translations, EveryCellGoesWhereTheVectorTakesIt) {
    Translation job;
    unsigned refused = 0;
    unsigned moved = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        std::mt19937 random(seed);
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(20000);
        const Octree tree = planted(grid, *pool);
        const int bits = 1 + static_cast<int>(random() % 5);
        Placement placement;
        placement.by = random_vector(random, bits, std::min(1 << bits, 5));
        if (seed % 2 == 0) placement.keep = random_box(random, 1 + static_cast<int>(random() % 4));
        placement.cut_at_root = seed % 4 != 0;
        const TreeOutcome outcome = translate(job, tree, placement, *pool);
        if (!placement.cut_at_root && leaves_root(grid, placement.by)) {
            ASSERT_EQ(outcome.status, Status::part_leaves_root) << "seed " << seed;
            ++refused;
            continue;
        }
        const int depth = placed_depth(grid.depth(), placement);
        ASSERT_LE(depth, 5);
        ASSERT_EQ(outcome.status, Status::ok) << "seed " << seed;
        ASSERT_EQ(depth, exact_depth(grid, placement));
        ASSERT_EQ(int{outcome.tree.depth}, depth);
        ASSERT_EQ(digest(outcome.tree), expected_digest(placed(grid, placement, depth))) << "seed " << seed;
        ++moved;
    }
    EXPECT_GT(refused, 10U);
    EXPECT_GT(moved, 200U);
}

// A white margin: what is moved by less than the margin never leaves.
DenseGrid with_margin(std::uint32_t seed) {
    const DenseGrid core = random_grid(4, seed, three_colours);
    const CellBox middle = {Point{{root_side / 4, root_side / 4, root_side / 4}},
                            Point{{root_side / 4 * 3, root_side / 4 * 3, root_side / 4 * 3}}};
    return make_grid(4, [&](const Point& corner, std::int32_t) {
        return holds(middle, corner) ? core.at(corner) : Colour::white;
    });
}

TEST(Translations, ThereAndBackIsTheTree) {
    Translation job;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const DenseGrid grid = with_margin(seed);
        HeapPool pool(60000);
        const Octree tree = planted(grid, *pool);
        Placement there;
        there.by = random_vector(random, 5, 8);
        const TreeOutcome moved = translate(job, tree, there, *pool);
        ASSERT_EQ(moved.status, Status::ok);
        EXPECT_EQ(measure(moved.tree).inner_volume, grid.volume(Colour::black));
        Placement back;
        back.by = minus(Point{{0, 0, 0}}, there.by);
        const TreeOutcome returned = translate(job, moved.tree, back, *pool);
        ASSERT_EQ(returned.status, Status::ok);
        EXPECT_TRUE(same_leaves(returned.tree, tree)) << "seed " << seed;
        Placement more = there;
        more.by = minus(there.by, Point{{root_side / 16, 0, root_side / 8}});
        Placement rest;
        rest.by = Point{{-root_side / 16, 0, -root_side / 8}};
        rest.cut_at_root = true;
        more.cut_at_root = true;
        EXPECT_TRUE(
            same_leaves(translate(job, moved.tree, rest, *pool).tree, translate(job, tree, more, *pool).tree))
            << "seed " << seed;
    }
}

// A cell of side 1 in a white root.
Octree single_cell(NodePool& pool, const Point& cell) {
    return reduced(Octree::uniform(pool, Colour::black), Octant{cell, max_depth - 1}, pool).tree;
}

TEST(Translations, ACellOfSide1GoesToTheOtherEndOfTheRoot) {
    HeapPool pool(1000);
    Translation job;
    const Octree tree = single_cell(*pool, Point{{2, 4, root_side - 2}});
    ASSERT_EQ(measure(tree).inner_volume, 8U); // depth 1 in an octant of side 2
    const CellBox one = {Point{{3, 4, root_side - 1}}, Point{{4, 5, root_side}}};
    const TreeOutcome cell = crop(job, tree, one, *pool);
    ASSERT_EQ(cell.status, Status::ok);
    ASSERT_EQ(measure(cell.tree).inner_volume, 1U);
    Placement placement;
    placement.by = Point{{root_side - 4, 999999, 1 - root_side}};
    const TreeOutcome moved = translate(job, cell.tree, placement, *pool);
    ASSERT_EQ(moved.status, Status::ok);
    EXPECT_EQ(measure(moved.tree).inner_volume, 1U);
    EXPECT_EQ(leaf_at(moved.tree, Point{{root_side - 1, 1000003, 0}}).leaf.colour, Colour::black);
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            Placement away;
            away.by.at[axis] = sign < 0 ? -one.low.at[axis] - 1 : root_side - one.low.at[axis];
            EXPECT_EQ(translate(job, cell.tree, away, *pool).status, Status::part_leaves_root);
            away.cut_at_root = true;
            EXPECT_EQ(measure(translate(job, cell.tree, away, *pool).tree).outer_volume, 0U);
            away.by.at[axis] = sign < 0 ? INT32_MIN : INT32_MAX;
            EXPECT_EQ(measure(translate(job, cell.tree, away, *pool).tree).outer_volume, 0U);
        }
    }
}

TEST(Translations, AtACoarserDepthMixedOctantsBecomeBoundaryIfThatIsWanted) {
    Translation job;
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        std::mt19937 random(seed);
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(20000);
        const Octree tree = planted(grid, *pool);
        Placement placement;
        // Some are a multiple of large octants' sides, over which whole subtrees come to lie.
        placement.by = seed % 2 == 0 ? random_vector(random, 5, 7) : random_vector(random, 2, 2);
        placement.cut_at_root = true;
        if (seed % 3 == 0) placement.keep = random_box(random, 4);
        const int exact = placed_depth(grid.depth(), placement);
        const DenseGrid fine = placed(grid, placement, exact);
        for (int depth = 1; depth <= exact; ++depth) {
            placement.depth = static_cast<std::uint8_t>(depth);
            placement.mixed_as_boundary = false;
            EXPECT_EQ(job.begin(tree, placement, *pool),
                      depth < exact ? Status::depth_too_coarse : Status::ok);
            placement.mixed_as_boundary = true;
            const TreeOutcome outcome = translate(job, tree, placement, *pool);
            ASSERT_EQ(outcome.status, Status::ok);
            ASSERT_EQ(int{outcome.tree.depth}, depth);
            ASSERT_EQ(digest(outcome.tree), expected_digest(coarse(fine, depth, Coarse::certified)))
                << "seed " << seed << ", depth " << depth;
        }
    }
}

TEST(Translations, TheDepthOfTheResultFollowsFromTheTrailingZeros) {
    Placement placement;
    EXPECT_EQ(placed_depth(3, placement), 3);
    placement.by = Point{{root_side / 16, root_side / 2, 0}};
    EXPECT_EQ(placed_depth(3, placement), 4);
    EXPECT_EQ(placed_depth(9, placement), 9);
    placement.by = Point{{0, -root_side / 32, 0}};
    EXPECT_EQ(placed_depth(3, placement), 5);
    placement.keep.low = Point{{0, 0, 6}};
    EXPECT_EQ(placed_depth(3, placement), 19);
    placement.by.at[2] = -1;
    EXPECT_EQ(placed_depth(3, placement), 20);
}

TEST(Crops, OfAUnionAreTheUnionOfTheCrops) {
    Translation job;
    Combination combination;
    for (std::uint32_t seed = 0; seed < 80; ++seed) {
        std::mt19937 random(seed);
        HeapPool pool(60000);
        const Octree a = planted(random_grid(3, 2 * seed, three_colours), *pool);
        const Octree b = planted(random_grid(4, 2 * seed + 1, three_colours), *pool);
        const CellBox box = random_box(random, 4);
        const Octree both = combine(combination, Operator::unite, a, b, *pool).tree;
        const TreeOutcome left = crop(job, both, box, *pool);
        const Octree a_cut = crop(job, a, box, *pool).tree;
        const Octree b_cut = crop(job, b, box, *pool).tree;
        ASSERT_EQ(left.status, Status::ok);
        EXPECT_TRUE(same_leaves(left.tree, combine(combination, Operator::unite, a_cut, b_cut, *pool).tree));
        EXPECT_TRUE(same_leaves(left.tree, crop(job, left.tree, box, *pool).tree));
    }
}

TEST(Crops, BoxesThatAreNoneAreRefused) {
    HeapPool pool(100);
    const Octree tree = planted(random_grid(2, 3, two_colours), *pool);
    const std::uint32_t used = pool->used();
    Translation job;
    CellBox box = whole_root;
    box.high.at[1] = root_side + 1;
    EXPECT_EQ(crop(job, tree, box, *pool).status, Status::point_off_root);
    box.high.at[1] = 0;
    EXPECT_EQ(crop(job, tree, box, *pool).status, Status::box_empty);
    Placement placement;
    placement.depth = max_depth + 1;
    EXPECT_EQ(translate(job, tree, placement, *pool).status, Status::depth_out_of_range);
    EXPECT_EQ(pool->used(), used);
}

TEST(Reorientations, EveryCellGoesToItsImage) {
    Reorientation job;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const DenseGrid grid = grid_of(seed);
        for (unsigned n = 0; n < 48; ++n) {
            HeapPool pool(20000);
            const Octree tree = planted(grid, *pool);
            const Symmetry symmetry = Symmetry::nth(n);
            const DenseGrid expected = reoriented(grid, symmetry);
            const TreeOutcome outcome = reorient(job, tree, symmetry, *pool);
            ASSERT_EQ(outcome.status, Status::ok);
            ASSERT_EQ(int{outcome.tree.depth}, grid.depth());
            ASSERT_EQ(digest(outcome.tree), expected_digest(expected)) << "seed " << seed << ", " << n;
            EXPECT_TRUE(same_leaves(reorient(job, outcome.tree, symmetry.inverse(), *pool).tree, tree));
        }
    }
}

TEST(Reorientations, ComposeAsTheirSymmetriesDo) {
    Reorientation job;
    HeapPool pool(60000);
    const Octree tree = planted(random_grid(2, 8, three_colours), *pool);
    const std::uint32_t used = pool->used();
    for (unsigned i = 0; i < 48; ++i) {
        for (unsigned j = 0; j < 48; ++j) {
            const Symmetry a = Symmetry::nth(i);
            const Symmetry b = Symmetry::nth(j);
            const Octree one_by_one = reorient(job, reorient(job, tree, b, *pool).tree, a, *pool).tree;
            ASSERT_TRUE(same_leaves(one_by_one, reorient(job, tree, a * b, *pool).tree));
            pool->roll_back(used);
        }
    }
    EXPECT_EQ(reorient(job, tree, Symmetry{{0, 0, 1}, 0}, *pool).status, Status::symmetry_invalid);
}

TEST(Coarsenings, EveryModeAndDepthAgainstCountedCells) {
    Coarsening job;
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(20000);
        const Octree tree = planted(grid, *pool);
        for (const Coarse mode : {Coarse::certified, Coarse::inner, Coarse::outer, Coarse::majority}) {
            for (int depth = 1; depth <= 5; ++depth) {
                const TreeOutcome outcome = coarsen(job, tree, depth, mode, *pool);
                ASSERT_EQ(outcome.status, Status::ok);
                ASSERT_EQ(int{outcome.tree.depth}, std::min(depth, grid.depth()));
                ASSERT_EQ(digest(outcome.tree), expected_digest(coarse(grid, depth, mode)))
                    << "seed " << seed << ", depth " << depth << ", mode " << static_cast<int>(mode);
            }
        }
        EXPECT_EQ(coarsen(job, tree, 0, Coarse::inner, *pool).status, Status::depth_out_of_range);
        EXPECT_EQ(coarsen(job, tree, 21, Coarse::inner, *pool).status, Status::depth_out_of_range);
    }
}

TEST(Scales, AnOctantFillsTheRootAndTheRootAnOctant) {
    Translation cut;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const DenseGrid grid = grid_of(seed);
        HeapPool pool(20000);
        const Octree tree = planted(grid, *pool);
        const std::uint32_t used = pool->used();
        for (std::uint8_t level = 0; level <= 5; ++level) {
            Octant octant = root_octant;
            for (int i = 0; i < level; ++i) octant = octant.child(random() % 8);
            const TreeOutcome up = enlarged(tree, octant);
            ASSERT_EQ(up.status, Status::ok);
            ASSERT_EQ(pool->used(), used);
            ASSERT_EQ(int{up.tree.depth}, std::max(1, grid.depth() - level));
            ASSERT_EQ(digest(up.tree), expected_digest(enlarged_grid(grid, octant))) << "seed " << seed;

            const TreeOutcome down = reduced(tree, octant, *pool);
            ASSERT_EQ(down.status, Status::ok);
            ASSERT_EQ(int{down.tree.depth}, grid.depth() + level);
            ASSERT_EQ(pool->used(), used + down.nodes_needed);
            ASSERT_LE(down.nodes_needed, level);
            if (grid.depth() + level <= 5) {
                ASSERT_EQ(digest(down.tree), expected_digest(reduced_grid(grid, octant)));
            }
            const Octree again = enlarged(down.tree, octant).tree;
            ASSERT_EQ(again.top, tree.top);
            ASSERT_EQ(again.depth, tree.depth);
            ASSERT_EQ(measure(down.tree).inner_volume, measure(tree).inner_volume >> (3 * level));
            const CellBox box = {octant.corner,
                                 plus(octant.corner, {{octant.side(), octant.side(), octant.side()}})};
            ASSERT_TRUE(same_leaves(crop(cut, down.tree, box, *pool).tree, down.tree)); // white around it
            const Octree kept = crop(cut, tree, box, *pool).tree; // crop and zoom, and back
            ASSERT_TRUE(same_leaves(reduced(up.tree, octant, *pool).tree, kept));
            pool->roll_back(used);
        }
    }
}

TEST(Scales, WhatCannotBeIsRefused) {
    HeapPool pool(100);
    HeapPool other(1);
    const Octree tree = planted(random_grid(2, 3, two_colours), *pool);
    const std::uint32_t used = pool->used();
    EXPECT_EQ(enlarged(tree, Octant{Point{{1, 0, 0}}, 19}).status, Status::octant_invalid);
    EXPECT_EQ(enlarged(tree, Octant{Point{{0, root_side, 0}}, 3}).status, Status::octant_invalid);
    EXPECT_EQ(enlarged(tree, Octant{Point{{0, 0, 0}}, 21}).status, Status::octant_invalid);
    EXPECT_EQ(reduced(tree, Octant{Point{{0, -2, 0}}, 19}, *pool).status, Status::octant_invalid);
    EXPECT_EQ(reduced(tree, Octant{Point{{0, 0, 2}}, 19}, *pool).status, Status::depth_out_of_range);
    EXPECT_EQ(reduced(tree, Octant{Point{{0, 0, 0}}, 1}, *other).status, Status::pools_differ);
    EXPECT_EQ(reduced(tree, Octant{Point{{0, 0, 4}}, 18}, *pool).status, Status::ok);
    pool->roll_back(used);
    for (std::uint32_t room = 0; room < 4; ++room) {
        HeapPool small(pool, used + room);
        Octree stood = tree;
        stood.pool = &*small;
        const TreeOutcome outcome = reduced(stood, Octant{Point{{0, 0, 0}}, 4}, *small);
        EXPECT_EQ(outcome.status, Status::pool_exhausted);
        EXPECT_EQ(outcome.nodes_needed, 4U);
        EXPECT_EQ(outcome.nodes_missing, 4 - room);
        EXPECT_EQ(small->used(), used);
    }
}

} // namespace

} // namespace osem::tests
