// Octants through which a small triangle's plane passes, against the plane's values at their corners.
#include "grid/plane_function.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "geometry/plane.hpp"
#include "grid/extent.hpp"
#include "grid/small_triangle.hpp"
#include "support/octant_box.hpp"

namespace osem::tests {

namespace {

bool passes(const Plane& plane, const osem::Box& box) {
    bool above = false;
    bool below = false;
    for (int corner = 0; corner < 8; ++corner) {
        Point point = box.lo;
        for (int axis = 0; axis < 3; ++axis) {
            if ((corner >> axis & 1) != 0) point.at[axis] = box.hi.at[axis];
        }
        const int sign = plane.at(point).sign();
        above = above || sign > 0;
        below = below || sign < 0;
    }
    return above && below;
}

// A triangle less than 16 octants long in the middle of the root, many of its corners on octants' borders;
// and the octants that its bounding box overlaps.
struct TriangleInBox {
    Point points[3];
    std::uint32_t corners[3] = {0, 1, 2};
    OctantGrid grid = {{}, 0, 0, 5}; ///< from the box's lower corner on
    int octants[3];

    explicit TriangleInBox(std::mt19937& random) {
        const int shift = std::uniform_int_distribution<int>(0, 13)(random);
        grid.shift = shift;
        for (int axis = 0; axis < 3; ++axis) {
            const int most = std::uniform_int_distribution<int>(1, small_octants - 1)(random);
            for (Point& point : points) {
                std::int32_t& at = point.at[axis];
                at = std::uniform_int_distribution<std::int32_t>(0, most << shift)(random);
                if (random() % 3 == 0) at = at >> shift << shift;
                at += root_side / 2 + (1 << shift) / 3;
            }
        }
        const Extent reach = extent();
        for (int axis = 0; axis < 3; ++axis) {
            grid.corner.at[axis] = reach.low.at[axis] >> shift << shift;
            octants[axis] = ((reach.high.at[axis] - 1 - grid.corner.at[axis]) >> shift) + 1;
        }
    }
    Solid solid() const { return {points, 3, corners, 3, nullptr, nullptr, 1}; }
    Extent extent() const { return {solid(), corners, corners + 3}; }
    // Its plane as seen from the first octant's lower corner.
    SmallPlane small_plane() const {
        return SmallPlane(small_triangle(solid(), corners, grid, FourSigned{}, 0));
    }
    // Whether the triangle is somewhere in a row along x.
    bool has_row(int j, int k) const {
        for (int i = 0; i < octants[0]; ++i) {
            if (classify_box(solid(), 0, octant_box(grid, i, j, k)).meets) return true;
        }
        return false;
    }
};

TEST(PlaneFunction, TellsWhereThePlanePassesInRowsThatTheTriangleHas) {
    std::mt19937 random(6);
    int fitting = 0;
    int others = 0;
    int passed_by = 0;
    int looked_at = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const TriangleInBox triangle(random);
        const SmallPlane small_plane = triangle.small_plane();
        if (small_plane.is_line_somewhere()) continue;
        const Plane plane(triangle.solid(), 0);
        const auto count = static_cast<std::uint32_t>(triangle.octants[0]);
        const PlaneFunction function(small_plane, triangle.grid.shift, count);
        const std::int32_t length = triangle.extent().length(axis_x);
        ++(function.fits((length >> triangle.grid.shift) + 2) ? fitting : others);
        if (!function.fits((length >> triangle.grid.shift) + 2)) continue;
        for (int k = 0; k < triangle.octants[2]; ++k) {
            for (int j = 0; j < triangle.octants[1]; ++j) {
                if (!triangle.has_row(j, k)) continue;
                Four passed = {};
                const int first = j - j % 4 + trial % 2; // rows may begin anywhere
                if (first > j) continue;
                function.see_four(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(k), passed);
                for (int i = 0; i < triangle.octants[0]; ++i) {
                    const bool is_passed = passes(plane, octant_box(triangle.grid, i, j, k));
                    ASSERT_EQ(passed[j - first] >> i & 1U, is_passed ? 1U : 0U)
                        << i << ", " << j << ", " << k;
                    passed_by += is_passed ? 1 : 0;
                    ++looked_at;
                }
            }
        }
    }
    EXPECT_GT(fitting, 5000);
    EXPECT_GT(others, 500);
    EXPECT_GT(passed_by, looked_at / 10);
    EXPECT_LT(passed_by, looked_at * 9 / 10);
}

// A triangle as large as there are: its plane's numbers have more than 32 bits.
TEST(PlaneFunction, DoesNotFitTheLargestNumbers) {
    const SmallTriangle triangle = {{0, 0, 0, 1}, {15 << 15, 3, 3, 1}, {5, 15 << 15, 15 << 15, 6}};
    EXPECT_FALSE(PlaneFunction(SmallPlane(triangle), 15, 15).fits(17));
}

// The numbers of a small triangle's plane are those of the face's plane, wherever one looks from.
TEST(SmallPlane, IsThePlaneOfTheFace) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const TriangleInBox triangle(random);
        const Plane plane(triangle.solid(), 0);
        const SmallPlane small_plane = triangle.small_plane();
        EXPECT_EQ(small_plane.value, plane.at(triangle.grid.corner).value());
        bool is_line = false;
        bool has_31_bits = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t normal = plane.normal(axis).value();
            ASSERT_EQ(small_plane.normal[axis], normal);
            is_line = is_line || normal == 0;
            has_31_bits = has_31_bits && normal == static_cast<std::int32_t>(normal) && normal != INT32_MIN;
            EXPECT_EQ(small_plane.sign(axis) < 0, normal < 0);
        }
        EXPECT_EQ(small_plane.is_line_somewhere(), is_line);
        EXPECT_EQ(small_plane.has_31_bits(triangle.grid.shift), has_31_bits);
    }
}

} // namespace

} // namespace osem::tests
