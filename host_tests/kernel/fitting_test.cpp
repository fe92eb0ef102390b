// Conversion at the finest depth that fits: every size of pool, against counts of dense grids.
#include <gtest/gtest.h>

#include <algorithm>

#include "osem/fit.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

constexpr int limit = 5;
constexpr std::int32_t lattice_unit = root_side >> limit;

std::vector<Box> scaled(std::vector<Box> boxes) {
    for (Box& box : boxes) {
        for (int axis = 0; axis < 3; ++axis) {
            box.low.at[axis] *= lattice_unit;
            box.high.at[axis] *= lattice_unit;
        }
    }
    return boxes;
}

// A wall between two boxes, in a plane of the octants of depth 5 and of no coarser ones; what encloses them
// lies in planes of depth 1.
std::vector<Box> walled() { return scaled({{{{0, 0, 0}}, {{9, 16, 16}}}, {{{9, 0, 0}}, {{16, 16, 16}}}}); }

std::vector<Box> crooked() { return {{{{100001, 90003, 120005}}, {{790007, 600009, 950011}}}}; }

// A thin plate that centres hit at depth 3 and miss at 4 and 5, beside a block.
std::vector<Box> plates() {
    std::vector<Box> boxes = scaled({{{{10, 0, 0}}, {{10, 15, 13}}}, {{{16, 16, 16}}, {{24, 32, 32}}}});
    boxes[0].low.at[0] -= lattice_unit / 4;
    boxes[0].high.at[0] += lattice_unit / 4;
    return boxes;
}

// Nodes below the top at each depth, found without the kernel.
std::vector<std::uint32_t> counts(const std::vector<Box>& boxes, LeafRule leaves) {
    std::vector<std::uint32_t> nodes(limit + 1);
    for (int depth = 1; depth <= limit; ++depth) {
        const DenseGrid grid = make_grid(depth, [&](const Point& p, std::int32_t side) {
            return leaves == LeafRule::centre ? box_centre_colour(boxes, WindingRule::nonzero, p, side)
                                              : box_colour(boxes, WindingRule::nonzero, p, side);
        });
        nodes[static_cast<std::size_t>(depth)] = static_cast<std::uint32_t>(preorder_masks(grid).size() - 1);
    }
    return nodes;
}

struct FitCase {
    SmallSolid solid;
    std::vector<std::uint32_t> scratch;
    ConvertOptions options;

    FitCase(const std::vector<Box>& boxes, LeafRule leaves)
        : solid(boxes_solid(boxes)), scratch(solid.face_count()), options{limit, leaves} {}
    Status begin(Fitting& job, NodePool& pool) {
        return job.begin(solid.checked(), options, scratch.data(), solid.face_count(), pool);
    }
    FitOutcome run(Fitting& job, NodePool& pool) {
        return fit(job, solid.checked(), options, scratch.data(), solid.face_count(), pool);
    }
};

void expect_every_pool(const std::vector<Box>& boxes, LeafRule leaves) {
    const std::vector<std::uint32_t> nodes = counts(boxes, leaves);
    const std::uint32_t most = *std::max_element(nodes.begin(), nodes.end());
    FitCase of(boxes, leaves);
    Fitting job;
    for (std::uint32_t room = 0; room <= most + 1; ++room) {
        std::size_t finest = limit;
        while (nodes[finest] > room) --finest;
        HeapPool pool(7 + room);
        pool.fill_to(7);
        const FitOutcome outcome = of.run(job, *pool);
        ASSERT_EQ(outcome.built.status, Status::ok);
        ASSERT_EQ(outcome.built.tree.depth, finest) << "room for " << room;
        ASSERT_EQ(outcome.built.nodes_needed, nodes[finest]);
        ASSERT_EQ(pool->used(), 7 + nodes[finest]);
        ASSERT_EQ(pool->peak(), pool->used()) << "only the tree that fits is written";
        ASSERT_EQ(pool->refused(), 0U);
        HeapPool reference(most);
        ConvertOptions options = of.options;
        options.depth = static_cast<int>(finest);
        ASSERT_TRUE(same_leaves(outcome.built.tree, converted(of.solid, options, &*reference).tree));
    }
}

TEST(Fitting, EveryPoolGetsTheFinestDepthThatFits) {
    for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
        for (const auto& boxes : {walled(), plates()}) expect_every_pool(boxes, leaves);
    }
}

TEST(Fitting, ACrookedSolidInPoolsAroundEachCount) {
    for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
        const std::vector<std::uint32_t> nodes = counts(crooked(), leaves);
        FitCase of(crooked(), leaves);
        Fitting job;
        for (std::uint32_t depth = 3; depth <= limit; ++depth) {
            ASSERT_GT(nodes[depth], nodes[depth - 1]);
            HeapPool exact(nodes[depth]);
            EXPECT_EQ(of.run(job, *exact).built.tree.depth, depth);
            HeapPool one_less(nodes[depth] - 1);
            EXPECT_EQ(of.run(job, *one_less).built.tree.depth, depth - 1);
        }
    }
}

