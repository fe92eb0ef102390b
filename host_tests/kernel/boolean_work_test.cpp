// How Booleans work: what they share, in which steps, and what happens when memory runs out.
#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <utility>

#include "osem/boolean.hpp"
#include "osem/query.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"

namespace osem::tests {

namespace {

constexpr Operator worked_operators[] = {Operator::unite, Operator::intersect, Operator::subtract,
                                         Operator::exclusive_or};

struct Pair {
    explicit Pair(std::uint32_t seed, int depth = 3, const std::vector<Colour>& palette = three_colours)
        : a_grid(random_grid(depth, 2 * seed, palette)), b_grid(random_grid(depth, 2 * seed + 1, palette)),
          a(planted(a_grid, *pool)), b(planted(b_grid, *pool)) {}
    HeapPool pool{30000};
    DenseGrid a_grid;
    DenseGrid b_grid;
    Octree a;
    Octree b;
};

// One cell of side 1 at a corner of the root's octant of a level, as a tree of depth 20.
Octree single_cell(NodePool& pool, unsigned first_child) {
    TreeBuilder builder;
    builder.begin(&pool);
    builder.open(first_child);
    for (int level = 2; level < max_depth; ++level) builder.open(5);
    builder.leaf(5, Colour::black);
    for (int level = 0; level < max_depth; ++level) builder.close();
    return builder.finish(max_depth).tree;
}

Point black_cell(const Octree& tree) {
    LeafWalk walk(tree);
    Leaf leaf = {};
    while (walk.next(leaf) && leaf.colour != Colour::black) {
    }
    return leaf.octant.corner;
}

TEST(BooleanSharing, ATreeWithItselfIsItself) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        Pair pair(seed);
        for (const Operator op : {Operator::unite, Operator::intersect}) {
            Combination job;
            const TreeOutcome outcome = combine(job, op, pair.a, pair.a, *pair.pool);
            ASSERT_EQ(outcome.status, Status::ok);
            EXPECT_EQ(outcome.nodes_needed, 0U) << "seed " << seed;
            EXPECT_EQ(outcome.tree.top, pair.a.top) << "seed " << seed;
            EXPECT_EQ(job.nodes_visited(), 1U) << "subtrees in common are not entered";
        }
    }
}

// The part and the whole are trees built anew, which share no node with the tree. (As the second operand the
// tree cannot always win: where both have equal groups, the first operand's are taken.)
TEST(BooleanSharing, ATreeWithAPartOfItIsItself) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        Pair pair(seed);
        const Octree part = planted(combined(Operator::intersect, pair.a_grid, pair.b_grid), *pair.pool);
        const Octree whole = planted(combined(Operator::unite, pair.a_grid, pair.b_grid), *pair.pool);
        Combination job;
        const TreeOutcome united = combine(job, Operator::unite, pair.a, part, *pair.pool);
        EXPECT_EQ(united.nodes_needed, 0U) << "seed " << seed;
        EXPECT_EQ(united.tree.top, pair.a.top) << "seed " << seed;
        const TreeOutcome common = combine(job, Operator::intersect, pair.a, whole, *pair.pool);
        EXPECT_EQ(common.nodes_needed, 0U) << "seed " << seed;
        EXPECT_EQ(common.tree.top, pair.a.top) << "seed " << seed;
        EXPECT_TRUE(same_leaves(combine(job, Operator::unite, part, pair.a, *pair.pool).tree, pair.a));
    }
}

// Unless the other operand has equal groups: then it makes no difference which of the two comes first.
TEST(BooleanSharing, ATreeIsSharedAsSecondOperandToo) {
    HeapPool pool(5000);
    const Octree tree = planted(random_grid(4, 21, two_colours), *pool);
    const Octree black = Octree::uniform(*pool, Colour::black);
    const Octree white = Octree::uniform(*pool, Colour::white);
    DenseGrid half(1, Colour::white);
    half[3] = half[5] = Colour::black;
    DenseGrid rest(1, Colour::white);
    for (std::size_t cell = 0; cell < 8; ++cell) rest[cell] = complement_colour(half[cell]);
    Combination job;
    const Octree one = combine(job, Operator::intersect, planted(half, *pool), tree, *pool).tree;
    const Octree two = combine(job, Operator::intersect, tree, planted(rest, *pool), *pool).tree;
    for (const auto& [op, x] : {std::pair{Operator::unite, white}, std::pair{Operator::intersect, black},
                                std::pair{Operator::exclusive_or, white}, std::pair{Operator::unite, one},
                                std::pair{Operator::unite, two}}) {
        for (const bool swapped : {false, true}) {
            const TreeOutcome outcome = combine(job, op, swapped ? x : tree, swapped ? tree : x, *pool);
            EXPECT_EQ(outcome.nodes_needed, 0U);
            EXPECT_EQ(outcome.tree.top, tree.top);
        }
    }
}

