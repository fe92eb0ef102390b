// Whatever builds a tree in a pool: in a pool of every size, in steps of several sizes, and given up at every
// step. The results are worked out cell by cell. A fit to the pool's room is in fitting_test.cpp.
#include <gtest/gtest.h>

#include "support/heap_pool.hpp"
#include "support/tree_jobs.hpp"

namespace osem::tests {

namespace {

// A job's operands in a pool that is exactly full beyond its `room`.
struct Stand {
    HeapPool pool;
    std::vector<Octree> trees;
    PoolImage before;

    Stand(const HeapPool& with_operands, std::vector<Octree> operands, std::uint32_t capacity)
        : pool(with_operands, capacity), trees(std::move(operands)), before(pool) {
        for (Octree& tree : trees) tree.pool = &*pool;
    }
};

class TreeJobFaults : public ::testing::TestWithParam<TreeJob> {
  protected:
    TreeJobFaults() {
        // The operands stand behind nodes of other trees.
        origin.fill_to(5);
        for (const DenseGrid& grid : of.operands) trees.push_back(planted(grid, *origin));
        mark = origin->used();
        needed = run(stand(20000)).nodes_needed;
    }

    Stand stand(std::uint32_t room) { return Stand(origin, trees, mark + room); }
    TreeOutcome run(Stand&& in, const Effort& effort = Effort()) { return run(in, effort); }
    TreeOutcome run(Stand& in, const Effort& effort = Effort()) {
        const TreeOutcome outcome = of.run(in.trees, *in.pool, effort);
        for (std::size_t i = 0; i < in.trees.size(); ++i) {
            EXPECT_EQ(digest(in.trees[i]), expected_digest(of.operands[i])) << "operand " << i;
        }
        return outcome;
    }

    void expect_result(Stand& in, const Effort& effort) {
        const TreeOutcome outcome = run(in, effort);
        ASSERT_EQ(outcome.status, Status::ok);
        ASSERT_EQ(outcome.nodes_needed, needed);
        ASSERT_EQ(outcome.nodes_missing, 0U);
        ASSERT_EQ(in.pool->used(), mark + needed);
        ASSERT_EQ(digest(outcome.tree), expected_digest(of.result));
        in.pool->roll_back(mark);
        ASSERT_TRUE(in.before.same_nodes(in.pool)) << "nodes of the operands changed";
    }

    const TreeJob& of = GetParam();
    HeapPool origin{20000};
    std::vector<Octree> trees;
    std::uint32_t mark = 0;
    std::uint32_t needed = 0;
};

TEST_P(TreeJobFaults, StepsOfEverySizeGiveTheResult) {
    Stand in = stand(needed);
    for (const std::uint32_t budget : step_budgets) {
        ASSERT_NO_FATAL_FAILURE(expect_result(in, {budget})) << "budget " << budget;
    }
    EXPECT_LE(needed, preorder_masks(of.result).size() - 1) << "shared nodes take no room";
}

TEST_P(TreeJobFaults, APoolOfEverySizeIsEnoughOrIsAsBefore) {
    for (std::uint32_t room = 0; room < needed; ++room) {
        const Effort effort = {step_budgets[room % step_budget_count]};
        Stand in = stand(room);
        const TreeOutcome outcome = run(in, effort);
        ASSERT_EQ(outcome.status, Status::pool_exhausted) << "room for " << room;
        ASSERT_EQ(outcome.nodes_needed, needed);
        ASSERT_EQ(outcome.nodes_missing, needed - room);
        ASSERT_TRUE(in.before.same_nodes(in.pool)) << "room for " << room;
        Stand again = stand(room + outcome.nodes_missing);
        ASSERT_NO_FATAL_FAILURE(expect_result(again, effort)) << "room for " << room;
    }
}

TEST_P(TreeJobFaults, GivenUpAtEveryStepItLeavesThePoolAsBefore) {
    for (const std::uint32_t room : {needed, needed / 2}) {
        Stand in = stand(room);
        Status status = of.given_up;
        for (std::uint64_t steps = 0; status != Status::ok; ++steps) {
            const TreeOutcome outcome = run(in, {1, steps});
            status = outcome.status;
            if (status == Status::ok) break;
            ASSERT_TRUE(in.before.same_nodes(in.pool)) << "after " << steps << " steps";
            if (status == Status::pool_exhausted) {
                ASSERT_LT(room, needed);
                if (outcome.nodes_missing != 0) break; // driven to the end
            } else {
                ASSERT_EQ(status, of.given_up) << "after " << steps << " steps";
            }
        }
        EXPECT_EQ(status, room == needed ? Status::ok : Status::pool_exhausted);
        in.pool->roll_back(mark);
        Stand again = stand(needed);
        ASSERT_NO_FATAL_FAILURE(expect_result(again, Effort()));
    }
}

INSTANTIATE_TEST_SUITE_P(All, TreeJobFaults, ::testing::ValuesIn(tree_jobs()), [](const auto& job) {
    std::string name = job.param.name;
    for (char& letter : name) {
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
    }
    return name;
});

} // namespace

} // namespace osem::tests
