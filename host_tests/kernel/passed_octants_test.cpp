// The octants of rows through which a plane passes, told both ways, against the plane's value at each corner.
#include "grid/passed_octants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "support/random_in.hpp"

namespace osem::tests {

namespace {

// A plane through three points in a grid or near it, some of them level with each other or on its lines.
struct PlaneInGrid {
    OctantGrid grid;
    Point points[3] = {};
    std::uint32_t corners[3] = {0, 1, 2};

    explicit PlaneInGrid(std::mt19937& random) {
        const int levels = random_in(random, 1, 5);
        const int shift = random_in(random, 0, 12);
        grid = {Point{{1 << 18, 1 << 19, 1 << 17}}, shift, 0, levels};
        do {
            for (int axis = 0; axis < 3; ++axis) {
                for (Point& point : points) {
                    const std::int32_t from_corner = random_in(random, -2, grid.side() + 2) * grid.length();
                    const std::int32_t further =
                        random_in(random, 0, 1) == 0 ? 0 : random_in(random, 0, (1 << shift) - 1);
                    point.at[axis] = grid.corner.at[axis] + from_corner + further;
                }
                for (unsigned k = 1; k < 3; ++k) {
                    if (random_in(random, 0, 2) == 0) points[k].at[axis] = points[0].at[axis];
                }
            }
        } while (plane().is_null());
    }
    Plane plane() const {
        const Solid solid = {points, 3, corners, 3, nullptr, nullptr, 1};
        return Plane(solid, 0);
    }
};

// Whether it passes through an octant without its sides: whether values at corners are on both sides of 0.
bool passes(const Plane& plane, const OctantGrid& grid, int i, int j, int k) {
    std::int64_t least = INT64_MAX;
    std::int64_t greatest = INT64_MIN;
    for (int corner = 0; corner < 8; ++corner) {
        const std::int64_t value =
            plane.at(grid.at(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2))).value();
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    return least < 0 && greatest > 0;
}

TEST(PassedOctants, AreThoseWithCornersOnBothSidesBothWays) {
    std::mt19937 random(1);
    std::uint64_t passed = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const PlaneInGrid given(random);
        const OctantGrid& grid = given.grid;
        const Plane plane = given.plane();
        const int first = random_in(random, 0, grid.side() - 1);
        const IndexRange x = {first, random_in(random, first, grid.side() - 1)};
        const int first_row = random_in(random, 0, grid.side() - 1);
        PassedRows rows(plane, grid, x);
        PassedRowsAnew rows_anew(plane, grid, x);
        for (int k = 0; k < grid.side(); ++k) {
            rows.begin_layer(first_row, k);
            rows_anew.begin_layer(first_row, k);
            for (int j = first_row; j < grid.side(); ++j) {
                std::uint32_t expected = 0;
                for (int i = x.first; i <= x.last; ++i) {
                    if (passes(plane, grid, i, j, k)) expected |= std::uint32_t{1} << i;
                }
                ASSERT_EQ(rows.next(plane, grid, x, j, k), expected) << trial << ": " << j << ", " << k;
                ASSERT_EQ(rows_anew.next(plane, grid, x, j, k), expected) << trial << ": " << j << ", " << k;
                passed += expected != 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(passed, 1000U);
}

} // namespace

} // namespace osem::tests
