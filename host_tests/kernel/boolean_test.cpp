// Booleans against the dense-grid model, and the laws they obey.
#include "osem/boolean.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr Operator operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                  Operator::exclusive_or};

Combination job;

Octree combined_tree(Operator op, const Octree& a, const Octree& b, NodePool& pool) {
    const TreeOutcome outcome = combine(job, op, a, b, pool);
    EXPECT_EQ(outcome.status, Status::ok) << describe(outcome.status);
    return outcome.tree;
}

Octree complement_tree(const Octree& a, NodePool& pool) {
    const TreeOutcome outcome = complement(job, a, pool);
    EXPECT_EQ(outcome.status, Status::ok) << describe(outcome.status);
    return outcome.tree;
}

// Three trees in a pool, sometimes with a uniform one among them, of depths 1 to 4.
struct Trio {
    explicit Trio(std::uint32_t seed, const std::vector<Colour>& palette) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t own = 3 * seed + i;
            if (own % 11 == 0) {
                grids.emplace_back(1, palette[own % palette.size()]);
                trees.push_back(Octree::uniform(*pool, palette[own % palette.size()]));
            } else {
                grids.push_back(random_grid(1 + static_cast<int>((own / 2) % 4), own, palette));
                trees.push_back(planted(grids.back(), *pool));
            }
        }
    }
    HeapPool pool{40000};
    std::vector<DenseGrid> grids;
    std::vector<Octree> trees;
};

TEST(Boolean, EveryOperatorAgreesWithTheGrid) {
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        Trio trio(seed, seed % 3 == 0 ? two_colours : three_colours);
        const Octree& a = trio.trees[0];
        const Octree& b = trio.trees[1];
        for (const Operator op : operators) {
            const DenseGrid expected = combined(op, trio.grids[0], trio.grids[1]);
            const Octree result = combined_tree(op, a, b, *trio.pool);
            ASSERT_EQ(result.depth, expected.depth());
            ASSERT_EQ(expand(result, expected.depth()), expected)
                << "seed " << seed << ", operator " << static_cast<int>(op);
            ASSERT_EQ(digest(result), expected_digest(expected)) << "seed " << seed;
        }
        const DenseGrid inverse = complemented(trio.grids[0]);
        ASSERT_EQ(expand(complement_tree(a, *trio.pool), inverse.depth()), inverse) << "seed " << seed;
    }
}

TEST(Boolean, ResultsAreOperandsAgain) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        Trio trio(seed, three_colours);
        std::mt19937 random(seed);
        for (int round = 0; round < 12; ++round) {
            const Operator op = operators[random() % 4];
            const std::size_t i = random() % 3;
            const std::size_t j = random() % 3;
            trio.grids[i] = combined(op, trio.grids[i], trio.grids[j]);
            trio.trees[i] = combined_tree(op, trio.trees[i], trio.trees[j], *trio.pool);
            ASSERT_EQ(digest(trio.trees[i]), expected_digest(trio.grids[i]))
                << "seed " << seed << ", round " << round;
        }
    }
}

TEST(Boolean, LawsOfKleeneLogic) {
    for (std::uint32_t seed = 0; seed < 80; ++seed) {
        Trio trio(seed, three_colours);
        NodePool& pool = *trio.pool;
        const Octree& a = trio.trees[0];
        const Octree& b = trio.trees[1];
        const Octree& c = trio.trees[2];
        const auto both = [&](Operator op, const Octree& x, const Octree& y) {
            return combined_tree(op, x, y, pool);
        };
        const auto inverse_of = [&](const Octree& x) { return complement_tree(x, pool); };
        for (const Operator op : {Operator::unite, Operator::intersect, Operator::exclusive_or}) {
            EXPECT_EQ(digest(both(op, a, b)), digest(both(op, b, a))) << "seed " << seed;
            EXPECT_EQ(digest(both(op, both(op, a, b), c)), digest(both(op, a, both(op, b, c)))) << seed;
        }
        const Operator unite = Operator::unite;
        const Operator intersect = Operator::intersect;
        EXPECT_TRUE(same_leaves(inverse_of(both(unite, a, b)), both(intersect, inverse_of(a), inverse_of(b))))
            << seed;
        EXPECT_TRUE(same_leaves(inverse_of(both(intersect, a, b)), both(unite, inverse_of(a), inverse_of(b))))
            << seed;
        EXPECT_TRUE(same_leaves(both(unite, a, both(intersect, a, b)), a)) << seed;
        EXPECT_TRUE(same_leaves(both(intersect, a, both(unite, a, b)), a)) << seed;
        EXPECT_TRUE(same_leaves(both(unite, a, a), a)) << seed;
        EXPECT_TRUE(same_leaves(both(intersect, a, a), a)) << seed;
        EXPECT_TRUE(same_leaves(inverse_of(inverse_of(a)), a)) << seed;
        EXPECT_TRUE(same_leaves(both(Operator::subtract, a, b), both(intersect, a, inverse_of(b)))) << seed;
        EXPECT_TRUE(same_leaves(both(intersect, a, both(unite, b, c)),
                                both(unite, both(intersect, a, b), both(intersect, a, c))))
            << seed;
    }
}

