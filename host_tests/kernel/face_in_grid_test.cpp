// One face against a grid's octants and reference points, against a classification of each octant and a
// crossing of each step between points. What it is given is as long as it says, in memory of its own.
#include "grid/face_in_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "classify/crossing.hpp"
#include "support/octant_box.hpp"
#include "support/random_in.hpp"

namespace osem::tests {

namespace {

using OwnWords = std::unique_ptr<std::uint32_t[]>;

// Words that nobody has set yet.
OwnWords own_words(std::size_t count) {
    OwnWords words = std::make_unique<std::uint32_t[]>(count);
    std::fill_n(words.get(), count, 0xa5a5a5a5U);
    return words;
}

OctantGrid any_grid(std::mt19937& random) {
    const int levels = random_in(random, 1, 5);
    const int shift = random_in(random, 0, 20 - levels);
    Point corner;
    for (std::int32_t& at : corner.at) {
        at = random_in(random, 0, (root_side >> (shift + levels)) - 1) << (shift + levels);
    }
    return {corner, shift, random_in(random, 0, 1) == 0 ? 0 : (1 << shift) / 2, levels};
}

bool reaches_into(const Solid& solid, const OctantGrid& grid) {
    const Extent extent(solid, solid.corners, solid.corners + solid.corner_count);
    bool reaches = true;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t low = grid.corner.at[axis];
        const std::int32_t high = low + (grid.length() << grid.levels);
        reaches = reaches && extent.low.at[axis] < high && extent.high.at[axis] > low;
    }
    return reaches;
}

// A triangle and a grid that it reaches into: of up to 15 octants along each axis, of up to 40, or as thin
// but as long as the root; many of its corners are on octants' borders, and many triangles at the grid's end
// or beyond it.
struct TriangleInGrid {
    OctantGrid grid;
    Point points[3] = {};
    std::uint32_t corners[3] = {0, 1, 2};

    explicit TriangleInGrid(std::mt19937& random) : grid(any_grid(random)) {
        do {
            for (int axis = 0; axis < 3; ++axis) choose(random, axis);
            if (random_in(random, 0, 3) == 0) turn_along(random_in(random, 0, 2));
            if (random_in(random, 0, 5) == 0) stretch(random);
        } while (!reaches_into(solid(), grid));
    }
    Solid solid() const { return {points, 3, corners, 3, nullptr, nullptr, 1}; }

  private:
    void choose(std::mt19937& random, int axis) {
        const std::int32_t side = grid.length();
        const int most = random_in(random, 0, 5) == 0 ? 40 : random_in(random, 1, 15);
        const int before = random_in(random, -most, grid.side() - 1);
        for (Point& point : points) {
            std::int32_t from_corner = (before + random_in(random, 0, most)) * side;
            if (random_in(random, 0, 1) == 0) from_corner += random_in(random, 0, side - 1);
            const std::int32_t at = grid.corner.at[axis] + from_corner;
            point.at[axis] = at < 0 ? 0 : at < root_side ? at : root_side;
        }
    }
    // An edge along an axis, so that the plane is too; the corners at the height of reference points.
    void turn_along(int along) {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == along) continue;
            points[1].at[axis] = points[0].at[axis];
            const std::int32_t first = grid.corner.at[axis] + grid.offset;
            for (Point& point : points) {
                const std::int32_t at = first + ((point.at[axis] - first) >> grid.shift) * grid.length();
                if (at >= 0) point.at[axis] = at;
            }
        }
    }
    // Two corners are moved as far, so that the normal stays small.
    void stretch(std::mt19937& random) {
        for (int axis = 0; axis < 3; ++axis) {
            std::int32_t by = random_in(random, -root_side, root_side);
            for (unsigned k = 1; k < 3; ++k) {
                const std::int32_t at = points[k].at[axis];
                by = std::clamp(by, -at, root_side - at);
            }
            for (unsigned k = 1; k < 3; ++k) points[k].at[axis] += by;
        }
    }
};

// A face of up to 40 rings, most of them about as long as its grid, on a plane that leans or does not;
// corners are often on octants' borders, or level with reference points, and rings run over each other.
struct RingsInGrid {
    OctantGrid grid;
    std::vector<Point> points;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> ring_starts;
    std::uint32_t face_rings[2] = {};

    explicit RingsInGrid(std::mt19937& random) : grid(any_grid(random)) {
        do {
            up_ = random_in(random, 0, 2);
            lean_[0] = random_in(random, -2, 2);
            lean_[1] = random_in(random, 0, 1) == 0 ? 0 : random_in(random, -2, 2);
            height_ = random_in(random, 0, grid.side()) * grid.length() +
                      (random_in(random, 0, 1) == 0 ? 0 : grid.offset);
        } while (!choose_rings(random) || !reaches_into(solid(), grid));
    }
    Solid solid() const {
        return {points.data(),
                static_cast<std::uint32_t>(points.size()),
                corners.data(),
                static_cast<std::uint32_t>(corners.size()),
                ring_starts.data(),
                face_rings,
                1};
    }