TEST(BooleanSharing, SubtractingWhatIsElsewhereChangesNothing) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        Pair pair(seed, 3, two_colours);
        const Octree rest = planted(combined(Operator::subtract, pair.b_grid, pair.a_grid), *pair.pool);
        Combination job;
        const TreeOutcome outcome = combine(job, Operator::subtract, pair.a, rest, *pair.pool);
        EXPECT_EQ(outcome.nodes_needed, 0U) << "seed " << seed;
        EXPECT_EQ(outcome.tree.top, pair.a.top) << "seed " << seed;
    }
}

// A leaf of the one beside a subtree of the other: the subtree is shared, not copied.
TEST(BooleanSharing, ASubtreeBesideANeutralLeafIsShared) {
    HeapPool pool(30000);
    DenseGrid grid = random_grid(4, 3, three_colours);
    for (std::size_t cell = 0; cell < grid.size() / 8; ++cell) grid[cell] = Colour::white; // child 0
    const Octree tree = planted(grid, *pool);
    const Octree cell = single_cell(*pool, 0);
    const std::uint32_t used = pool->used();
    for (const Operator op : {Operator::unite, Operator::exclusive_or}) {
        for (const bool swapped : {false, true}) {
            Combination job;
            const TreeOutcome outcome = combine(job, op, swapped ? cell : tree, swapped ? tree : cell, *pool);
            ASSERT_EQ(outcome.status, Status::ok);
            EXPECT_LE(outcome.nodes_needed, 8U) << "one group, that of the top";
            EXPECT_EQ(pool->used(), used + outcome.nodes_needed);
            EXPECT_EQ(measure(outcome.tree).inner_volume, grid.volume(Colour::black) + 1);
            pool->roll_back(used);
        }
    }
}

TEST(BooleanSharing, ASmallChangeCostsAPath) {
    HeapPool pool(60000);
    const DenseGrid grid = random_grid(5, 4, two_colours);
    const Octree tree = planted(grid, *pool);
    ASSERT_GT(preorder_masks(grid).size(), 1000U);
    for (unsigned child = 0; child < 8; ++child) {
        const Octree cell = single_cell(*pool, child);
        const Point corner = black_cell(cell);
        const std::uint64_t inside = leaf_at(tree, corner).leaf.colour == Colour::black ? 1 : 0;
        Combination job;
        const TreeOutcome added = combine(job, Operator::unite, tree, cell, *pool);
        const TreeOutcome removed = combine(job, Operator::subtract, tree, cell, *pool);
        const TreeOutcome flipped = combine(job, Operator::exclusive_or, tree, cell, *pool);
        constexpr std::uint32_t path =
            8 * 5 + (max_depth - 5); // groups of the tree, below them the cell's nodes
        EXPECT_LE(added.nodes_needed, path);
        EXPECT_LE(removed.nodes_needed, path);
        EXPECT_LE(flipped.nodes_needed, path);
        const std::uint64_t volume = grid.volume(Colour::black);
        EXPECT_EQ(measure(added.tree).inner_volume, volume + 1 - inside);
        EXPECT_EQ(measure(removed.tree).inner_volume, volume - inside);
        EXPECT_EQ(measure(flipped.tree).inner_volume, volume + 1 - 2 * inside);
        EXPECT_TRUE(same_leaves(inside != 0 ? added.tree : removed.tree, tree));
    }
}

TEST(BooleanWork, EveryStepBudgetGivesTheSameTree) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        Pair pair(seed);
        for (const Operator op : worked_operators) {
            const std::uint64_t expected = expected_digest(combined(op, pair.a_grid, pair.b_grid));
            std::set<std::uint64_t> visits;
            Combination job; // used again, it counts anew
            for (const std::uint32_t budget : {1U, 2U, 3U, 7U, 1000U}) {
                ASSERT_EQ(job.begin(op, pair.a, pair.b, *pair.pool), Status::ok);
                std::uint64_t decided = job.decided_volume();
                std::uint64_t visited = job.nodes_visited();
                bool more = true;
                while (more) {
                    more = job.step(budget);
                    ASSERT_GE(job.decided_volume(), decided);
                    ASSERT_LE(job.decided_volume(), root_volume);
                    ASSERT_LE(job.nodes_visited() - visited, budget);
                    ASSERT_EQ(more, job.decided_volume() < root_volume);
                    decided = job.decided_volume();
                    visited = job.nodes_visited();
                }
                EXPECT_EQ(decided, root_volume);
                visits.insert(visited);
                const TreeOutcome outcome = job.finish();
                EXPECT_EQ(outcome.status, Status::ok);
                EXPECT_EQ(digest(outcome.tree), expected) << "seed " << seed << ", budget " << budget;
            }
            EXPECT_EQ(visits.size(), 1U);
        }
    }
}

