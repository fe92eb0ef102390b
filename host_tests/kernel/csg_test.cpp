// Expressions against what they mean point by point: every operand is 0 or 1 there, wherever it stands.
#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "osem/csg.hpp"
#include "support/byte_stream.hpp"
#include "support/dense_grid.hpp"
#include "support/expressions.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

CsgOutcome run(CsgConversion& job, const Tokens& tokens, const std::vector<CsgOperand>& operands,
               const CsgOptions& options, NodePool* pool) {
    return convert_expression(job, tokens.data(), static_cast<std::uint32_t>(tokens.size()), operands.data(),
                              static_cast<std::uint32_t>(operands.size()), options, pool);
}

// Random trees as operands: every other one in a pool, the others as streams.
class Trees {
  public:
    Trees(std::uint32_t seed, unsigned count, int depth, const std::vector<Colour>& palette) {
        for (unsigned i = 0; i < count; ++i) {
            const int own_depth = 1 + static_cast<int>((seed + i) % static_cast<unsigned>(depth));
            const DenseGrid grid = random_grid(own_depth, 31 * seed + i, palette);
            trees_.push_back(planted(grid, *pool));
            grids_.push_back(refined(grid, depth));
        }
    }

    std::vector<CsgOperand> operands() {
        held_trees_.clear();
        held_streams_.clear();
        std::vector<CsgOperand> operands;
        for (std::size_t i = 0; i < trees_.size(); ++i) {
            if (i % 2 == 0) {
                held_trees_.push_back(std::make_unique<CsgTree>(trees_[i]));
                operands.emplace_back(*held_trees_.back());
                continue;
            }
            bytes_.push_back(std::make_unique<Bytes>(written(trees_[i], StreamHeader{})));
            held_streams_.push_back(
                std::make_unique<CsgStream>(memory_source(bytes_.back()->data(), bytes_.back()->size())));
            operands.emplace_back(*held_streams_.back());
        }
        return operands;
    }

    std::size_t cells() const { return grids_[0].size(); }
    std::vector<Colour> colours(std::size_t cell) const {
        std::vector<Colour> colours;
        for (const DenseGrid& grid : grids_) colours.push_back(grid[cell]);
        return colours;
    }
    std::vector<Colour> colours_of_octant(std::size_t first, std::size_t count) const {
        std::vector<Colour> colours;
        for (const DenseGrid& grid : grids_) {
            colours.push_back(grid.uniform_colour(first, count).value_or(Colour::grey));
        }
        return colours;
    }

    HeapPool pool{60000};
    const std::vector<Octree>& trees() const { return trees_; }

  private:
    std::vector<Octree> trees_;
    std::vector<DenseGrid> grids_;
    std::vector<std::unique_ptr<CsgTree>> held_trees_;
    std::vector<std::unique_ptr<Bytes>> bytes_;
    std::vector<std::unique_ptr<CsgStream>> held_streams_;
};

constexpr int depth = 3;

CsgOptions options_of(int result_depth, LeafRule leaves = LeafRule::conservative) {
    CsgOptions options;
    options.depth = result_depth;
    options.leaves = leaves;
    return options;
}

TEST(Csg, EveryCellHasTheValueOfTheExpressionAtItsPoints) {
    std::mt19937 random(1);
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const unsigned operand_count = 1 + seed % 5;
        Trees trees(seed, operand_count, depth, seed % 3 == 0 ? two_colours : three_colours);
        const Tokens tokens = any_expression(1 + seed % 8, operand_count, random);
        CsgConversion job;
        const CsgOutcome outcome = run(job, tokens, trees.operands(), options_of(depth), &*trees.pool);
        ASSERT_EQ(outcome.built.status, Status::ok) << "seed " << seed;
        DenseGrid expected(depth);
        for (std::size_t cell = 0; cell < trees.cells(); ++cell) {
            expected[cell] = colour_at(tokens, trees.colours(cell));
        }
        EXPECT_EQ(expand(outcome.built.tree, depth), expected) << "seed " << seed;
        EXPECT_EQ(digest(outcome.built.tree), expected_digest(expected)) << "canonical, seed " << seed;
    }
}

