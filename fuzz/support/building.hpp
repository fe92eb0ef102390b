// Building trees in pools of any size: what runs out of room must leave everything as it was, say exactly
// what was missing, and succeed with that much more.
#ifndef OSEM_FUZZ_BUILDING_HPP
#define OSEM_FUZZ_BUILDING_HPP

#include <gtest/gtest.h>

#include <memory>

#include "osem/octree.hpp"
#include "osem/tree_builder.hpp"
#include "support/choices.hpp"
#include "support/heap_pool.hpp"

namespace osem::fuzz {

/// A pool of its own with a tree in it.
struct BuiltTree {
    std::unique_ptr<tests::HeapPool> pool;
    TreeOutcome outcome;
    std::uint32_t before; ///< nodes in use before
};

/// Nodes that are free to begin with: mostly enough, else a few.
inline std::uint32_t any_room(Choices& choices) {
    const std::uint32_t kind = choices.byte();
    return kind < 128 ? 4000 : kind - 128;
}

/// After a build that ran out of room: everything is as it was, and what was missing is known.
inline void expect_rolled_back(const tests::PoolImage& before, tests::HeapPool& pool,
                               const TreeOutcome& outcome) {
    EXPECT_TRUE(before.same_nodes(pool));
    EXPECT_EQ(outcome.nodes_missing, outcome.nodes_needed - (pool->capacity() - pool->used()));
    EXPECT_GT(outcome.nodes_missing, 0U);
    EXPECT_GT(pool->refused(), before.refused());
}

/// Builds in a pool with any room behind up to three nodes in use, and once more where that was too little.
/// `build` takes the pool and gives a TreeOutcome of ok or pool_exhausted.
template <class Build>
BuiltTree built(Choices& choices, const Build& build) {
    const std::uint32_t before = choices.below(4);
    BuiltTree result = {std::make_unique<tests::HeapPool>(before + any_room(choices)), {}, before};
    result.pool->fill_to(before);
    const tests::PoolImage image(*result.pool);
    result.outcome = build(&**result.pool);
    if (result.outcome.status == Status::pool_exhausted) {
        expect_rolled_back(image, *result.pool, result.outcome);
        const std::uint32_t enough = (*result.pool)->capacity() + result.outcome.nodes_missing;
        result.pool = std::make_unique<tests::HeapPool>(*result.pool, enough);
        result.outcome = build(&**result.pool);
        EXPECT_EQ((*result.pool)->used(), enough);
    }
    EXPECT_EQ(result.outcome.status, Status::ok) << describe(result.outcome.status);
    EXPECT_EQ((*result.pool)->used(), before + result.outcome.nodes_needed);
    return result;
}

} // namespace osem::fuzz

#endif
