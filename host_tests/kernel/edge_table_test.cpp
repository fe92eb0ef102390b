// The table in which check's edges wait for those that run against them, against a map of counts.
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "osem/solid.hpp"
#include "solid/edge_table.hpp"

namespace {

using osem::Edge;
using osem::EdgeTable;

/// How often each edge is there, less how often it is there the other way.
using Surplus = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

void add(Surplus& surplus, const Edge& edge) {
    const bool up = edge.from < edge.to;
    if (edge.from == edge.to) {
        surplus[{edge.from, edge.to}] ^= 1; // it runs against itself
    } else {
        surplus[up ? std::pair(edge.from, edge.to) : std::pair(edge.to, edge.from)] += up ? 1 : -1;
    }
}

Surplus without_pairs(Surplus surplus) {
    for (auto it = surplus.begin(); it != surplus.end();) it = it->second == 0 ? surplus.erase(it) : ++it;
    return surplus;
}

/// What a table has kept, moved to the front of its memory; each edge must be there for itself.
Surplus gathered(EdgeTable& table, const std::vector<Edge>& memory) {
    const std::uint32_t count = table.gather();
    Surplus kept;
    for (std::uint32_t i = 0; i < count; ++i) add(kept, memory[i]);
    std::uint32_t sum = 0;
    for (const auto& entry : kept) sum += static_cast<std::uint32_t>(std::abs(entry.second));
    EXPECT_EQ(sum, count) << "a pair is kept";
    return without_pairs(kept);
}

TEST(EdgeTable, KeepsWhatNothingRunsAgainst) {
    int refused = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        auto next = [random = std::mt19937(seed)]() mutable { return static_cast<std::uint32_t>(random()); };
        std::vector<Edge> memory(2 + next() % 70, Edge{1, 2});
        const std::uint32_t vertices = 2 + next() % 12;
        EdgeTable table(memory.data(), static_cast<std::uint32_t>(memory.size()));
        Surplus surplus;
        for (std::uint32_t left = next() % 200; left != 0; --left) {
            const Edge edge = {next() % vertices, next() % vertices};
            if (table.take(edge)) {
                add(surplus, edge);
            } else {
                ++refused; // and the others are as they were
            }
        }
        ASSERT_EQ(gathered(table, memory), without_pairs(surplus));
    }
    EXPECT_GT(refused, 1000);
}

TEST(EdgeTable, HasPlaceForHalfOfItsMemoryAtLeast) {
    for (const std::uint32_t room : {2U, 3U, 4U, 7U, 8U, 9U, 31U, 32U, 33U}) {
        std::vector<Edge> memory(room + 1, Edge{7, 7});
        EdgeTable table(memory.data(), room);
        std::uint32_t taken = 0;
        while (table.take(Edge{taken, taken + 1})) ++taken; // so few that probes reach every place
        EXPECT_GT(2 * taken, room);
        EXPECT_LE(taken, room);
        EXPECT_EQ(memory[room].from, 7U) << "written behind its memory";
        for (std::uint32_t i = 0; i < taken; ++i) ASSERT_TRUE(table.take(Edge{i + 1, i}));
        EXPECT_EQ(table.gather(), 0U);
        EXPECT_TRUE(table.take(Edge{5, 4})) << "a place that was left is taken again";
    }
}

TEST(EdgeTable, NoMemoryKeepsNothing) {
    EdgeTable table(nullptr, 0);
    EXPECT_EQ(table.gather(), 0U);
}

/// Triangles that share no edge, and behind all of them the same ones turned: as many edges wait as there are
/// places, and probes end before they have found one.
TEST(EdgeTable, CheckGoesAboutItTheOtherWayWhereEdgesFindNoPlace) {
    constexpr std::uint32_t triangles = 170; // 1,020 corners: 512 places for 510 edges
    std::vector<osem::Point> vertices;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < 3 * triangles; ++i) {
        const auto x = static_cast<std::int32_t>(i);
        vertices.push_back({{x, x * x % 101, x * x * x % 211}});
        corners.push_back(i);
    }
    for (std::uint32_t i = 0; i < 3 * triangles; i += 3) {
        for (const std::uint32_t corner : {i, i + 2, i + 1}) corners.push_back(corner);
    }
    const auto size = static_cast<std::uint32_t>(corners.size());
    std::vector<Edge> memory(size);
    EdgeTable table(memory.data(), size);
    std::uint32_t taken = 0; // in the order in which check comes to them
    while (taken < size / 2) {
        const std::uint32_t first = taken - taken % 3;
        if (!table.take(Edge{first + (taken + 2) % 3, taken})) break;
        ++taken;
    }
    ASSERT_LT(taken, size / 2) << "all have found one";

    const auto solid = [&](std::uint32_t faces) {
        return osem::triangle_mesh(vertices.data(), static_cast<std::uint32_t>(vertices.size()),
                                   corners.data(), faces);
    };
    EXPECT_EQ(osem::check(solid(2 * triangles), memory.data(), size).status, osem::Status::ok);
    const osem::CheckOutcome open = osem::check(solid(2 * triangles - 1), memory.data(), size);
    EXPECT_EQ(open.status, osem::Status::surface_not_closed);
    EXPECT_EQ(open.edge.from / 3, triangles - 1); // of the only triangle that is not turned as well
    EXPECT_EQ(open.edge.to / 3, triangles - 1);
}

} // namespace
