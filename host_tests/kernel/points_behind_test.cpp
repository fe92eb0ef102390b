// Reference points behind a small triangle's plane, both ways, against the plane's value at each of them.
#include "grid/points_behind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "geometry/plane.hpp"
#include "grid/small_triangle.hpp"

namespace osem::tests {

namespace {

// A triangle less than 16 octants long that reaches past some of a grid's points along x and may begin before
// the first or end behind the last one; its corners are often at points' heights.
struct TriangleAtPoints {
    Point points[3];
    std::uint32_t corners[3] = {0, 1, 2};
    OctantGrid grid;

    explicit TriangleAtPoints(std::mt19937& random) {
        const auto in = [&random](int least, int most) {
            return std::uniform_int_distribution<int>(least, most)(random);
        };
        const int shift = in(0, 13);
        const int levels = in(2, 5);
        const std::int32_t middle = root_side / 2;
        grid = {Point{{middle, middle, middle}}, shift, in(0, 1) == 0 ? 0 : (1 << shift) / 2, levels};
        for (int axis = 0; axis < 3; ++axis) {
            const int longest = in(0, 2) == 0 ? small_octants - 1 : in(1, 5);
            const int first = in(-longest, grid.side() - 1);
            for (Point& point : points) {
                const std::int32_t on_octant = std::int32_t{first + in(0, longest)} * grid.length();
                const std::int32_t further = in(0, 2) == 0 ? grid.offset : in(0, grid.length() - 1);
                point.at[axis] = middle + on_octant + further;
            }
        }
    }
    Solid solid() const { return {points, 3, corners, 3, nullptr, nullptr, 1}; }
    Plane plane() const { return {solid(), corners, corners + 3}; }

    // Whether a ray along x, from one of the first points on, meets the closed triangle as it is seen.
    bool has_ray(const Point& from) const {
        int left = 0;
        int right = 0;
        for (int k = 0; k < 3; ++k) {
            const Point& a = points[k];
            const Point& b = points[(k + 1) % 3];
            const std::int64_t side = std::int64_t{b.y() - a.y()} * (from.z() - a.z()) -
                                      std::int64_t{b.z() - a.z()} * (from.y() - a.y());
            left += side >= 0 ? 1 : 0;
            right += side <= 0 ? 1 : 0;
        }
        return left == 3 || right == 3;
    }

    // The points before the ends along x are these, in the grid or beyond.
    int last_before(bool high) const {
        const auto [least, greatest] = std::minmax({points[0].x(), points[1].x(), points[2].x()});
        return ((high ? greatest : least) - 1 - grid.reference().x()) >> grid.shift;
    }
};

// What is seen of four rows from (0, j, k) on.
class RaysSeen {
  public:
    RaysSeen(const TriangleAtPoints& triangle, int j, int k) : triangle_(triangle), j_(j), k_(k) {}

    bool has_ray(int row) const { return triangle_.has_ray(triangle_.grid.point(0, j_ + row, k_)); }
    std::uint32_t behind(int row) const {
        const Plane plane = triangle_.plane();
        const int turn = plane.normal(axis_x).sign();
        std::uint32_t bits = 0;
        for (int i = 0; i < triangle_.grid.side(); ++i) {
            const bool is_behind = turn * plane.at(triangle_.grid.point(i, j_ + row, k_)).sign() >= 0;
            if (is_behind) bits |= std::uint32_t{1} << i;
        }
        return bits;
    }

  private:
    const TriangleAtPoints& triangle_;
    int j_;
    int k_;
};

// Rays that were compared.
template <class PointsBehind>
int compare(PointsBehind behind, const TriangleAtPoints& triangle, const SmallTriangle& from_first,
            const SmallPlane& plane) {
    const OctantGrid& grid = triangle.grid;
    EdgeFunctions<axis_z, axis_y> edges(from_first, -plane.normal[axis_x], grid.shift, SeenPlaces::points,
                                        behind.function());
    const std::uint32_t all = ~std::uint32_t{0} >> (32 - grid.side());
    int rays = 0;
    for (int j = 0; j + 4 <= grid.side(); j += 4, edges.next_four()) {
        behind.begin_four();
        for (int k = 0; k < grid.side(); ++k, edges.next(), behind.next()) {
            Four left_out = {};
            behind.leave_out(left_out, edges.fourth());
            Four points = {};
            behind.see(points, Four{}, edges.fourth());
            Four none = {};
            behind.see(none, ~Four{}, edges.fourth());
            const RaysSeen seen(triangle, j, k);
            for (int row = 0; row < 4; ++row) {
                EXPECT_EQ(none[row], 0U);
                if (!seen.has_ray(row)) continue;
                const std::uint32_t bits = seen.behind(row);
                const bool is_left_out = (left_out[row] >> 31) != 0;
                const bool none_or_all = bits == 0 || bits == all;
                EXPECT_TRUE(is_left_out ? none_or_all : bits != all) << j + row << ", " << k;
                EXPECT_TRUE(is_left_out || (points[row] & all) == bits) << j + row << ", " << k;
                // What the grid does not have may be as its last point is.
                const bool has_last = (bits >> (grid.side() - 1)) != 0;
                EXPECT_TRUE(is_left_out || has_last || points[row] <= all) << j + row << ", " << k;
                ++rays;
            }
        }
    }
    return rays;
}

TEST(PointsBehind, AreThoseWhereThePlanesValueIsNotBelow0) {
    std::mt19937 random(7);
    int by_signs = 0;
    int by_quotients = 0;
    for (int trial = 0; trial < 20000 && !testing::Test::HasFailure(); ++trial) {
        const TriangleAtPoints triangle(random);
        const OctantGrid& grid = triangle.grid;
        const int low = triangle.last_before(false);
        const int high = triangle.last_before(true);
        if (high < 0 || low >= grid.side() - 1) continue; // no ray passes between points
        const IndexRange x = {std::max(low + 1, 0), std::min(high, grid.side() - 1)};
        const int from = std::min(x.first, grid.side() - PointsBehindBySigns::points);
        const SmallTriangle from_first =
            small_triangle(triangle.solid(), triangle.corners, grid, FourSigned{from, 0, 0, 0}, grid.offset);
        const SmallPlane plane(from_first);
        if (plane.normal[axis_x] == 0) continue;
        if (plane.has_31_bits(grid.shift)) {
            by_quotients += compare(PointsBehindByQuotients(plane, grid, from), triangle, from_first, plane);
        }
        if (PointsBehindBySigns::suffice(plane, x.last - x.first + 1, high - low)) {
            by_signs += compare(PointsBehindBySigns(plane, grid, from), triangle, from_first, plane);
        }
    }
    EXPECT_GT(by_signs, 5000);
    EXPECT_GT(by_quotients, 5000);
}

} // namespace

} // namespace osem::tests