TEST(Boolean, LawsOfSetsOnTreesWithoutBoundary) {
    for (std::uint32_t seed = 0; seed < 80; ++seed) {
        Trio trio(seed, two_colours);
        NodePool& pool = *trio.pool;
        const Octree& a = trio.trees[0];
        const Octree& b = trio.trees[1];
        const Octree either = combined_tree(Operator::unite, a, b, pool);
        const Octree both = combined_tree(Operator::intersect, a, b, pool);
        EXPECT_EQ(measure(a).inner_volume + measure(b).inner_volume,
                  measure(either).inner_volume + measure(both).inner_volume)
            << "seed " << seed;
        const Octree exclusive = combined_tree(Operator::exclusive_or, a, b, pool);
        const Octree a_only = combined_tree(Operator::subtract, a, b, pool);
        const Octree b_only = combined_tree(Operator::subtract, b, a, pool);
        EXPECT_TRUE(same_leaves(exclusive, combined_tree(Operator::unite, a_only, b_only, pool))) << seed;
        EXPECT_TRUE(same_leaves(exclusive, combined_tree(Operator::subtract, either, both, pool))) << seed;
        const Octree nothing = combined_tree(Operator::exclusive_or, a, a, pool);
        EXPECT_EQ(nothing.top, Node::uniform(Colour::white)) << seed;
        EXPECT_EQ(combined_tree(Operator::unite, a, complement_tree(a, pool), pool).top,
                  Node::uniform(Colour::black));
    }
}

// Whatever is put in the place of the operands' boundary cells, the exact combination of the two has the
// result's black cells and has not its white ones.
TEST(Boolean, ResultsHoldForEveryResolutionOfTheBoundary) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const DenseGrid a = random_grid(3, 2 * seed, three_colours);
        const DenseGrid b = random_grid(3, 2 * seed + 1, three_colours);
        HeapPool pool(20000);
        const Octree tree_a = planted(a, *pool);
        const Octree tree_b = planted(b, *pool);
        std::mt19937 random(seed);
        const auto resolved = [&random](DenseGrid grid) {
            for (std::size_t cell = 0; cell < grid.size(); ++cell) {
                if (grid[cell] == Colour::boundary) grid[cell] = two_colours[random() % 2];
            }
            return grid;
        };
        for (const Operator op : operators) {
            const DenseGrid result = expand(combined_tree(op, tree_a, tree_b, *pool), 3);
            for (int trial = 0; trial < 8; ++trial) {
                const DenseGrid exact = combined(op, resolved(a), resolved(b));
                for (std::size_t cell = 0; cell < result.size(); ++cell) {
                    const bool holds = result[cell] == Colour::boundary || result[cell] == exact[cell];
                    ASSERT_TRUE(holds) << "seed " << seed << ", cell " << cell;
                }
            }
        }
    }
}

TEST(Boolean, OperandsOfUnequalDepth) {
    HeapPool pool(20000);
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const DenseGrid shallow = random_grid(1, seed, three_colours);
        const DenseGrid deep = random_grid(4, seed + 500, three_colours);
        const Octree a = planted(shallow, *pool);
        const Octree b = planted(deep, *pool);
        for (const Operator op : operators) {
            for (const bool swapped : {false, true}) {
                const Octree result = combined_tree(op, swapped ? b : a, swapped ? a : b, *pool);
                const DenseGrid expected =
                    swapped ? combined(op, deep, shallow) : combined(op, shallow, deep);
                EXPECT_EQ(result.depth, 4);
                EXPECT_EQ(expand(result, 4), expected) << "seed " << seed;
            }
        }
        pool->roll_back(0);
    }
}

} // namespace

} // namespace osem::tests
