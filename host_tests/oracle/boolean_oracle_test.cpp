// Combined trees against the exact combination, cell by cell.
#include <gtest/gtest.h>

#include <cstdio>

#include "cell_grid.hpp"
#include "converted.hpp"
#include "level.hpp"
#include "off_mesh.hpp"
#include "solids.hpp"

namespace oracle {

namespace {

constexpr osem::Operator operators[] = {osem::Operator::unite, osem::Operator::intersect,
                                        osem::Operator::subtract, osem::Operator::exclusive_or};

// A solid's tree in a shared pool and the colours that its cells have by exact geometry.
struct Operand {
    std::string name;
    osem::Octree tree;
    std::vector<osem::Colour> truth;
};

std::vector<osem::Colour> colours_of(const CellGrid& grid, const osem::ConvertOptions& options) {
    std::vector<osem::Colour> colours(grid.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        colours[i] = colour_of(grid[i], options.leaves, options.winding);
    }
    return colours;
}

Operand operand(const std::string& name, const osem::Solid& solid, const CellGrid& grid,
                const osem::ConvertOptions& options, osem::NodePool& pool) {
    const osem::CheckOutcome outcome = checked(solid);
    EXPECT_EQ(outcome.status, osem::Status::ok) << name;
    const osem::TreeOutcome tree = converted(outcome.solid, options, pool);
    EXPECT_EQ(tree.status, osem::Status::ok) << name;
    return {name, tree.tree, colours_of(grid, options)};
}

std::uint64_t test_pair(const Operand& a, const Operand& b, int depth, osem::NodePool& pool) {
    std::uint64_t leaves = 0;
    for (const osem::Operator op : operators) {
        const std::uint32_t mark = pool.used();
        osem::Combination job;
        const osem::TreeOutcome outcome = osem::combine(job, op, a.tree, b.tree, pool);
        EXPECT_EQ(outcome.status, osem::Status::ok);
        const Report report = compare(outcome.tree, osem::root_octant, depth,
                                      [&](std::size_t i) { return combined(op, a.truth[i], b.truth[i]); });
        EXPECT_TRUE(report.good()) << a.name << ", " << name_of(op) << ", " << b.name << ", depth " << depth
                                   << ": " << report.wrong_leaves << " wrong leaves; " << report.first;
        leaves += report.leaves;
        pool.roll_back(mark);
    }
    return leaves;
}

std::uint64_t test_complement(const Operand& a, int depth, osem::NodePool& pool) {
    const std::uint32_t mark = pool.used();
    osem::Combination job;
    const osem::TreeOutcome outcome = osem::complement(job, a.tree, pool);
    EXPECT_EQ(outcome.status, osem::Status::ok);
    const Report report = compare(outcome.tree, osem::root_octant, depth, [&](std::size_t i) {
        return combined(osem::Operator::subtract, osem::Colour::black, a.truth[i]);
    });
    EXPECT_TRUE(report.good()) << "not " << a.name << ", depth " << depth << ": " << report.first;
    pool.roll_back(mark);
    return report.leaves;
}

std::vector<TestSolid> all_solids(const Grid& grid, unsigned random_count) {
    std::vector<TestSolid> solids = library(grid);
    for (TestSolid& solid : random_solids(grid, random_count, 4000)) solids.push_back(std::move(solid));
    return solids;
}

// With centre leaves sampling and combining commute: the tree is that of the exact combination. With
// conservative ones each cell's colour is Kleene's combination of the exact colours of the operands' cells.
void test_all_pairs(const std::vector<TestSolid>& solids, int depth, osem::LeafRule rule, std::size_t step) {
    const osem::ConvertOptions options{depth, rule, osem::WindingRule::nonzero};
    HeapPool pool(1U << 21);
    std::vector<Operand> operands;
    for (const TestSolid& solid : solids) {
        const CellGrid grid(ExactSolid(solid.view()), osem::root_octant, depth);
        operands.push_back(operand(solid.name, solid.view(), grid, options, *pool));
    }
    std::uint64_t pairs = 0;
    std::uint64_t leaves = 0;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        leaves += test_complement(operands[i], depth, *pool);
        for (std::size_t k = i % step; k < operands.size(); k += step, ++pairs) {
            leaves += test_pair(operands[i], operands[k], depth, *pool);
        }
    }
    std::printf("depth %d, %s: %llu pairs, %llu leaves\n", depth, name_of(rule),
                static_cast<unsigned long long>(pairs), static_cast<unsigned long long>(leaves));
}

TEST(BooleanOracle, EveryPairOfTheLibraryAtDepthFour) {
    const std::size_t step = is_full() ? 1 : 5;
    test_all_pairs(all_solids(aligned_grid, 20), 4, osem::LeafRule::centre, step);
    test_all_pairs(all_solids(aligned_grid, 20), 4, osem::LeafRule::conservative, step);
}

TEST(BooleanOracle, PairsOfTheLibraryAtDepthFive) {
    const std::vector<TestSolid> solids = every(is_full() ? 1 : 6, all_solids(crooked_grid, 20));
    test_all_pairs(solids, 5, osem::LeafRule::centre, 5);
    test_all_pairs(solids, 5, osem::LeafRule::conservative, 5);
}

bool exact_result(osem::Operator op, bool a, bool b) {
    switch (op) {
    case osem::Operator::unite:
        return a || b;
    case osem::Operator::intersect:
        return a && b;
    case osem::Operator::subtract:
        return a && !b;
    case osem::Operator::exclusive_or:
        break;
    }
    return a != b;
}

// Black and white leaves of a conservative combination hold throughout: every cell two levels further down
// has the exact combination's colour at its centre.
void test_soundness(const Operand& a, const Operand& b, const CellGrid& fine_a, const CellGrid& fine_b,
                    osem::NodePool& pool) {
    for (const osem::Operator op : operators) {
        const std::uint32_t mark = pool.used();
        osem::Combination job;
        const osem::TreeOutcome outcome = osem::combine(job, op, a.tree, b.tree, pool);
        ASSERT_EQ(outcome.status, osem::Status::ok);
        osem::LeafWalk walk(outcome.tree);
        std::size_t cell = 0; // leaves come in Morton order, which is that of the fine cells
        std::size_t wrong = 0;
        for (osem::Leaf leaf{}; walk.next(leaf);) {
            const std::size_t end = cell + (std::size_t{1} << (3 * (fine_a.depth() - leaf.octant.level)));
            for (; cell < end; ++cell) {
                const bool inside = exact_result(op, fine_a[cell].winding != 0, fine_b[cell].winding != 0);
                wrong += leaf.colour == (inside ? osem::Colour::white : osem::Colour::black) ? 1U : 0U;
            }
        }
        EXPECT_EQ(cell, fine_a.size());
        EXPECT_EQ(wrong, 0U) << a.name << ", " << name_of(op) << ", " << b.name;
        pool.roll_back(mark);
    }
}

TEST(BooleanOracle, ConservativeColoursHoldThroughout) {
    const int depth = 3;
    const osem::ConvertOptions options{depth, osem::LeafRule::conservative, osem::WindingRule::nonzero};
    HeapPool pool(1U << 18);
    std::vector<Operand> operands;
    std::vector<CellGrid> fine;
    for (const TestSolid& solid : every(is_full() ? 1 : 6, all_solids(aligned_grid, 12))) {
        const ExactSolid exact(solid.view());
        operands.push_back(
            operand(solid.name, solid.view(), CellGrid(exact, osem::root_octant, depth), options, *pool));
        fine.emplace_back(exact, osem::root_octant, depth + 2);
    }
    const std::size_t step = 3;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        for (std::size_t k = i % step; k < operands.size(); k += step) {
            test_soundness(operands[i], operands[k], fine[i], fine[k], *pool);
        }
    }
}