using Place = std::tuple<int, std::int32_t, std::int32_t, std::int32_t>;

std::set<Place> places(const Octree& tree) {
    std::set<Place> found;
    for (NodeWalk walk(tree); !walk.done(); walk.next()) {
        const Octant& o = walk.octant();
        found.insert({o.level, o.corner.x(), o.corner.y(), o.corner.z()});
    }
    return found;
}

// Octants in which `a` has a node and `b` has a node too, or a leaf of a colour that leaves work to be done.
std::set<Place> places_to_visit(const Octree& a, const Octree& b, const std::set<Colour>& undecided) {
    const std::set<Place> in_b = places(b);
    std::set<Place> found;
    for (const Place& place : places(a)) {
        const Point corner = {{std::get<1>(place), std::get<2>(place), std::get<3>(place)}};
        const bool beside_node = in_b.count(place) != 0;
        if (beside_node || undecided.count(leaf_at(b, corner).leaf.colour) != 0) found.insert(place);
    }
    return found;
}

// A bound on the work. Beside one operand's leaf the other's subtree is gone through only if the result is
// neither the leaf nor the subtree as it is.
TEST(BooleanWork, OnlyOctantsThatNeitherOperandDecidesAreVisited) {
    struct Undecided {
        Operator op;
        std::set<Colour> beside_a; ///< colours of b's leaves beside a's nodes
        std::set<Colour> beside_b;
    };
    const Undecided all[] = {
        {Operator::unite, {Colour::boundary}, {Colour::boundary}},
        {Operator::intersect, {Colour::boundary}, {Colour::boundary}},
        {Operator::subtract, {Colour::boundary}, {Colour::boundary, Colour::black}},
        {Operator::exclusive_or, {Colour::black}, {Colour::black}},
    };
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        Pair pair(seed, 3, seed % 2 == 0 ? two_colours : three_colours);
        for (const Undecided& undecided : all) {
            std::set<Place> visitable = places_to_visit(pair.a, pair.b, undecided.beside_a);
            visitable.merge(places_to_visit(pair.b, pair.a, undecided.beside_b));
            Combination job;
            ASSERT_EQ(combine(job, undecided.op, pair.a, pair.b, *pair.pool).status, Status::ok);
            EXPECT_LE(job.nodes_visited(), visitable.size())
                << "seed " << seed << ", operator " << static_cast<int>(undecided.op);
        }
    }
}

TEST(BooleanWork, CountingSaysWhatTheRealRunTakes) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        Pair pair(seed);
        for (const Operator op : worked_operators) {
            const std::uint32_t used = pair.pool->used();
            const PoolImage before(pair.pool);
            Combination job;
            ASSERT_EQ(job.begin(op, pair.a, pair.b, *pair.pool, true), Status::ok);
            while (job.step(5)) {
            }
            const TreeOutcome counted = job.finish();
            EXPECT_EQ(counted.status, Status::ok);
            EXPECT_TRUE(before.same_nodes(pair.pool));
            const TreeOutcome real = combine(job, op, pair.a, pair.b, *pair.pool);
            EXPECT_EQ(counted.nodes_needed, real.nodes_needed) << "seed " << seed;
            EXPECT_EQ(pair.pool->used() - used, real.nodes_needed) << "seed " << seed;
        }
    }
}

// Each cell of a tree that was the first in its pool, turned over: the group at index 0 is changed, too.
TEST(BooleanWork, CountingIsExactForTheFirstGroupOfAPool) {
    const DenseGrid grid = random_grid(3, 17, two_colours);
    HeapPool pool(3000);
    const Octree tree = planted(grid, *pool);
    const std::uint32_t used = pool->used();
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        DenseGrid single(3);
        single[cell] = Colour::black;
        const Octree other = planted(single, *pool);
        for (const Operator op : {Operator::unite, Operator::subtract, Operator::exclusive_or}) {
            Combination job;
            ASSERT_EQ(job.begin(op, tree, other, *pool, true), Status::ok);
            while (job.step(UINT32_MAX)) {
            }
            const std::uint32_t counted = job.finish().nodes_needed;
            ASSERT_EQ(counted, combine(job, op, tree, other, *pool).nodes_needed) << "cell " << cell;
        }
        pool->roll_back(used);
    }
}

