// Connected components against flood fill on cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "osem/components.hpp"
#include "support/cell_measures.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr Connectivity connectivities[] = {Connectivity::faces, Connectivity::edges, Connectivity::corners};
constexpr std::uint8_t colour_sets[] = {inner_solid,
                                        outer_solid,
                                        inner_void,
                                        outer_void,
                                        colour_bit(Colour::boundary),
                                        colour_bit(Colour::white) | colour_bit(Colour::black)};

// Scratch of exactly the stated size, so that the address sanitizer sees a write behind it.
struct Labelled {
    Labelled(const Octree& tree, std::uint8_t colours, Connectivity connectivity,
             std::uint32_t budget = UINT32_MAX)
        : scratch(static_cast<std::size_t>(component_scratch(measure(tree), colours))) {
        job.begin(tree, colours, connectivity, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
        std::uint64_t before = 0;
        while (job.step(budget)) {
            EXPECT_LE(job.units_visited() - before, budget);
            EXPECT_EQ(job.finish().status, Status::unfinished);
            before = job.units_visited();
        }
        outcome = job.finish();
        components.resize(outcome.components);
        EXPECT_EQ(job.fill(components.data(), outcome.components), outcome.components);
    }
    std::vector<std::uint32_t> scratch;
    ComponentLabelling job;
    ComponentOutcome outcome = {};
    std::vector<Component> components;
};

std::vector<std::uint64_t> leaves_of_component(const Octree& tree, const DenseGrid& grid,
                                               const CellComponents& cells) {
    std::vector<std::uint64_t> leaves(cells.components.size());
    std::set<std::vector<std::int32_t>> seen;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (cells.labels[i] == no_component) continue;
        const Point corner = leaf_at(tree, grid.corner(i)).leaf.octant.corner;
        if (seen.insert({corner.x(), corner.y(), corner.z()}).second) ++leaves[cells.labels[i]];
    }
    return leaves;
}

void expect_components(const Labelled& found, const Octree& tree, const DenseGrid& grid,
                       const CellComponents& cells) {
    ASSERT_EQ(found.outcome.status, Status::ok);
    EXPECT_EQ(found.outcome.scratch_needed, found.scratch.size());
    ASSERT_EQ(found.components.size(), cells.components.size());
    const std::vector<std::uint64_t> leaves = leaves_of_component(tree, grid, cells);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const Component& component = found.components[i];
        const Component& expected = cells.components[i];
        EXPECT_EQ(component.volume, expected.volume);
        EXPECT_EQ(component.leaves, leaves[i]);
        EXPECT_EQ(component.box.low, expected.box.low);
        EXPECT_EQ(component.box.high, expected.box.high);
        EXPECT_EQ(component.touches_border, expected.touches_border);
    }
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Point low = grid.corner(i);
        const std::int32_t last = grid.cell_side() - 1;
        const Point high = {{low.x() + last, low.y() + last, low.z() + last}};
        ASSERT_EQ(found.job.component_of(low), cells.labels[i]);
        ASSERT_EQ(found.job.component_of(high), cells.labels[i]);
    }
}

void expect_components(const Octree& tree, const DenseGrid& grid) {
    for (const std::uint8_t colours : colour_sets) {
        for (const Connectivity connectivity : connectivities) {
            SCOPED_TRACE(testing::Message() << "colours " << int{colours} << ", connectivity "
                                            << static_cast<int>(connectivity));
            const CellComponents cells = cell_components(grid, colours, connectivity);
            expect_components(Labelled(tree, colours, connectivity), tree, grid, cells);
        }
    }
}

TEST(Components, RandomTreesHaveTheComponentsOfTheirCells) {
    for (std::uint32_t seed = 0; seed < 48; ++seed) {
        SCOPED_TRACE(seed);
        HeapPool pool(3000);
        const DenseGrid grid = grid_of(seed);
        expect_components(planted(grid, *pool), grid);
    }
}

// What one tree has beside the root is not another one's.
TEST(Components, OneJobForManyTrees) {
    ComponentLabelling job;
    for (std::uint32_t seed = 0; seed < 24; ++seed) {
        HeapPool pool(3000);
        const DenseGrid grid = grid_of(seed);
        const Octree tree = planted(grid, *pool);
        std::vector<std::uint32_t> scratch(
            static_cast<std::size_t>(component_scratch(measure(tree), outer_void)));
        job.begin(tree, outer_void, Connectivity::faces, scratch.data(),
                  static_cast<std::uint32_t>(scratch.size()));
        while (job.step(UINT32_MAX)) {
        }
        const CellComponents cells = cell_components(grid, outer_void, Connectivity::faces);
        ASSERT_EQ(job.finish().components, cells.components.size()) << seed;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            ASSERT_EQ(job.component_of(grid.corner(i)), cells.labels[i]) << seed;
        }
    }
}

