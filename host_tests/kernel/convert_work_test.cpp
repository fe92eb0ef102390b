// How conversion works: steps, counts, refusals, what happens when memory runs out.
#include <gtest/gtest.h>

#include <random>

#include "osem/convert.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

// Two overlapping boxes and an octahedron, none of them on planes of octants.
SmallSolid crooked_solid() {
    SmallSolid solid = boxes_solid({{{{100001, 90003, 120005}}, {{600007, 500009, 400011}}},
                                    {{{300001, 200003, 250005}}, {{900007, 700009, 800011}}, -1}});
    solid.add(octahedron_solid({{{700001, 300003, 600005}}, 123456}));
    return solid;
}

SmallSolid small_solid() { return box_solid({{{300001, 200003, 250005}}, {{500007, 400009, 800011}}}); }

struct Scratch {
    explicit Scratch(const SmallSolid& solid) : words(solid.face_count()) {}
    std::uint32_t size() const { return static_cast<std::uint32_t>(words.size()); }
    std::vector<std::uint32_t> words;
};

TEST(ConvertWork, EveryStepBudgetGivesTheSameTree) {
    const SmallSolid solid = crooked_solid();
    const CheckedSolid checked = solid.checked();
    for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
        std::vector<std::uint64_t> digests;
        std::vector<std::uint64_t> visits;
        for (const std::uint32_t budget : {UINT32_MAX, 1U, 2U, 3U, 7U, 1000U}) {
            HeapPool pool(20000);
            Scratch scratch(solid);
            Conversion job;
            ASSERT_EQ(job.begin(checked, {4, leaves}, scratch.words.data(), scratch.size(), &*pool),
                      Status::ok);
            std::uint64_t decided = job.decided_volume();
            std::uint64_t visited = job.octants_visited();
            EXPECT_EQ(decided, 0U);
            EXPECT_EQ(visited, 0U);
            bool more = true;
            while (more) {
                more = job.step(budget);
                ASSERT_GE(job.decided_volume(), decided);
                ASSERT_LE(job.octants_visited() - visited, budget);
                ASSERT_EQ(more, job.decided_volume() < root_volume);
                decided = job.decided_volume();
                visited = job.octants_visited();
            }
            EXPECT_EQ(decided, root_volume);
            EXPECT_FALSE(job.step(1));
            EXPECT_EQ(job.octants_visited(), visited);
            const TreeOutcome outcome = job.finish();
            ASSERT_EQ(outcome.status, Status::ok);
            digests.push_back(digest(outcome.tree));
            visits.push_back(visited);
        }
        for (std::size_t i = 1; i < digests.size(); ++i) {
            EXPECT_EQ(digests[i], digests[0]);
            EXPECT_EQ(visits[i], visits[0]);
        }
    }
}

TEST(ConvertWork, StepsOfNothingDoNothing) {
    const SmallSolid solid = small_solid();
    Scratch scratch(solid);
    Conversion job;
    ASSERT_EQ(job.begin(solid.checked(), {3}, scratch.words.data(), scratch.size(), nullptr), Status::ok);
    EXPECT_TRUE(job.step(0));
    EXPECT_EQ(job.octants_visited(), 0U);
    EXPECT_TRUE(job.step(1));
    EXPECT_EQ(job.octants_visited(), 1U);
}

TEST(ConvertWork, CountingSaysWhatTheRealRunTakes) {
    const SmallSolid solid = crooked_solid();
    for (int depth = 1; depth <= 6; ++depth) {
        for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
            HeapPool pool(60000);
            pool.fill_to(13);
            const TreeOutcome counted = converted(solid, {depth, leaves}, nullptr);
            const TreeOutcome real = converted(solid, {depth, leaves}, &*pool);
            EXPECT_EQ(counted.status, Status::ok);
            EXPECT_EQ(counted.nodes_needed, real.nodes_needed);
            EXPECT_EQ(pool->used(), 13 + real.nodes_needed);
            EXPECT_EQ(measure(real.tree).nodes, real.nodes_needed + 1U);
        }
    }
}