void expect_exhaustion(const Pair& pair, Operator op, std::uint32_t room, std::uint32_t needed,
                       std::uint64_t expected) {
    const std::uint32_t used = pair.a.pool->used();
    HeapPool small(pair.pool, used + room);
    Octree a = pair.a;
    Octree b = pair.b;
    a.pool = &*small;
    b.pool = &*small;
    const auto a_bytes = bytes_of(a);
    const auto b_bytes = bytes_of(b);
    const PoolImage before(small);
    Combination job;
    const TreeOutcome outcome = combine(job, op, a, b, *small);
    ASSERT_EQ(outcome.status, Status::pool_exhausted);
    EXPECT_TRUE(job.exhausted());
    EXPECT_EQ(outcome.nodes_needed, needed);
    EXPECT_EQ(outcome.nodes_missing, needed - room);
    EXPECT_TRUE(before.same_nodes(small));
    EXPECT_GT(small->refused(), before.refused());
    EXPECT_EQ(bytes_of(a), a_bytes);
    EXPECT_EQ(bytes_of(b), b_bytes);
    EXPECT_EQ(digest(a), digest(pair.a));

    HeapPool enough(small, used + room + outcome.nodes_missing);
    a.pool = &*enough;
    b.pool = &*enough;
    const TreeOutcome retry = combine(job, op, a, b, *enough);
    ASSERT_EQ(retry.status, Status::ok);
    EXPECT_FALSE(job.exhausted());
    EXPECT_EQ(retry.nodes_missing, 0U);
    EXPECT_EQ(digest(retry.tree), expected);
    EXPECT_EQ(enough->used(), enough->capacity());
}

TEST(BooleanWork, ExhaustionAtEveryCapacity) {
    for (std::uint32_t seed = 3; seed < 6; ++seed) {
        Pair pair(seed);
        const std::uint32_t used = pair.pool->used();
        for (const Operator op : worked_operators) {
            Combination job;
            const TreeOutcome outcome = combine(job, op, pair.a, pair.b, *pair.pool);
            ASSERT_EQ(outcome.status, Status::ok);
            ASSERT_GT(outcome.nodes_needed, 3U);
            pair.pool->roll_back(used);
            const std::uint64_t expected = expected_digest(combined(op, pair.a_grid, pair.b_grid));
            for (std::uint32_t room = 0; room < outcome.nodes_needed; ++room) {
                expect_exhaustion(pair, op, room, outcome.nodes_needed, expected);
            }
        }
    }
}

TEST(BooleanWork, TreesOfDifferentPoolsAreRefused) {
    Pair pair(1);
    HeapPool other(100);
    const Octree stranger = Octree::uniform(*other, Colour::black);
    Combination job;
    EXPECT_EQ(job.begin(Operator::unite, pair.a, stranger, *pair.pool), Status::pools_differ);
    EXPECT_EQ(job.begin(Operator::unite, stranger, pair.a, *pair.pool), Status::pools_differ);
    EXPECT_EQ(job.begin(Operator::unite, pair.a, pair.b, *other), Status::pools_differ);
    EXPECT_EQ(combine(job, Operator::subtract, pair.a, stranger, *pair.pool).status, Status::pools_differ);
    EXPECT_EQ(complement(job, pair.a, *other).status, Status::pools_differ);
    EXPECT_EQ(other->used(), 0U);
}

TEST(BooleanWork, GivingUpAtEveryStepRollsBack) {
    Pair pair(4);
    for (const Operator op : worked_operators) {
        const PoolImage before(pair.pool);
        for (std::uint32_t steps = 0;; ++steps) {
            Combination job;
            ASSERT_EQ(job.begin(op, pair.a, pair.b, *pair.pool), Status::ok);
            bool more = true;
            for (std::uint32_t i = 0; i < steps && more; ++i) more = job.step(1);
            const TreeOutcome outcome = job.finish();
            if (!more) {
                ASSERT_EQ(outcome.status, Status::ok);
                ASSERT_GT(steps, 3U);
                break;
            }
            ASSERT_EQ(outcome.status, Status::unfinished) << steps;
            ASSERT_EQ(outcome.nodes_missing, 0U);
            ASSERT_TRUE(before.same_nodes(pair.pool)) << steps;
        }
    }
}

TEST(BooleanWork, GivingUpAfterExhaustionLeavesTheMissingNodesUnknown) {
    Pair pair(4);
    HeapPool small(pair.pool, pair.pool->used());
    Octree a = pair.a;
    Octree b = pair.b;
    a.pool = &*small;
    b.pool = &*small;
    Combination job;
    ASSERT_EQ(job.begin(Operator::exclusive_or, a, b, *small), Status::ok);
    while (!job.exhausted()) ASSERT_TRUE(job.step(1));
    ASSERT_TRUE(job.step(1));
    const TreeOutcome outcome = job.finish();
    EXPECT_EQ(outcome.status, Status::pool_exhausted);
    EXPECT_EQ(outcome.nodes_missing, 0U);
    EXPECT_EQ(small->used(), small->capacity());
}

} // namespace

} // namespace osem::tests
