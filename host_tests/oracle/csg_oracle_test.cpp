// Expressions of three solids, one of them standing twice, against exact geometry cell by cell.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "cell_grid.hpp"
#include "converted.hpp"
#include "level.hpp"
#include "osem/csg.hpp"
#include "solids.hpp"
#include "support/expressions.hpp"

namespace oracle {

namespace {

using osem::tests::Tokens;

constexpr unsigned operand_count = 3;

// A solid, its face list, and the colours that its cells have.
struct TreeOperand {
    TreeOperand(const TestSolid& solid, const osem::CsgOptions& options)
        : faces(osem::convert_scratch(solid.view())),
          walked(osem::CheckedSolid::vouched(solid.view()), osem::WindingRule::nonzero, faces.data(),
                 static_cast<std::uint32_t>(faces.size())) {
        const CellGrid grid(ExactSolid(solid.view()), osem::root_octant, options.depth);
        for (std::size_t i = 0; i < grid.size(); ++i) {
            truth.push_back(colour_of(grid[i], options.leaves, osem::WindingRule::nonzero));
        }
    }

    std::vector<std::uint32_t> faces;
    osem::CsgSolid walked;
    std::vector<osem::Colour> truth;
};

std::uint64_t test_expression(std::vector<TreeOperand>& operands, const Tokens& tokens,
                              const osem::CsgOptions& options) {
    std::vector<osem::CsgOperand> walked;
    for (TreeOperand& operand : operands) walked.emplace_back(operand.walked);
    HeapPool pool(1U << 14);
    osem::CsgConversion job;
    const osem::CsgOutcome outcome =
        osem::convert_expression(job, tokens.data(), static_cast<std::uint32_t>(tokens.size()), walked.data(),
                                 operand_count, options, &*pool);
    EXPECT_EQ(outcome.built.status, osem::Status::ok);
    const Report report =
        compare(outcome.built.tree, osem::root_octant, options.depth, [&](std::size_t cell) {
            std::vector<osem::Colour> colours;
            for (const TreeOperand& operand : operands) colours.push_back(operand.truth[cell]);
            return osem::tests::colour_at(tokens, colours);
        });
    EXPECT_TRUE(report.good()) << report.wrong_leaves << " wrong leaves; " << report.first;
    return report.leaves;
}

void test_triples(const std::vector<TestSolid>& solids, const osem::CsgOptions& options) {
    std::mt19937 random(41);
    std::uint64_t leaves = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        std::vector<TreeOperand> operands;
        operands.reserve(operand_count); // an operand may not move: its solid knows where its list is
        for (std::size_t k = 0; k < operand_count; ++k) {
            operands.emplace_back(solids[(i + 5 * k) % solids.size()], options);
        }
        for (int round = 0; round < 4; ++round) {
            leaves +=
                test_expression(operands, osem::tests::read_once_expression(operand_count, random), options);
            leaves +=
                test_expression(operands, osem::tests::any_expression(5, operand_count, random), options);
        }
    }
    std::printf("depth %d, %s: %zu triples, %llu leaves\n", options.depth, name_of(options.leaves),
                solids.size(), static_cast<unsigned long long>(leaves));
}

TEST(CsgOracle, ExpressionsOfThreeSolids) {
    std::vector<TestSolid> solids = library(aligned_grid);
    for (TestSolid& solid : random_solids(crooked_grid, 10, 4100)) solids.push_back(std::move(solid));
    solids = every(is_full() ? 1 : 3, std::move(solids));
    for (const auto rule : {osem::LeafRule::conservative, osem::LeafRule::centre}) {
        test_triples(solids, osem::CsgOptions{4, rule});
    }
}

} // namespace

} // namespace oracle
