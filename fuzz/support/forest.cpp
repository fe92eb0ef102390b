#include "support/forest.hpp"

#include <set>

namespace osem::fuzz {

void Forest::add(const Octree& tree, const tests::DenseGrid& grid) {
    ASSERT_EQ(digest(tree), tests::expected_digest(grid));
    entries_.push_back({tree, grid, (*pool_)->used()});
}

void Forest::roll_back_to(std::size_t i) {
    (*pool_)->roll_back(entries_[i].mark);
    entries_.resize(i + 1, entries_[i]);
    expect_trees_whole();
}

void Forest::compact(Choices& choices) {
    std::set<std::uint32_t> reached;
    std::vector<Octree> trees;
    for (const Entry& entry : entries_) {
        const std::set<std::uint32_t> of_tree = tests::reachable(entry.tree);
        reached.insert(of_tree.begin(), of_tree.end());
        trees.push_back(entry.tree);
    }
    std::vector<std::uint32_t> scratch(compact_scratch((*pool_)->used()));
    const auto size = static_cast<std::uint32_t>(scratch.size());
    const auto count = static_cast<std::uint32_t>(trees.size());
    if (size > 0 && choices.flag()) {
        const tests::PoolImage before(*pool_);
        EXPECT_EQ(osem::compact(**pool_, trees.data(), count, scratch.data(), size - 1),
                  Status::scratch_too_small);
        EXPECT_TRUE(before.same_nodes(*pool_));
    }
    EXPECT_EQ(osem::compact(**pool_, trees.data(), count, scratch.data(), size), Status::ok);
    EXPECT_EQ((*pool_)->used(), reached.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        entries_[i].tree = trees[i];
        entries_[i].mark = (*pool_)->used();
    }
    expect_trees_whole();
}

void Forest::expect_trees_whole() const {
    for (const Entry& entry : entries_) ASSERT_EQ(digest(entry.tree), tests::expected_digest(entry.grid));
}

void Forest::grow(std::uint32_t capacity) {
    pool_ = std::make_unique<tests::HeapPool>(*pool_, capacity);
    for (Entry& entry : entries_) entry.tree.pool = &**pool_;
}

} // namespace osem::fuzz