// Sparse cells: many components, few of them on the border.
TEST(Components, ScatteredCells) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        HeapPool pool(3000);
        std::uint32_t state = seed;
        const auto colour = [&state](const Point&, std::int32_t) {
            state = state * 1664525 + 1013904223;
            const std::uint32_t draw = (state >> 24) % 10;
            return draw < 2 ? Colour::black : draw < 3 ? Colour::boundary : Colour::white;
        };
        const DenseGrid grid = make_grid(4, colour);
        expect_components(planted(grid, *pool), grid);
        expect_components(planted(complemented(grid), *pool), complemented(grid));
    }
}

TEST(Components, SharedSubtreesAreLabelledWhereverTheyStand) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        HeapPool pool(30000);
        const Octree a = planted(random_grid(3, seed, three_colours), *pool);
        const Octree b = planted(grid_of(seed), *pool);
        Combination job;
        const Octree tree = combine(job, Operator::exclusive_or, a, b, *pool).tree;
        expect_components(tree, expand(tree, 4));
        TreeBuilder builder;
        builder.begin(&*pool);
        builder.leaf(3, Colour::black);
        for (const unsigned child : {0U, 1U, 2U, 4U, 6U, 7U}) builder.graft(child, a.top);
        builder.close();
        const Octree repeated = builder.finish(4).tree;
        expect_components(repeated, expand(repeated, 4));
    }
}

TEST(Components, ARootOfOneColour) {
    HeapPool pool(1);
    for (const Colour colour : three_colours) {
        expect_components(Octree::uniform(*pool, colour), DenseGrid(1, colour));
    }
}

// A hollow ball in a hollow ball: two pieces, two sealed cavities, and what is around.
TEST(Components, SealedCavitiesAreFound) {
    HeapPool pool(40000);
    const auto shells = [](const Point& corner, std::int32_t side) {
        std::int64_t r = 0;
        for (const std::int32_t low : corner.at) {
            const std::int64_t d = (2 * low + side - root_side) / side;
            r += d * d;
        }
        const bool solid = (r <= 29 * 29 && r >= 23 * 23) || (r <= 17 * 17 && r >= 9 * 9);
        return solid ? Colour::black : Colour::white;
    };
    const Octree tree = planted(make_grid(5, shells), *pool);
    const Labelled solid(tree, inner_solid, Connectivity::corners);
    EXPECT_EQ(solid.outcome.components, 2U);
    const Labelled empty(tree, outer_void, Connectivity::faces);
    ASSERT_EQ(empty.outcome.components, 3U);
    EXPECT_EQ(std::count_if(empty.components.begin(), empty.components.end(),
                            [](const Component& c) { return !c.touches_border; }),
              2);
    std::uint64_t volume = 0;
    for (const Component& component : solid.components) volume += component.volume;
    for (const Component& component : empty.components) volume += component.volume;
    EXPECT_EQ(volume, root_volume);
    const std::int32_t middle = root_side / 2;
    const std::uint32_t core = empty.job.component_of(Point{{middle, middle, middle}});
    ASSERT_LT(core, 3U);
    EXPECT_FALSE(empty.components[core].touches_border);
}

// White on two sides of a wall across the root hangs together around it; black on two sides does not.
TEST(Components, TheVoidHangsTogetherOutsideTheRoot) {
    HeapPool pool(1000);
    const auto wall = [](const Point& corner, std::int32_t side) {
        return corner.x() / side == 3 ? Colour::black : Colour::white;
    };
    const DenseGrid grid = make_grid(3, wall);
    const Octree tree = planted(grid, *pool);
    EXPECT_EQ(Labelled(tree, outer_void, Connectivity::faces).outcome.components, 1U);
    Combination job;
    const Octree other = complement(job, tree, *pool).tree;
    EXPECT_EQ(Labelled(other, inner_solid, Connectivity::corners).outcome.components, 2U);
}