TEST(BooleanOracle, RealMeshes) {
    if (mesh_folder().empty()) FAIL() << "OSEM_CGAL_DATA names no folder";
    const int depth = is_full() ? 6 : 4;
    const auto first = read_off(is_full() ? "elephant" : "eight", whole_root);
    const auto second = read_off("rotor", Fit{{{200003, 150001, 99991}}, 700001});
    ASSERT_TRUE(first && second);
    const ExactSolid exact_first(first->view());
    const ExactSolid exact_second(second->view());
    const CellGrid grid_first(exact_first, osem::root_octant, depth);
    const CellGrid grid_second(exact_second, osem::root_octant, depth);
    for (const auto rule : {osem::LeafRule::centre, osem::LeafRule::conservative}) {
        const osem::ConvertOptions options{depth, rule, osem::WindingRule::nonzero};
        HeapPool pool(1U << 20);
        const Operand a = operand("first mesh", first->view(), grid_first, options, *pool);
        const Operand b = operand("second mesh", second->view(), grid_second, options, *pool);
        const std::uint64_t leaves = test_pair(a, b, depth, *pool) + test_pair(b, a, depth, *pool);
        std::printf("real meshes, depth %d, %s: %llu leaves\n", depth, name_of(rule),
                    static_cast<unsigned long long>(leaves));
    }
}

} // namespace

} // namespace oracle