std::uint64_t octants_entered(const Trees& trees, const Tokens& tokens, std::size_t first,
                              std::size_t count) {
    if (!depends_on_grey(tokens, trees.colours_of_octant(first, count))) return 0;
    std::uint64_t entered = 1;
    for (std::size_t k = 0; k < 8; ++k) {
        entered += octants_entered(trees, tokens, first + k * (count / 8), count / 8);
    }
    return entered;
}

TEST(Csg, DecidedOctantsAreNeverEntered) {
    std::mt19937 random(2);
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        const unsigned operand_count = 1 + seed % 5;
        Trees trees(seed, operand_count, depth, three_colours);
        const Tokens tokens = read_once_expression(operand_count, random);
        CsgConversion job;
        const CsgOutcome outcome = run(job, tokens, trees.operands(), options_of(depth), nullptr);
        ASSERT_EQ(outcome.built.status, Status::ok) << "seed " << seed;
        EXPECT_EQ(job.octants_visited(), 1 + 8 * octants_entered(trees, tokens, 0, trees.cells()))
            << "seed " << seed;
    }
}

TEST(Csg, ReadOnceExpressionsAreWhatCombinationsMakeOfTheSolids) {
    const SmallSolid solids[] = {
        box_solid({Point{{100001, 200003, 150001}}, Point{{700001, 800009, 900001}}}),
        octahedron_solid({Point{{500001, 500001, 400001}}, 330001}),
        diamond_solid({Point{{600001, 400001, 0}}, 250001, 2, 100001, 1000001})};
    for (const LeafRule rule : {LeafRule::conservative, LeafRule::centre}) {
        for (const Operator first : operators) {
            for (const Operator second : operators) {
                HeapPool pool(60000);
                std::vector<std::vector<std::uint32_t>> lists;
                std::vector<CsgSolid> held;
                std::vector<CsgOperand> operands;
                std::vector<Octree> trees;
                ConvertOptions convert_options;
                convert_options.depth = 5;
                convert_options.leaves = rule;
                for (const SmallSolid& solid : solids) {
                    trees.push_back(converted(solid, convert_options, &*pool).tree);
                    lists.emplace_back(solid.face_count());
                }
                for (std::size_t i = 0; i < 3; ++i) {
                    held.emplace_back(solids[i].checked(), WindingRule::nonzero, lists[i].data(),
                                      solids[i].face_count());
                }
                for (CsgSolid& solid : held) operands.emplace_back(solid);
                Combination combination;
                const Octree both = combine(combination, first, trees[0], trees[1], *pool).tree;
                const Octree expected = combine(combination, second, trees[2], both, *pool).tree;
                const Tokens tokens = {CsgToken::of(2), CsgToken::of(0), CsgToken::of(1), CsgToken::of(first),
                                       CsgToken::of(second)};
                CsgConversion job;
                const CsgOutcome outcome = run(job, tokens, operands, options_of(5, rule), &*pool);
                ASSERT_EQ(outcome.built.status, Status::ok);
                EXPECT_TRUE(same_leaves(outcome.built.tree, expected));
            }
        }
    }
}

// A solid, and a tree with boundary leaves.
TEST(Csg, WhatIsDecidedWhateverAnOperandIsTakesOneVisit) {
    const SmallSolid solid = octahedron_solid({Point{{500001, 500001, 400001}}, 330001});
    std::vector<std::uint32_t> list(solid.face_count());
    CsgSolid a(solid.checked(), WindingRule::nonzero, list.data(), solid.face_count());
    Trees trees(5, 1, depth, three_colours);
    const CsgToken x = CsgToken::of(0U);
    const CsgToken y = CsgToken::of(1U);
    const CsgToken minus = CsgToken::of(Operator::subtract);
    const CsgToken inverted = CsgToken::complement();
    const struct {
        Tokens tokens;
        Colour colour;
    } cases[] = {{{x, x, minus}, Colour::white},
                 {{x, x, inverted, CsgToken::of(Operator::unite)}, Colour::black},
                 {{x, x, CsgToken::of(Operator::exclusive_or)}, Colour::white},
                 {{x, y, minus, y, CsgToken::of(Operator::intersect)}, Colour::white},
                 {{y, y, minus}, Colour::white}};
    for (const auto& c : cases) {
        std::vector<CsgOperand> operands = {a};
        operands.push_back(trees.operands()[0]);
        CsgConversion job;
        const CsgOutcome outcome = run(job, c.tokens, operands, options_of(20), &*trees.pool);
        ASSERT_EQ(outcome.built.status, Status::ok);
        EXPECT_EQ(outcome.built.tree.top, Node::uniform(c.colour));
        EXPECT_EQ(job.octants_visited(), 1U);
    }
}