// The smallest cells at the deepest level, in opposite corners of the root's middle.
TEST(Components, AtFullDepth) {
    HeapPool pool(200);
    TreeBuilder builder;
    builder.begin(&*pool);
    for (const unsigned side : {0U, 7U}) { // cells whose common corner is the root's centre
        builder.open(side);
        for (int level = 2; level < max_depth; ++level) builder.open(7 - side);
        builder.leaf(7 - side, Colour::black);
        for (int level = 1; level < max_depth; ++level) builder.close();
    }
    builder.close();
    const Octree tree = builder.finish(max_depth).tree;
    EXPECT_EQ(Labelled(tree, inner_solid, Connectivity::corners).outcome.components, 1U);
    EXPECT_EQ(Labelled(tree, inner_solid, Connectivity::edges).outcome.components, 2U);
    const Labelled found(tree, inner_solid, Connectivity::faces);
    ASSERT_EQ(found.outcome.components, 2U);
    const std::int32_t middle = root_side / 2;
    EXPECT_EQ(found.components[1].box.low, (Point{{middle, middle, middle}}));
    EXPECT_EQ(found.components[1].box.high, (Point{{middle + 1, middle + 1, middle + 1}}));
    EXPECT_EQ(found.components[1].volume, 1U);
    EXPECT_EQ(found.job.component_of(Point{{middle - 1, middle - 1, middle - 1}}), 0U);
    EXPECT_EQ(found.job.component_of(Point{{middle - 1, middle, middle - 1}}), no_component);
    EXPECT_EQ(found.job.component_of(Point{{-1, 0, 0}}), no_component);
    EXPECT_EQ(found.job.component_of(Point{{0, 0, root_side}}), no_component);
}

TEST(Components, EveryStepBudgetGivesTheSameLabels) {
    HeapPool pool(3000);
    const DenseGrid grid = grid_of(11);
    const Octree tree = planted(grid, *pool);
    const Labelled whole(tree, outer_void, Connectivity::edges);
    for (const std::uint32_t budget : {1U, 2U, 3U, 17U, 1000U}) {
        const Labelled stepped(tree, outer_void, Connectivity::edges, budget);
        EXPECT_EQ(stepped.scratch, whole.scratch);
        EXPECT_EQ(stepped.job.units_visited(), whole.job.units_visited());
    }
    const Measures m = measure(tree);
    EXPECT_LE(whole.job.units_visited(), 27 * (8 * m.nodes + 1) + m.nodes + m.white_leaves);
}

TEST(Components, ShortScratchIsRefusedWithTheWordsNeeded) {
    HeapPool pool(3000);
    const Octree tree = planted(grid_of(6), *pool);
    const auto needed = static_cast<std::uint32_t>(component_scratch(measure(tree), inner_solid));
    ASSERT_GT(needed, 10U);
    for (std::uint32_t size = 0; size < needed; ++size) {
        std::vector<std::uint32_t> scratch(size);
        ComponentLabelling job;
        EXPECT_EQ(job.finish().status, Status::unfinished);
        EXPECT_FALSE(job.step(1));
        job.begin(tree, inner_solid, Connectivity::faces, scratch.data(), size);
        while (job.step(3)) {
        }
        const ComponentOutcome outcome = job.finish();
        EXPECT_EQ(outcome.status, Status::scratch_too_small);
        EXPECT_EQ(outcome.scratch_needed, needed);
        EXPECT_EQ(outcome.components, 0U);
    }
}

TEST(Components, FillWritesNoMoreThanThereIsRoomFor) {
    HeapPool pool(3000);
    const Octree tree = planted(grid_of(15), *pool);
    const Labelled found(tree, inner_solid, Connectivity::faces);
    ASSERT_GT(found.outcome.components, 3U);
    std::vector<Component> few(3);
    ASSERT_EQ(found.job.fill(few.data(), 3), 3U);
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].volume, found.components[i].volume);
    std::vector<Component> many(found.outcome.components + 5, Component{77, 0, {}, false});
    EXPECT_EQ(found.job.fill(many.data(), static_cast<std::uint32_t>(many.size())), found.outcome.components);
    EXPECT_EQ(many.back().volume, 77U);
}

// The size is an upper bound: more than there can be words is as good as enough.
TEST(Components, ScratchOfEverySizeThatCanBeStated) {
    HeapPool pool(3000);
    const Octree tree = planted(grid_of(6), *pool);
    const Labelled exact(tree, inner_solid, Connectivity::faces);
    std::vector<std::uint32_t> scratch(exact.scratch.size());
    for (const std::uint32_t size : {std::uint32_t{1} << 31, UINT32_MAX}) {
        ComponentLabelling job;
        job.begin(tree, inner_solid, Connectivity::faces, scratch.data(), size);
        while (job.step(1000)) {
        }
        EXPECT_EQ(job.finish().status, Status::ok);
        EXPECT_EQ(job.finish().components, exact.outcome.components);
        EXPECT_EQ(scratch, exact.scratch);
    }
}

} // namespace

} // namespace osem::tests
