// The leaves of a grid as nodes of a tree, against a colour for each cell.
#include "grid/leaves.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "grid/octant_grid.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

using Rows = std::vector<std::uint32_t>;

std::array<std::uint32_t, 3> index_of(const DenseGrid& grid, std::size_t cell) {
    std::array<std::uint32_t, 3> index = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        index[axis] = static_cast<std::uint32_t>(grid.corner(cell).at[axis] / grid.cell_side());
    }
    return index;
}

// Octants are inside as the cells are black; where they are boundary, that does not matter.
struct Sets {
    Rows inside;
    Rows met;

    Sets(const DenseGrid& grid, std::mt19937& random)
        : inside(std::size_t{1} << (2 * grid.depth())), met(inside.size()) {
        for (std::size_t cell = 0; cell < grid.size(); ++cell) {
            const std::array<std::uint32_t, 3> at = index_of(grid, cell);
            const std::size_t row = at[axis_y] + (std::size_t{at[axis_z]} << grid.depth());
            const bool is_met = grid[cell] == Colour::boundary;
            const bool is_inside = grid[cell] == Colour::black || (is_met && random() % 2 == 0);
            inside[row] |= std::uint32_t{is_inside} << at[axis_x];
            met[row] |= std::uint32_t{is_met} << at[axis_x];
        }
    }
};

TreeOutcome tree_of(const Sets& sets, int levels, bool three_valued, NodePool* pool) {
    Rows scratch(sets.inside.size() / 64); // none where there is no cube
    TreeBuilder builder;
    builder.begin(pool);
    GridLeaves{levels, sets.inside.data(), three_valued ? sets.met.data() : nullptr, scratch.data()}.set(
        builder);
    builder.close();
    return builder.finish(levels);
}

void expect_tree_of(const DenseGrid& grid, bool three_valued, std::mt19937& random) {
    const Sets sets(grid, random);
    const auto needed = static_cast<std::uint32_t>(preorder_masks(grid).size() - 1);
    // Near the end of the pool parts are built otherwise: so it is once far away and once here.
    for (const std::uint32_t more : {0U, 100U}) {
        HeapPool pool(needed + more);
        const TreeOutcome outcome = tree_of(sets, grid.depth(), three_valued, &*pool);
        ASSERT_EQ(outcome.status, Status::ok);
        EXPECT_EQ(outcome.nodes_needed, needed);
        EXPECT_EQ(expand(outcome.tree, grid.depth()), grid);
        EXPECT_EQ(digest(outcome.tree), expected_digest(grid));
    }
    EXPECT_EQ(tree_of(sets, grid.depth(), three_valued, nullptr).nodes_needed, needed);
}

TEST(GridLeaves, MakeTheTreeOfTheirCells) {
    std::mt19937 random(5);
    for (int levels = 1; levels <= most_grid_levels; ++levels) {
        for (std::uint32_t seed = 0; seed < 24; ++seed) {
            SCOPED_TRACE(::testing::Message() << levels << " levels, seed " << seed);
            expect_tree_of(random_grid(levels, seed, two_colours), false, random);
            expect_tree_of(random_grid(levels, seed, three_colours), true, random);
        }
    }
}

// Each colour all over, and one cell that is not like the others: each one, of deep grids some.
TEST(GridLeaves, OneCellAmongOthers) {
    std::mt19937 random(6);
    for (int levels = 1; levels <= most_grid_levels; ++levels) {
        for (const Colour all : three_colours) {
            expect_tree_of(DenseGrid(levels, all), true, random);
            for (const Colour one : three_colours) {
                if (one == all) continue;
                const std::size_t cells = std::size_t{1} << (3 * levels);
                for (std::size_t trial = 0; trial < (cells < 512 ? cells : 16); ++trial) {
                    DenseGrid grid(levels, all);
                    grid[cells < 512 ? trial : random() % cells] = one;
                    expect_tree_of(grid, true, random);
                }
            }
        }
    }
}

TEST(GridLeaves, CubesInMortonOrder) {
    const DenseGrid cube(3);
    std::mt19937 random(7);
    for (int levels = 3; levels <= most_grid_levels; ++levels) {
        Rows rows(std::size_t{1} << (2 * levels));
        for (int trial = 0; trial < 20; ++trial) {
            for (std::uint32_t& row : rows) row = static_cast<std::uint32_t>(random());
            for (std::uint32_t corner = 0; corner < 1U << (3 * (levels - 3)); ++corner) {
                const std::uint32_t mask = (1U << (levels - 3)) - 1U;
                const std::uint32_t x = 8 * (corner & mask);
                const std::uint32_t row =
                    8 * (corner >> (levels - 3) & mask) + (8 * (corner >> (2 * (levels - 3))) << levels);
                std::uint64_t sets[8] = {};
                eight_in_morton_order(&rows[row], x, levels, sets);
                for (std::size_t place = 0; place < cube.size(); ++place) {
                    const std::array<std::uint32_t, 3> at = index_of(cube, place);
                    ASSERT_EQ(sets[place / 64] >> (place % 64) & 1U,
                              rows[row + at[axis_y] + (at[axis_z] << levels)] >> (x + at[axis_x]) & 1U);
                }
            }
        }
    }
}

} // namespace

} // namespace osem::tests