  private:
    // False, and rings are to be chosen anew, if the plane leans out of the root.
    bool choose_rings(std::mt19937& random) {
        points.clear();
        corners.clear();
        ring_starts = {0};
        const int rings = random_in(random, 0, 3) == 0 ? random_in(random, 33, 40) : random_in(random, 1, 6);
        for (int ring = 0; ring < rings; ++ring) {
            const int most = random_in(random, 0, 1) == 0 ? 4 : 2 * grid.side();
            const int before[2] = {random_in(random, -most, grid.side()),
                                   random_in(random, -most, grid.side())};
            const int count = random_in(random, 3, 9);
            for (int corner = 0; corner < count; ++corner) {
                if (!add_corner(random, before, most)) return false;
            }
            ring_starts.push_back(static_cast<std::uint32_t>(corners.size()));
        }
        face_rings[1] = static_cast<std::uint32_t>(rings);
        return true;
    }
    bool add_corner(std::mt19937& random, const int (&before)[2], int most) {
        Point point = {};
        std::int64_t height = height_;
        for (int k = 0; k < 2; ++k) {
            const int axis = (up_ + 1 + k) % 3;
            std::int32_t from_corner = (before[k] + random_in(random, 0, most)) * grid.length();
            from_corner += random_in(random, 0, 2) == 0   ? random_in(random, 0, grid.length() - 1)
                           : random_in(random, 0, 1) == 0 ? 0
                                                          : grid.offset;
            const std::int32_t at = std::clamp(grid.corner.at[axis] + from_corner, 0, root_side);
            point.at[axis] = at;
            height += std::int64_t{at - grid.corner.at[axis]} * lean_[k];
        }
        const std::int64_t up = grid.corner.at[up_] + height;
        if (up < 0 || up > root_side) return false;
        point.at[up_] = static_cast<std::int32_t>(up);
        corners.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(point);
        return true;
    }

    int up_ = 0;
    int lean_[2] = {};
    std::int32_t height_ = 0;
};

