// Trees of one pool, each beside the dense grid that it has to be.
#ifndef OSEM_FUZZ_FOREST_HPP
#define OSEM_FUZZ_FOREST_HPP

#include <memory>
#include <vector>

#include "osem/tree_builder.hpp"
#include "support/building.hpp"
#include "support/choices.hpp"
#include "support/dense_grid.hpp"

namespace osem::fuzz {

class Forest {
  public:
    struct Entry {
        Octree tree;
        tests::DenseGrid grid;
        std::uint32_t mark; ///< nodes in use when the tree was finished
    };

    explicit Forest(std::uint32_t room) : pool_(std::make_unique<tests::HeapPool>(room)) {}

    tests::HeapPool& pool() { return *pool_; }
    bool empty() const { return entries_.empty(); }
    std::size_t size() const { return entries_.size(); }
    const Entry& operator[](std::size_t i) const { return entries_[i]; }
    std::size_t any(Choices& choices) const {
        return choices.below(static_cast<std::uint32_t>(entries_.size()));
    }

    /// Builds in the pool by `build(NodePool&)`, and again in a greater one where nodes were missing. The
    /// status is ok or `otherwise`; then the pool is as it was.
    template <class Build>
    TreeOutcome build(const Build& build, Status otherwise = Status::ok) {
        const tests::PoolImage before(*pool_);
        TreeOutcome outcome = build(**pool_);
        if (outcome.status == Status::pool_exhausted) {
            expect_rolled_back(before, *pool_, outcome);
            expect_trees_whole();
            grow((*pool_)->capacity() + outcome.nodes_missing);
            outcome = build(**pool_);
            EXPECT_EQ((*pool_)->used(), (*pool_)->capacity());
        }
        if (outcome.status != Status::ok) {
            EXPECT_EQ(outcome.status, otherwise) << describe(outcome.status);
            EXPECT_TRUE(before.same_nodes(*pool_));
        }
        return outcome;
    }

    /// Expects the tree to be that of the grid, and keeps it.
    void add(const Octree& tree, const tests::DenseGrid& grid);
    void drop(std::size_t i) { entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i)); }
    /// Forgets all trees made after entry i, and their nodes.
    void roll_back_to(std::size_t i);
    /// Compacts the pool to the trees that are left.
    void compact(Choices& choices);
    void expect_trees_whole() const;

  private:
    void grow(std::uint32_t capacity);

    std::unique_ptr<tests::HeapPool> pool_;
    std::vector<Entry> entries_;
};

} // namespace osem::fuzz

#endif
