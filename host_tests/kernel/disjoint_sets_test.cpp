// Disjoint sets against the partition kept in the plainest way: a name an element, all of them renamed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "tree/disjoint_sets.hpp"

namespace osem::tests {

namespace {

TEST(DisjointSets, HoldThePartition) {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        std::mt19937 random(seed);
        const std::uint32_t count = 1 + static_cast<std::uint32_t>(random() % 60);
        std::vector<std::uint32_t> sets(count);
        std::vector<std::uint32_t> lowest(count);
        for (std::uint32_t i = 0; i < count; ++i) sets[i] = lowest[i] = i;
        for (std::uint32_t round = 0; round < count; ++round) {
            const std::uint32_t a = static_cast<std::uint32_t>(random()) % count;
            const std::uint32_t b = static_cast<std::uint32_t>(random()) % count;
            unite_sets(sets.data(), a, b);
            const std::uint32_t low = std::min(lowest[a], lowest[b]);
            const std::uint32_t high = std::max(lowest[a], lowest[b]);
            for (std::uint32_t& name : lowest) name = name == high ? low : name;
            for (std::uint32_t i = 0; i < count; ++i) {
                ASSERT_EQ(leader_of(sets.data(), i), lowest[i]) << "seed " << seed;
                ASSERT_LE(sets[i], i);
            }
        }
    }
}

} // namespace

} // namespace osem::tests
