// Every leaf of every tree of the library against the exact truth about its cells.
#include <gtest/gtest.h>

#include <cstdio>

#include "cell_grid.hpp"
#include "converted.hpp"
#include "level.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

struct LeafTotals {
    std::uint64_t trees = 0;
    std::uint64_t leaves = 0;
    std::uint64_t cells = 0;
};

constexpr osem::WindingRule winding_rules[] = {osem::WindingRule::nonzero, osem::WindingRule::odd,
                                               osem::WindingRule::positive};

void test_rule(const TestSolid& solid, const osem::CheckedSolid& checked_solid, const CellGrid& grid,
               const osem::ConvertOptions& options, osem::NodePool& pool, LeafTotals& totals) {
    const osem::TreeOutcome outcome = converted(checked_solid, options, pool);
    ASSERT_EQ(outcome.status, osem::Status::ok) << solid.name << ", depth " << options.depth;
    const Report report = compare(outcome.tree, grid, options);
    EXPECT_TRUE(report.good()) << solid.name << ", depth " << options.depth << ", " << name_of(options.leaves)
                               << ", " << name_of(options.winding) << ": " << report.wrong_leaves
                               << " wrong leaves; " << report.first;
    ++totals.trees;
    totals.leaves += report.leaves;
    totals.cells += report.cells;
    pool.roll_back(0);
}

void test_solid(const TestSolid& solid, const osem::Octant& window, int first_depth, int last_depth,
                LeafTotals& totals) {
    const osem::CheckOutcome outcome = checked(solid.view());
    ASSERT_EQ(outcome.status, osem::Status::ok) << solid.name << ": " << osem::describe(outcome.status);
    const ExactSolid exact(solid.view());
    HeapPool pool(1U << 20);
    for (int depth = first_depth; depth <= last_depth; ++depth) {
        const CellGrid grid(exact, window, depth);
        for (const auto leaves : {osem::LeafRule::conservative, osem::LeafRule::centre}) {
            if (leaves == osem::LeafRule::centre && depth == osem::max_depth) continue;
            for (const auto winding : winding_rules) {
                const osem::ConvertOptions options{depth, leaves, winding};
                test_rule(solid, outcome.solid, grid, options, *pool, totals);
            }
        }
    }
}

void test_all(const std::vector<TestSolid>& solids, const osem::Octant& window, int first_depth,
              int last_depth) {
    LeafTotals totals;
    for (const TestSolid& solid : solids) test_solid(solid, window, first_depth, last_depth, totals);
    std::printf("%zu solids, %llu trees, %llu leaves, %llu cells\n", solids.size(),
                static_cast<unsigned long long>(totals.trees), static_cast<unsigned long long>(totals.leaves),
                static_cast<unsigned long long>(totals.cells));
}

TEST(LeafOracle, LibraryOnOctantPlanes) {
    test_all(library(aligned_grid), osem::root_octant, 1, is_full() ? 6 : 4);
}

TEST(LeafOracle, LibraryOffOctantPlanes) {
    test_all(library(crooked_grid), osem::root_octant, 1, is_full() ? 6 : 4);
}

// Solids a few units wide, down to leaves of side 1, whose centres are no lattice points.
TEST(LeafOracle, LibraryAtLeavesOfSideOne) {
    test_all(every(is_full() ? 1 : 4, library(tiny_grid)), tiny_window, is_full() ? 16 : 18, osem::max_depth);
}

TEST(LeafOracle, SomeOfTheLibraryDeeper) {
    const std::size_t step = is_full() ? 4 : 16;
    const int depth = is_full() ? 7 : 5;
    test_all(every(step, library(aligned_grid)), osem::root_octant, depth, depth);
    test_all(every(step, library(crooked_grid)), osem::root_octant, depth, depth);
}

TEST(LeafOracle, RandomSolids) {
    const unsigned count = is_full() ? 120 : 20;
    test_all(random_solids(aligned_grid, count, 1000), osem::root_octant, 1, is_full() ? 5 : 4);
    test_all(random_solids(crooked_grid, count, 2000), osem::root_octant, 1, is_full() ? 5 : 4);
    test_all(random_solids(tiny_grid, count, 3000), tiny_window, 19, osem::max_depth);
}

} // namespace

} // namespace oracle
