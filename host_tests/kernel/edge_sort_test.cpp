// The sort behind check's search for cracks, against the standard library's.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "solid/edge_sort.hpp"

namespace {

using osem::Edge;

std::pair<std::uint32_t, std::uint32_t> place(const Edge& e) {
    return {std::min(e.from, e.to), std::max(e.from, e.to)};
}

void expect_sorted_like_standard(std::vector<Edge> edges) {
    std::vector<Edge> expected = edges;
    osem::sort_edges(edges.data(), static_cast<std::uint32_t>(edges.size()), osem::EdgeOrder(nullptr));
    for (std::size_t i = 1; i < edges.size(); ++i) ASSERT_LE(place(edges[i - 1]), place(edges[i]));
    const auto by_ends = [](const Edge& a, const Edge& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    };
    std::sort(edges.begin(), edges.end(), by_ends);
    std::sort(expected.begin(), expected.end(), by_ends);
    ASSERT_TRUE(std::equal(edges.begin(), edges.end(), expected.begin(), expected.end(),
                           [](const Edge& a, const Edge& b) { return a.from == b.from && a.to == b.to; }));
}

// A permutation on which the median of first, middle and last is always among the smallest (after Musser,
// 1997): without the way out to heapsort it takes quadratic time.
std::vector<Edge> median_killer(std::uint32_t count) {
    std::vector<Edge> edges(count);
    const std::uint32_t half = count / 2;
    for (std::uint32_t i = 0; i < half; ++i) {
        edges[i].to = i % 2 == 0 ? i + 1 : half + i;
        edges[half + i].to = 2 * (i + 1);
    }
    return edges;
}

TEST(EdgeSort, RandomAndPatterned) {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        auto next = [random = std::mt19937(seed)]() mutable { return static_cast<std::uint32_t>(random()); };
        const std::uint32_t count = next() % 300;
        const std::uint32_t values = 1 + next() % (seed % 2 == 0 ? 5 : 1000);
        std::vector<Edge> edges(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t patterns[] = {i, count - i, 0, i % 2 == 0 ? i : count - i, next() % values};
            edges[i] = Edge{patterns[seed % 5], next() % values};
        }
        expect_sorted_like_standard(edges);
    }
}

// So many that quadratic time would have no end, the small parts at either end.
TEST(EdgeSort, LopsidedPartitions) {
    std::vector<Edge> killer = median_killer(1U << 19);
    expect_sorted_like_standard(killer);
    std::reverse(killer.begin(), killer.end());
    for (Edge& edge : killer) edge.to = (1U << 19) - edge.to;
    expect_sorted_like_standard(killer);
    std::vector<Edge> organ_pipe;
    for (std::uint32_t i = 0; i < 40000; ++i) organ_pipe.push_back(Edge{0, i < 20000 ? i : 40000 - i});
    expect_sorted_like_standard(organ_pipe);
}

TEST(EdgeSort, PlacesAreComparedByCoordinatesWhenGiven) {
    const osem::Point vertices[] = {{{5, 5, 5}}, {{1, 1, 1}}, {{5, 5, 5}}, {{1, 1, 1}}};
    const osem::EdgeOrder order(vertices);
    EXPECT_EQ(order(Edge{0, 1}, Edge{3, 2}), 0);
    EXPECT_EQ(order.direction(Edge{0, 1}), -1);
    EXPECT_EQ(order.direction(Edge{3, 2}), 1);
    EXPECT_EQ(order.direction(Edge{0, 2}), 0);
}

} // namespace