TEST(Csg, OnWindingNumbersEveryRuleIsItsOwn) {
    const std::vector<Box> shells = {
        {Point{{0, 0, 0}}, Point{{1 << 20, 1 << 20, 1 << 20}}},
        {Point{{1 << 18, 1 << 18, 1 << 18}}, Point{{1 << 19, 1 << 19, 1 << 19}}}};
    const SmallSolid solid = boxes_solid(shells);
    std::vector<std::uint32_t> lists[2];
    for (auto& list : lists) list.resize(solid.face_count());
    CsgSolid nonzero(solid.checked(), WindingRule::nonzero, lists[0].data(), solid.face_count());
    CsgSolid odd(solid.checked(), WindingRule::odd, lists[1].data(), solid.face_count());
    HeapPool pool(1000);
    CsgConversion job;
    const CsgOutcome outcome =
        run(job, {CsgToken::of(0U), CsgToken::of(1U), CsgToken::of(Operator::exclusive_or)}, {nonzero, odd},
            options_of(4), &*pool);
    ASSERT_EQ(outcome.built.status, Status::ok);
    const DenseGrid inner_box = make_grid(4, [&](const Point& corner, std::int32_t side) {
        return box_colour({shells[1]}, WindingRule::nonzero, corner, side);
    });
    EXPECT_EQ(expand(outcome.built.tree, 4), inner_box);
}

TEST(Csg, ARefusedExpressionLeavesTheOneBefore) {
    const CsgToken twice[] = {CsgToken::of(0), CsgToken::of(0), CsgToken::of(Operator::exclusive_or)};
    const CsgToken two_values[] = {CsgToken::of(1), CsgToken::of(0)};
    CsgExpression expression;
    std::uint32_t where = 0;
    ASSERT_EQ(expression.begin(twice, 3, 2, where), Status::ok);
    ASSERT_EQ(expression.begin(two_values, 2, 2, where), Status::expression_invalid);
    EXPECT_EQ(expression.evaluate(CsgColours{1, 0}).colour(), Colour::white); // whatever the operand is
}

// Solids whose surface does not meet the open root: none at all, and the root's own.
TEST(Csg, SolidsThatTheRootDoesNotShow) {
    const SmallSolid nothing;
    const SmallSolid all = box_solid({Point{{0, 0, 0}}, Point{{root_side, root_side, root_side}}});
    std::vector<std::uint32_t> list(all.face_count());
    CsgSolid empty(nothing.checked(), WindingRule::nonzero, nullptr, 0);
    CsgSolid full(all.checked(), WindingRule::nonzero, list.data(), all.face_count());
    const CsgToken x = CsgToken::of(0U);
    const CsgToken y = CsgToken::of(1U);
    for (const LeafRule rule : {LeafRule::conservative, LeafRule::centre}) {
        CsgConversion job;
        const CsgOptions options = options_of(5, rule);
        EXPECT_EQ(run(job, {x}, {empty}, options, nullptr).built.tree.top, Node::uniform(Colour::white));
        EXPECT_EQ(run(job, {x}, {full}, options, nullptr).built.tree.top, Node::uniform(Colour::black));
        const CsgOutcome less =
            run(job, {y, x, CsgToken::of(Operator::subtract)}, {empty, full}, options, nullptr);
        EXPECT_EQ(less.built.tree.top, Node::uniform(Colour::black));
    }
}

} // namespace

} // namespace osem::tests