TEST(FaceInGrid, MarksTheOctantsThatItMeets) {
    std::mt19937 random(8);
    std::uint64_t marked = 0;
    for (int trial = 0; trial < 1700; ++trial) {
        const TriangleInGrid given(random);
        const OctantGrid& grid = given.grid;
        const OwnWords rows = own_words(static_cast<std::size_t>(grid.rows()));
        std::fill_n(rows.get(), grid.rows(), 0U);
        const OwnWords scratch = own_words(last_grid_space(grid.levels));
        FaceInGrid(given.solid(), 0, grid).mark(rows.get(), scratch.get(), nullptr);
        for (int k = 0; k < grid.side(); ++k) {
            for (int j = 0; j < grid.side(); ++j) {
                std::uint32_t expected = 0;
                for (int i = 0; i < grid.side(); ++i) {
                    const osem::Box octant = octant_box(grid, i, j, k);
                    if (classify_box(given.solid(), 0, octant).meets) expected |= std::uint32_t{1} << i;
                }
                ASSERT_EQ(rows[static_cast<std::size_t>(grid.row(j, k))], expected)
                    << trial << ": " << j << ", " << k;
                marked += expected != 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(marked, 10000U);
}

// What a face adds on the way from the first point to each: along y, then z, then x.
class Ways {
  public:
    Ways(const Solid& solid, const OctantGrid& grid) : solid_(solid), grid_(grid) {}

    std::int32_t to(int i, int j, int k) const {
        std::int32_t number = 0;
        for (int step = 0; step < j; ++step) number += passed(0, step, 0, axis_y);
        for (int step = 0; step < k; ++step) number += passed(0, j, step, axis_z);
        for (int step = 0; step < i; ++step) number += passed(step, j, k, axis_x);
        return number;
    }

    const OctantGrid& grid() const { return grid_; }

  private:
    std::int32_t passed(int i, int j, int k, Axis axis) const {
        return crossing(solid_, 0, grid_.point(i, j, k), axis, grid_.length());
    }

    const Solid& solid_;
    const OctantGrid& grid_;
};

// Numbers of so many points with what is crossed on the way to each; counts those that are not 0.
void compare_some(const RowWindings& windings, const Ways& ways, std::mt19937& random, int points,
                  std::uint64_t& crossed) {
    const OctantGrid& grid = ways.grid();
    for (int look = 0; look < points; ++look) {
        const int i = random_in(random, 0, grid.side() - 1);
        const int j = random_in(random, 0, grid.side() - 1);
        const int k = random_in(random, 0, grid.side() - 1);
        const std::int32_t expected = ways.to(i, j, k);
        ASSERT_EQ(windings.at(static_cast<std::uint32_t>(grid.row(j, k)), static_cast<unsigned>(i)), expected)
            << i << ", " << j << ", " << k;
        crossed += expected != 0 ? 1 : 0;
    }
}

TEST(FaceInGrid, AddsWhatIsCrossedOnTheWayToEachPoint) {
    std::mt19937 random(9);
    std::uint64_t crossed = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const TriangleInGrid given(random);
        const OctantGrid& grid = given.grid;
        const auto rows = static_cast<std::uint32_t>(grid.rows());
        const OwnWords numbers = own_words(std::size_t{3} * rows);
        const OwnWords scratch = own_words(last_grid_space(grid.levels));
        RowWindings windings(numbers.get(), 3 * rows, grid.levels, WindingRule::nonzero);
        const Solid solid = given.solid();
        const bool has_added =
            trial % 2 == 0 && FaceInGrid::has_added_crossings(solid, 0, grid, windings, scratch.get());
        if (!has_added) FaceInGrid(solid, 0, grid).add_crossings(windings, scratch.get());
        ASSERT_FALSE(windings.overflowed());
        windings.finish(0);
        ASSERT_NO_FATAL_FAILURE(compare_some(windings, Ways(solid, grid), random, 400, crossed)) << trial;
    }
    EXPECT_GT(crossed, 2000U);
}

TEST(FaceInGrid, MarksWhatAFaceOfManyRingsMeets) {
    std::mt19937 random(10);
    std::uint64_t met = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        const RingsInGrid given(random);
        const OctantGrid& grid = given.grid;
        const Solid solid = given.solid();
        const auto count = static_cast<std::size_t>(grid.rows());
        const OwnWords rows = own_words(count);
        std::fill_n(rows.get(), count, 0U);
        const OwnWords scratch = own_words(last_grid_space(grid.levels));
        const OwnWords near_rings = own_words(count);
        FaceInGrid(solid, 0, grid)
            .mark(rows.get(), scratch.get(), trial % 4 == 0 ? nullptr : near_rings.get());
        for (int look = 0; look < 300; ++look) {
            const int i = random_in(random, 0, grid.side() - 1);
            const int j = random_in(random, 0, grid.side() - 1);
            const int k = random_in(random, 0, grid.side() - 1);
            const bool expected = classify_box(solid, 0, octant_box(grid, i, j, k)).meets;
            ASSERT_EQ((rows[static_cast<std::size_t>(grid.row(j, k))] >> i & 1U) != 0, expected)
                << trial << ": " << i << ", " << j << ", " << k;
            met += expected ? 1 : 0;
        }
    }
    EXPECT_GT(met, 10000U);
}

TEST(FaceInGrid, AddsWhatIsCrossedOfManyRings) {
    std::mt19937 random(11);
    std::uint64_t crossed = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        const RingsInGrid given(random);
        const OctantGrid& grid = given.grid;
        const Solid solid = given.solid();
        const auto words =
            static_cast<std::uint32_t>(10 * grid.rows()); // for numbers up to those of 40 rings
        const OwnWords numbers = own_words(words);
        const OwnWords scratch = own_words(last_grid_space(grid.levels));
        RowWindings windings(numbers.get(), words, grid.levels, WindingRule::nonzero);
        FaceInGrid(solid, 0, grid).add_crossings(windings, scratch.get());
        ASSERT_FALSE(windings.overflowed());
        windings.finish(0);
        ASSERT_NO_FATAL_FAILURE(compare_some(windings, Ways(solid, grid), random, 60, crossed)) << trial;
    }
    EXPECT_GT(crossed, 2000U);
}

// Of a thin triangle along the diagonal of a layer, in a grid that is 8192 octants beside it, but within its
// ends: of points there the numbers that tell on which side of two of its edges they are have 33 bits.
TEST(FaceInGrid, LongTrianglesBesideIt) {
    constexpr std::int32_t far = root_side / 2;
    const Point points[3] = {{{40, 0, 0}}, {{40, far, far}}, {{40, far + 1, far}}};
    const std::uint32_t corners[3] = {0, 1, 2};
    const Solid solid = {points, 3, corners, 3, nullptr, nullptr, 1};
    for (std::int32_t beside = 8192 - 32; beside <= 8192 + 32; beside += 32) {
        const OctantGrid grid = {Point{{32, 64, 64 + beside}}, 0, 0, 5};
        const OwnWords numbers = own_words(std::size_t{3} * 1024);
        const OwnWords scratch = own_words(last_grid_space(5));
        RowWindings windings(numbers.get(), 3 * 1024, 5, WindingRule::nonzero);
        const bool has_added = FaceInGrid::has_added_crossings(solid, 0, grid, windings, scratch.get());
        if (!has_added) FaceInGrid(solid, 0, grid).add_crossings(windings, scratch.get());
        windings.finish(0);
        for (std::uint32_t row = 0; row < 1024; ++row) ASSERT_EQ(windings.at(row, 31), 0) << row;
    }
}

} // namespace

} // namespace osem::tests
