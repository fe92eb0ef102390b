// What small triangles are seen to have of a grid's points and squares, against the sides of their edges.
#include "grid/edge_functions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

#include "grid/seen_edge.hpp"
#include "osem/lattice.hpp"

namespace osem::tests {

namespace {

using Plane2 = std::array<std::int64_t, 2>;
using Triangle2 = std::array<Plane2, 3>;

// Twice the area of a triangle whose corners turn to the left.
std::int64_t turn_of(const Plane2& a, const Plane2& b, const Plane2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The point moved by (e, e^2): of what the area changes by, the power of e that comes first decides.
bool has_point(const Triangle2& triangle, const Plane2& point, int turn) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const Plane2& a = triangle[edge];
        const Plane2& b = triangle[(edge + 1) % 3];
        for (const std::int64_t power : {turn_of(a, b, point), a[1] - b[1], b[0] - a[0]}) {
            if (power * turn < 0) return false;
            if (power != 0) break;
        }
    }
    return true;
}

// Whether some corner is on the inner side of each edge. With the box around the triangle, which is the
// caller's, these are all axes that may separate a square from it.
bool meets_square(const Triangle2& triangle, const Plane2& corner, std::int64_t side, int turn) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
        bool inside = false;
        for (int k = 0; k < 4; ++k) {
            const Plane2 point = {corner[0] + (k & 1) * side, corner[1] + (k >> 1) * side};
            inside = inside || turn * turn_of(triangle[edge], triangle[(edge + 1) % 3], point) > 0;
        }
        if (!inside) return false;
    }
    return true;
}

// A triangle less than 16 octants long, and a place near it; of their coordinates many are on octants'
// borders.
struct TriangleSeen {
    SmallTriangle from_place = {};
    Triangle2 seen;
    Plane2 place;
    int shift;
    std::int64_t area = 0;
    int turn = 0;

    TriangleSeen(std::mt19937& random, int u, int v) {
        shift = std::uniform_int_distribution<int>(0, 18)(random);
        const std::int32_t side = std::int32_t{1} << shift;
        const auto coordinate = [&](std::int32_t least, std::int32_t most) {
            const std::int32_t line = std::uniform_int_distribution<std::int32_t>(least, most)(random) * side;
            return std::uniform_int_distribution<int>(0, 2)(random) == 0
                       ? line
                       : line + std::uniform_int_distribution<std::int32_t>(0, side - 1)(random);
        };
        while (turn == 0) {
            Point from;
            for (std::int32_t& at : from.at) at = coordinate(-4, small_octants);
            for (std::size_t k = 0; k < 3; ++k) {
                Point corner;
                for (std::int32_t& at : corner.at) at = coordinate(0, small_octants - 1);
                FourSigned origin;
                load(origin, from);
                load(from_place.corners[k], corner);
                from_place.corners[k] -= origin;
                seen[k] = {corner.at[u], corner.at[v]};
            }
            place = {from.at[u], from.at[v]};
            area = turn_of(seen[0], seen[1], seen[2]);
            turn = area > 0 ? 1 : area < 0 ? -1 : 0;
        }
    }
};

template <class Expected>
void compare(EdgeFunctions::Of what, const Expected& expected) {
    std::mt19937 random(3);
    int had = 0;
    int looked_at = 0;
    for (int trial = 0; trial < 6000; ++trial) {
        const int axis = trial % 3;
        const int u = u_of[axis];
        const int v = v_of[axis];
        const TriangleSeen triangle(random, u, v);
        const int places = 1 + trial % 32;
        const bool u_first = trial / 3 % 2 == 0; // rows are along u, or along v
        EdgeFunctions edges(triangle.from_place, u_first ? u : v, u_first ? v : u,
                            u_first ? triangle.area : -triangle.area, triangle.shift, what);
        Four rows = {};
        for (int j = 0; j < 18; ++j) {
            if (j % 4 == 0) edges.see_four(static_cast<std::uint32_t>(places), rows);
            const std::uint32_t row = rows[j % 4];
            ASSERT_EQ(std::uint64_t{row} >> places, 0U);
            looked_at += places;
            for (int i = 0; i < places; ++i) {
                const bool has = (row >> i & 1U) != 0;
                const Plane2 place = {triangle.place[0] + (std::int64_t{u_first ? i : j} << triangle.shift),
                                      triangle.place[1] + (std::int64_t{u_first ? j : i} << triangle.shift)};
                ASSERT_EQ(has, expected(triangle, place)) << trial << ": " << i << ", " << j;
                had += has ? 1 : 0;
            }
        }
    }
    EXPECT_GT(had, looked_at / 100);
    EXPECT_LT(had, looked_at / 2);
}

TEST(EdgeFunctions, TellPointsInside) {
    compare(EdgeFunctions::Of::points, [](const TriangleSeen& triangle, const Plane2& point) {
        return has_point(triangle.seen, point, triangle.turn);
    });
}

TEST(EdgeFunctions, TellSquaresThatNoEdgeSeparates) {
    compare(EdgeFunctions::Of::squares, [](const TriangleSeen& triangle, const Plane2& corner) {
        return meets_square(triangle.seen, corner, std::int64_t{1} << triangle.shift, triangle.turn);
    });
}

} // namespace

} // namespace osem::tests