// Why no depth may be left out: a finer tree can be the smaller one under either rule.
TEST(Fitting, NodesAreNotMonotoneInDepth) {
    const std::vector<std::uint32_t> wall = counts(walled(), LeafRule::conservative);
    EXPECT_GT(wall[4], wall[5]);
    EXPECT_EQ(wall[5], 0U);
    const std::vector<std::uint32_t> thin = counts(plates(), LeafRule::centre);
    EXPECT_GT(thin[3], thin[5]);
}

TEST(Fitting, EveryStepBudgetGivesTheSame) {
    FitCase of(crooked(), LeafRule::conservative);
    std::vector<std::uint64_t> digests;
    std::vector<std::uint64_t> visits;
    Fitting job; // used again, it counts anew
    for (const std::uint32_t budget : {1U, 2U, 7U, 1000U, UINT32_MAX}) {
        HeapPool pool(300);
        ASSERT_EQ(of.begin(job, *pool), Status::ok);
        EXPECT_TRUE(job.step(0));
        bool writing = false;
        int depth = limit;
        std::uint64_t visited = 0;
        while (job.step(budget)) {
            ASSERT_LE(job.decided_volume(), root_volume);
            ASSERT_TRUE(!writing || job.writing()) << "written last";
            ASSERT_LE(job.depth(), depth);
            visited = job.depth() == depth && job.writing() == writing ? visited : 0; // another pass
            ASSERT_GE(job.octants_visited(), visited);
            writing = job.writing();
            depth = job.depth();
            visited = job.octants_visited();
        }
        EXPECT_TRUE(budget > 1000 || writing);
        Conversion alone; // the last pass is a conversion at the depth found
        ConvertOptions options = of.options;
        options.depth = job.depth();
        convert(alone, of.solid.checked(), options, of.scratch.data(), of.solid.face_count(), nullptr);
        EXPECT_EQ(job.octants_visited(), alone.octants_visited());
        for (int stage = 0; stage < stage_count; ++stage) {
            EXPECT_EQ(job.stages().accepted[stage], alone.stages().accepted[stage]);
            EXPECT_EQ(job.stages().rejected[stage], alone.stages().rejected[stage]);
        }
        EXPECT_FALSE(job.step(budget));
        const FitOutcome outcome = job.finish();
        ASSERT_EQ(outcome.built.status, Status::ok);
        digests.push_back(digest(outcome.built.tree));
        visits.push_back(outcome.octants_visited);
    }
    EXPECT_EQ(digests, std::vector<std::uint64_t>(digests.size(), digests[0]));
    EXPECT_EQ(visits, std::vector<std::uint64_t>(visits.size(), visits[0]));
}

TEST(Fitting, ACountIsGivenUpAsSoonAsItIsTooHigh) {
    FitCase of(crooked(), LeafRule::conservative);
    Fitting job;
    HeapPool none(0);
    const std::uint64_t with_nothing = of.run(job, *none).octants_visited;
    Conversion whole;
    convert(whole, of.solid.checked(), of.options, of.scratch.data(), of.solid.face_count(), nullptr);
    EXPECT_LT(with_nothing, whole.octants_visited());
}

TEST(Fitting, GivingUpRollsBack) {
    FitCase of(crooked(), LeafRule::conservative);
    HeapPool pool(300);
    pool.fill_to(3);
    const PoolImage before(pool);
    Fitting job;
    bool wrote = false;
    for (std::uint32_t steps = 0;; steps += 13) {
        ASSERT_EQ(of.begin(job, *pool), Status::ok);
        const bool more = job.step(steps);
        wrote = wrote || (more && pool->used() > 3);
        const FitOutcome outcome = job.finish();
        EXPECT_EQ(job.finish().built.status, outcome.built.status);
        if (!more) break;
        ASSERT_EQ(outcome.built.status, Status::unfinished);
        ASSERT_TRUE(before.same_nodes(pool));
    }
    EXPECT_TRUE(wrote);
}

TEST(Fitting, Refusals) {
    FitCase of(crooked(), LeafRule::centre);
    HeapPool pool(10);
    Fitting job;
    EXPECT_EQ(job.finish().built.status, Status::unfinished);
    for (const int depth : {0, 20, 21}) {
        of.options.depth = depth;
        EXPECT_EQ(of.begin(job, *pool), Status::depth_out_of_range);
        EXPECT_FALSE(job.step(1));
        EXPECT_EQ(job.finish().built.status, Status::unfinished);
    }
    of.options.depth = 3;
    const FitOutcome outcome = fit(job, of.solid.checked(), of.options, of.scratch.data(), 5, *pool);
    EXPECT_EQ(outcome.built.status, Status::scratch_too_small);
    EXPECT_EQ(pool->used(), 0U);
}

} // namespace

} // namespace osem::tests