TEST(ConvertWork, Refusals) {
    const SmallSolid solid = small_solid();
    const CheckedSolid checked = solid.checked();
    Scratch scratch(solid);
    HeapPool pool(1000);
    Conversion job;
    for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
        const int greatest = leaves == LeafRule::centre ? 19 : 20;
        for (const int depth : {INT32_MIN, -1, 0, greatest + 1, 21, 255, 257, INT32_MAX}) {
            EXPECT_EQ(job.begin(checked, {depth, leaves}, scratch.words.data(), scratch.size(), &*pool),
                      Status::depth_out_of_range);
        }
        for (const int depth : {1, greatest}) {
            EXPECT_EQ(job.begin(checked, {depth, leaves}, scratch.words.data(), scratch.size(), &*pool),
                      Status::ok);
            EXPECT_EQ(job.finish().status, Status::unfinished);
        }
        EXPECT_EQ(job.begin(checked, {3, leaves}, scratch.words.data(), 5, &*pool),
                  Status::scratch_too_small);
        const TreeOutcome outcome = convert(job, checked, {3, leaves}, nullptr, 0, &*pool);
        EXPECT_EQ(outcome.status, Status::scratch_too_small);
    }
    EXPECT_EQ(pool->used(), 0U);
    EXPECT_EQ(convert_scratch(solid.view()), 6U);
}

TEST(ConvertWork, ExhaustionAtEveryCapacity) {
    const SmallSolid solid = small_solid();
    const CheckedSolid checked = solid.checked();
    const ConvertOptions options = {4};
    const std::uint32_t needed = converted(solid, options, nullptr).nodes_needed;
    ASSERT_GT(needed, 40U);
    const std::uint64_t expected = expected_digest(make_grid(4, [](const Point& p, std::int32_t side) {
        return box_colour({{{{300001, 200003, 250005}}, {{500007, 400009, 800011}}}}, WindingRule::nonzero, p,
                          side);
    }));
    Conversion job; // one object for all, so each run follows an exhausted one
    Scratch scratch(solid);
    for (std::uint32_t room = 0; room < needed; ++room) {
        HeapPool pool(9 + room);
        pool.fill_to(9);
        const PoolImage before(pool);
        const TreeOutcome outcome =
            convert(job, checked, options, scratch.words.data(), scratch.size(), &*pool);
        ASSERT_EQ(outcome.status, Status::pool_exhausted);
        EXPECT_TRUE(job.exhausted());
        EXPECT_EQ(outcome.nodes_needed, needed);
        EXPECT_EQ(outcome.nodes_missing, needed - room);
        EXPECT_TRUE(before.same_nodes(pool));
        EXPECT_GT(pool->refused(), before.refused());

        HeapPool enough(pool, 9 + room + outcome.nodes_missing);
        const TreeOutcome retry =
            convert(job, checked, options, scratch.words.data(), scratch.size(), &*enough);
        ASSERT_EQ(retry.status, Status::ok);
        EXPECT_EQ(retry.nodes_missing, 0U);
        EXPECT_EQ(enough->used(), enough->capacity());
        EXPECT_EQ(digest(retry.tree), expected);
    }
}

TEST(ConvertWork, GivingUpRollsBack) {
    const SmallSolid solid = small_solid();
    const CheckedSolid checked = solid.checked();
    Scratch scratch(solid);
    HeapPool pool(1000);
    pool.fill_to(3);
    const PoolImage before(pool);
    Conversion job;
    for (std::uint32_t steps = 0;; ++steps) {
        ASSERT_EQ(job.begin(checked, {3}, scratch.words.data(), scratch.size(), &*pool), Status::ok);
        const bool more = steps == 0 || job.step(steps);
        const TreeOutcome outcome = job.finish();
        if (!more) {
            EXPECT_EQ(outcome.status, Status::ok);
            EXPECT_EQ(job.octants_visited(), steps);
            break;
        }
        ASSERT_EQ(outcome.status, Status::unfinished);
        ASSERT_EQ(outcome.nodes_missing, 0U);
        ASSERT_TRUE(before.same_nodes(pool));
    }
}

TEST(ConvertWork, GivingUpAfterExhaustionLeavesTheMissingNodesUnknown) {
    const SmallSolid solid = small_solid();
    Scratch scratch(solid);
    HeapPool pool(2);
    Conversion job;
    ASSERT_EQ(job.begin(solid.checked(), {4}, scratch.words.data(), scratch.size(), &*pool), Status::ok);
    while (!job.exhausted()) ASSERT_TRUE(job.step(1));
    const TreeOutcome outcome = job.finish();
    EXPECT_EQ(outcome.status, Status::pool_exhausted);
    EXPECT_EQ(outcome.nodes_missing, 0U);
    EXPECT_EQ(pool->used(), 0U);
}

