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
            FourSigned corners[3];
            for (std::size_t k = 0; k < 3; ++k) {
                Point corner;
                for (std::int32_t& at : corner.at) at = coordinate(0, small_octants - 1);
                load(corners[k], corner);
                seen[k] = {corner.at[u], corner.at[v]};
            }
            load(from_place.corner, from);
            from_place.corner = corners[0] - from_place.corner;
            from_place.to_second = corners[1] - corners[0];
            from_place.to_third = corners[2] - corners[0];
            place = {from.at[u], from.at[v]};
            area = turn_of(seen[0], seen[1], seen[2]);
            turn = area > 0 ? 1 : area < 0 ? -1 : 0;
        }
    }
};

// What is seen along axes u and v of so many triangles, in rows along one of them.
class Comparison {
  public:
    template <int u, int v, bool along_u, class Expected>
    void see(SeenPlaces what, const Expected& expected) {
        for (int trial = 0; trial < 1000 && !testing::Test::HasFatalFailure(); ++trial) {
            const TriangleSeen triangle(random_, u, v);
            const int places = 1 + trial % 32;
            EdgeFunctions<along_u ? u : v, along_u ? v : u> edges(
                triangle.from_place, along_u ? triangle.area : -triangle.area, triangle.shift, what);
            for (int j = 0; j < 18; j += 4, edges.next_four()) {
                Four rows = {};
                edges.see(static_cast<std::uint32_t>(places), rows);
                for (int row = 0; row < 4; ++row) {
                    compare(triangle, along_u, places, j + row, rows[row], expected);
                }
            }
        }
    }
    // What is seen is neither nothing nor everything.
    void expect_both() const {
        EXPECT_GT(had_, looked_at_ / 100);
        EXPECT_LT(had_, looked_at_ / 2);
    }

  private:
    template <class Expected>
    void compare(const TriangleSeen& triangle, bool along_u, int places, int j, std::uint32_t row,
                 const Expected& expected) {
        ASSERT_EQ(std::uint64_t{row} >> places, 0U);
        looked_at_ += places;
        for (int i = 0; i < places; ++i) {
            const bool has = (row >> i & 1U) != 0;
            const Plane2 place = {triangle.place[0] + (std::int64_t{along_u ? i : j} << triangle.shift),
                                  triangle.place[1] + (std::int64_t{along_u ? j : i} << triangle.shift)};
            ASSERT_EQ(has, expected(triangle, place)) << i << ", " << j;
            had_ += has ? 1 : 0;
        }
    }

    std::mt19937 random_{3};
    int had_ = 0;
    int looked_at_ = 0;
};

template <class Expected>
void compare(SeenPlaces what, const Expected& expected) {
    Comparison comparison;
    comparison.see<axis_x, axis_y, true>(what, expected);
    comparison.see<axis_x, axis_y, false>(what, expected);
    comparison.see<axis_x, axis_z, true>(what, expected);
    comparison.see<axis_x, axis_z, false>(what, expected);
    comparison.see<axis_y, axis_z, true>(what, expected);
    comparison.see<axis_y, axis_z, false>(what, expected);
    comparison.expect_both();
}

TEST(EdgeFunctions, TellPointsInside) {
    compare(SeenPlaces::points, [](const TriangleSeen& triangle, const Plane2& point) {
        return has_point(triangle.seen, point, triangle.turn);
    });
}

TEST(EdgeFunctions, TellSquaresThatNoEdgeSeparates) {
    compare(SeenPlaces::squares, [](const TriangleSeen& triangle, const Plane2& corner) {
        return meets_square(triangle.seen, corner, std::int64_t{1} << triangle.shift, triangle.turn);
    });
}

// The fourth function is negated where the edges' functions are, and then rounded down.
TEST(EdgeFunctions, GoOnWithAFourthOne) {
    std::mt19937 random(5);
    const auto number = [&random](std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(-most, most)(random);
    };
    for (int trial = 0; trial < 2000; ++trial) {
        const TriangleSeen triangle(random, axis_y, axis_z);
        const LinearFunction fourth = {number(std::int64_t{1} << 40), number(INT32_MAX), number(INT32_MAX)};
        EdgeFunctions<axis_y, axis_z> edges(triangle.from_place, triangle.area, triangle.shift,
                                            SeenPlaces::points, fourth);
        for (int j = 0; j < 12; j += 4, edges.next_four()) {
            for (int i = 0; i < 5; ++i, edges.next()) {
                for (int row = 0; row < 4; ++row) {
                    const std::int64_t steps = fourth.by_u * i + fourth.by_v * (j + row);
                    const std::int64_t value =
                        ((triangle.turn * fourth.value) >> triangle.shift) + triangle.turn * steps;
                    ASSERT_EQ(edges.fourth()[row], static_cast<std::uint32_t>(value)) << trial << ": " << i;
                }
            }
        }
    }
}

} // namespace

} // namespace osem::tests