// The same divide and conquer with lists of its own, as a count of what has to be classified.
struct Census {
    StageCounts stages = {};
    std::uint64_t octants = 0;

    void visit(const CheckedSolid& solid, const Octant& octant, const std::vector<std::uint32_t>& faces,
               int depth) {
        ++octants;
        std::vector<std::uint32_t> met;
        for (const std::uint32_t face : faces) {
            const Decision decision = classify(solid, face, octant);
            ++(decision.meets ? stages.accepted : stages.rejected)[static_cast<int>(decision.stage)];
            if (decision.meets) met.push_back(face);
        }
        if (met.empty() || octant.level == depth) return;
        for (unsigned k = 0; k < 8; ++k) visit(solid, octant.child(k), met, depth);
    }
};

TEST(ConvertWork, StageCountsAreThoseOfTheWalk) {
    const SmallSolid solid = crooked_solid();
    const CheckedSolid checked = solid.checked();
    for (int depth = 1; depth <= 5; ++depth) {
        Scratch scratch(solid);
        Conversion job;
        convert(job, checked, {depth}, scratch.words.data(), scratch.size(), nullptr);
        Census census;
        std::vector<std::uint32_t> all(solid.face_count());
        for (std::uint32_t face = 0; face < solid.face_count(); ++face) all[face] = face;
        census.visit(checked, root_octant, all, depth);
        EXPECT_EQ(job.octants_visited(), census.octants);
        for (int stage = 0; stage < stage_count; ++stage) {
            EXPECT_EQ(job.stages().accepted[stage], census.stages.accepted[stage]) << stage;
            EXPECT_EQ(job.stages().rejected[stage], census.stages.rejected[stage]) << stage;
        }
        EXPECT_EQ(job.stages().accepted[0] + job.stages().accepted[1], 0U) << "stages 1 and 2 only reject";
        EXPECT_EQ(job.stages().rejected[2], 0U) << "stage 3 only accepts";
    }
}

TEST(ConvertWork, TheOrderOfFacesAndCornersDoesNotMatter) {
    const SmallSolid solid = crooked_solid();
    for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
        HeapPool pool(60000);
        const TreeOutcome first = converted(solid, {5, leaves}, &*pool);
        ASSERT_EQ(first.status, Status::ok);
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            pool->roll_back(first.nodes_needed);
            const TreeOutcome other = converted(solid.shuffled(seed), {5, leaves}, &*pool);
            ASSERT_EQ(other.status, Status::ok);
            EXPECT_EQ(other.nodes_needed, first.nodes_needed);
            EXPECT_EQ(digest(other.tree), digest(first.tree)) << "seed " << seed;
            EXPECT_TRUE(same_leaves(other.tree, first.tree));
        }
    }
}

// Converted trees without boundary combine as the solids do.
TEST(ConvertWork, CentreLeavesCommuteWithOperators) {
    const Box a = {{{100001, 90003, 120005}}, {{600007, 500009, 400011}}};
    const Box b = {{{300001, 200003, 250005}}, {{900007, 700009, 800011}}};
    HeapPool pool(60000);
    const ConvertOptions options = {5, LeafRule::centre};
    const Octree tree_a = converted(box_solid(a), options, &*pool).tree;
    const Octree tree_b = converted(box_solid(b), options, &*pool).tree;
    for (const Operator op :
         {Operator::unite, Operator::intersect, Operator::subtract, Operator::exclusive_or}) {
        Combination job;
        const TreeOutcome outcome = combine(job, op, tree_a, tree_b, *pool);
        ASSERT_EQ(outcome.status, Status::ok);
        const DenseGrid expected = make_grid(5, [&](const Point& p, std::int32_t side) {
            return combine_colours(op, box_centre_colour({a}, WindingRule::nonzero, p, side),
                                   box_centre_colour({b}, WindingRule::nonzero, p, side));
        });
        EXPECT_EQ(digest(outcome.tree), expected_digest(expected));
    }
}

} // namespace

} // namespace osem::tests
