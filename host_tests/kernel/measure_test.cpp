// Moments, surface and Euler characteristic against sums over cells, closed formulas and known shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <utility>

#include "osem/measure.hpp"
#include "support/cell_measures.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

void expect_equal(const Moments& found, const Moments& expected) {
    EXPECT_EQ(found.volume, expected.volume);
    for (int a = 0; a < 3; ++a) EXPECT_EQ(found.first[a], expected.first[a]) << "axis " << a;
    for (int p = 0; p < 6; ++p) EXPECT_EQ(found.second[p], expected.second[p]) << "product " << p;
}

void expect_equal(const SurfaceMeasures& found, const SurfaceMeasures& expected) {
    for (int a = 0; a < 3; ++a) EXPECT_EQ(found.area[a], expected.area[a]) << "axis " << a;
    EXPECT_EQ(found.euler_closed, expected.euler_closed);
    EXPECT_EQ(found.euler_open, expected.euler_open);
}

void expect_measures(const Octree& tree, const DenseGrid& grid) {
    const CellSet inner(grid, inner_solid);
    const CellSet outer(grid, outer_solid);
    const SolidMoments m = moments(tree);
    expect_equal(m.inner, cell_moments(inner));
    expect_equal(m.outer, cell_moments(outer));
    SurfaceMeasurement job;
    const SurfaceOutcome surface = measure_surface(job, tree);
    EXPECT_EQ(surface.status, Status::ok);
    expect_equal(surface.inner, cell_surface(inner));
    expect_equal(surface.outer, cell_surface(outer));
    EXPECT_LE(job.clusters_visited(), 27 * (8 * measure(tree).nodes + 1));
}

TEST(Measure, RandomTreesMeasureAsTheirCells) {
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE(seed);
        HeapPool pool(3000);
        const DenseGrid grid = grid_of(seed);
        expect_measures(planted(grid, *pool), grid);
    }
}

TEST(Measure, SharedSubtreesCountWhereverTheyStand) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        HeapPool pool(30000);
        const Octree a = planted(grid_of(seed), *pool);
        const Octree b = planted(grid_of(seed + 1), *pool);
        Combination job;
        const Octree tree = combine(job, Operator::exclusive_or, a, b, *pool).tree;
        expect_measures(tree, expand(tree, 4));
        if (a.top.is_uniform()) continue;
        TreeBuilder builder; // the same node as seven children
        builder.begin(&*pool);
        builder.leaf(0, Colour::black);
        for (unsigned child = 1; child < 8; ++child) builder.graft(child, a.top);
        builder.close();
        const Octree repeated = builder.finish(a.depth + 1).tree;
        expect_measures(repeated, expand(repeated, 5));
    }
}

TEST(Measure, AllOfTheRoot) {
    HeapPool pool(1);
    const Octree black = Octree::uniform(*pool, Colour::black);
    expect_measures(black, DenseGrid(1, Colour::black));
    const Moments m = moments(black).inner;
    EXPECT_EQ(m.volume, root_volume);
    for (const Wide& first : m.first) EXPECT_EQ(first, (Wide{1U << 16, 0}));               // 2 * 2^60 * 2^19
    for (int p = 0; p < 3; ++p) EXPECT_EQ(m.second[p], (Wide{std::uint64_t{1} << 38, 0})); // 12 * 2^100 / 3
    for (int p = 3; p < 6; ++p) EXPECT_EQ(m.second[p], (Wide{std::uint64_t{3} << 36, 0})); // 12 * 2^100 / 4
    SurfaceMeasurement job;
    const SurfaceOutcome surface = measure_surface(job, black);
    for (const std::uint64_t area : surface.inner.area) EXPECT_EQ(area, std::uint64_t{1} << 41);
    EXPECT_EQ(job.clusters_visited(), 27U);
    expect_measures(Octree::uniform(*pool, Colour::white), DenseGrid(1, Colour::white));
    expect_measures(Octree::uniform(*pool, Colour::boundary), DenseGrid(1, Colour::boundary));
}

// One cell of side 1 in the root's last corner, and all but that cell.
TEST(Measure, TheSmallestCellInTheFarthestCorner) {
    HeapPool pool(100);
    const auto builder = std::make_unique<TreeBuilder>();
    for (const Colour cell : {Colour::black, Colour::white}) {
        const bool is_cell = cell == Colour::black;
        const std::uint8_t others = is_cell ? 0x00 : 0x7f;
        builder->begin(&*pool);
        for (int level = 1; level < max_depth; ++level) {
            builder->leaves(others, others);
            builder->open(7);
        }
        builder->leaves(others | (is_cell ? 0x80 : 0), others | (is_cell ? 0x80 : 0));
        for (int level = 0; level < max_depth; ++level) builder->close();
        const Octree tree = builder->finish(max_depth).tree;
        const std::uint64_t d = 2 * std::uint64_t{root_side} - 1; // twice the cell's centre
        const Moments m = moments(tree).inner;
        EXPECT_EQ(m.volume, is_cell ? 1 : root_volume - 1);
        for (const Wide& first : m.first) EXPECT_EQ(first, is_cell ? (Wide{0, d}) : (Wide{0xffff, 0 - d}));
        for (int p = 0; p < 6; ++p) {
            const std::uint64_t part = 3 * d * d + (p < 3 ? 1 : 0);
            const std::uint64_t whole = p < 3 ? std::uint64_t{1} << 38 : std::uint64_t{3} << 36;
            EXPECT_EQ(m.second[p], is_cell ? (Wide{0, part}) : (Wide{whole - 1, 0 - part}));
        }
        SurfaceMeasurement job;
        const SurfaceOutcome surface = measure_surface(job, tree);
        for (const std::uint64_t area : surface.inner.area) {
            EXPECT_EQ(area, is_cell ? 2U : std::uint64_t{1} << 41); // a notch has the area of the corner
        }
        EXPECT_EQ(surface.inner.euler_closed, 1);
        EXPECT_EQ(surface.inner.euler_open, 1);
    }
}

// A box on the lattice, at full depth: products of its sides.
TEST(Measure, ABoxHasTheMomentsOfTheFormula) {
    HeapPool pool(400000);
    const Point low = {{3, 5, 70}};
    const Point high = {{26, 37, 89}};
    ConvertOptions options;
    options.depth = max_depth;
    const TreeOutcome outcome = converted(box_solid(Box{low, high}), options, &*pool);
    ASSERT_EQ(outcome.status, Status::ok);
    const SolidMoments m = moments(outcome.tree);
    std::uint64_t side[3];
    std::uint64_t sum[3]; // 2 * centre
    for (int a = 0; a < 3; ++a) {
        side[a] = static_cast<std::uint64_t>(high.at[a] - low.at[a]);
        sum[a] = static_cast<std::uint64_t>(high.at[a] + low.at[a]);
    }
    const std::uint64_t volume = side[0] * side[1] * side[2];
    Moments expected = {};
    expected.volume = volume;
    for (unsigned a = 0; a < 3; ++a) {
        expected.first[a] = Wide{0, volume * sum[a]};
        expected.second[a] = Wide{0, volume * (3 * sum[a] * sum[a] + side[a] * side[a])};
        expected.second[3 + a] = Wide{0, 3 * volume * sum[a] * sum[(a + 1) % 3]};
    }
    expect_equal(m.inner, expected);
    expect_equal(m.outer, expected);
    SurfaceMeasurement job;
    const SurfaceOutcome surface = measure_surface(job, outcome.tree);
    const SurfaceMeasures box = {{2 * side[1] * side[2], 2 * side[0] * side[2], 2 * side[0] * side[1]}, 1, 1};
    expect_equal(surface.inner, box);
    expect_equal(surface.outer, box);
}

// Black where the field of the cell's centre, in units of the root's half side, is at most 0.
SurfaceMeasures shape(const std::function<bool(double, double, double)>& inside) {
    HeapPool pool(40000);
    const auto colour = [&inside](const Point& corner, std::int32_t side) {
        double at[3];
        for (int a = 0; a < 3; ++a) at[a] = (corner.at[a] + side / 2 - root_side / 2) / (0.5 * root_side);
        return inside(at[0], at[1], at[2]) ? Colour::black : Colour::white;
    };
    const Octree tree = planted(make_grid(5, colour), *pool);
    SurfaceMeasurement job;
    return measure_surface(job, tree).inner;
}

TEST(Measure, EulerCharacteristicOfKnownShapes) {
    const auto ball = [](double x, double y, double z) { return x * x + y * y + z * z <= 0.8; };
    const auto hollow = [](double x, double y, double z) {
        const double r = x * x + y * y + z * z;
        return r <= 0.8 && r >= 0.2;
    };
    const auto torus = [](double x, double y, double z) {
        const double r = std::hypot(x, y) - 0.6;
        return r * r + z * z <= 0.06;
    };
    const auto pierced = [](double x, double y, double z) { // a ball with three crossing tunnels: genus 5
        const auto tunnel = [](double a, double b) { return std::abs(a) < 0.2 && std::abs(b) < 0.2; };
        return x * x + y * y + z * z <= 0.8 && !tunnel(x, y) && !tunnel(y, z) && !tunnel(z, x);
    };
    const std::pair<SurfaceMeasures, std::int64_t> cases[] = {
        {shape(ball), 1}, {shape(hollow), 2}, {shape(torus), 0}, {shape(pierced), -4}};
    for (const auto& [found, expected] : cases) {
        EXPECT_EQ(found.euler_closed, expected);
        EXPECT_EQ(found.euler_open, expected);
    }
}

// Two cells with an edge or a corner in common are one closed piece and two open ones.
TEST(Measure, CellsThatMeetInAnEdgeOrACorner) {
    for (const std::size_t other : {3U, 5U, 6U, 7U}) {
        HeapPool pool(100);
        DenseGrid grid(1);
        grid[0] = grid[other] = Colour::black;
        SurfaceMeasurement job;
        const SurfaceOutcome surface = measure_surface(job, planted(grid, *pool));
        EXPECT_EQ(surface.inner.euler_closed, 1);
        EXPECT_EQ(surface.inner.euler_open, 2);
    }
}

TEST(Measure, EveryStepBudgetGivesTheSameSurface) {
    HeapPool pool(3000);
    const Octree tree = planted(grid_of(7), *pool);
    std::set<std::uint64_t> visits;
    for (const std::uint32_t budget : {1U, 2U, 7U, 100000U}) {
        SurfaceMeasurement job;
        EXPECT_EQ(job.finish().status, Status::unfinished);
        EXPECT_FALSE(job.step(1));
        EXPECT_EQ(job.finish().status, Status::unfinished);
        job.begin(tree);
        EXPECT_TRUE(job.step(0));
        bool more = true;
        while (more) {
            EXPECT_EQ(job.finish().status, Status::unfinished);
            const std::uint64_t before = job.clusters_visited();
            more = job.step(budget);
            ASSERT_LE(job.clusters_visited() - before, budget);
            ASSERT_GT(job.clusters_visited(), before);
        }
        EXPECT_EQ(job.finish().status, Status::ok);
        expect_equal(job.finish().outer, cell_surface(CellSet(grid_of(7), outer_solid)));
        visits.insert(job.clusters_visited());
        job.begin(tree);
        EXPECT_EQ(job.finish().status, Status::unfinished);
    }
    EXPECT_EQ(visits.size(), 1U);
}

TEST(Measure, WideNumbersDifferInEitherHalf) {
    const Wide number = {3, 5};
    EXPECT_TRUE(number == (Wide{3, 5}));
    EXPECT_FALSE(number != (Wide{3, 5}));
    for (const Wide& other : {Wide{4, 5}, Wide{3, 4}, Wide{5, 3}}) {
        EXPECT_FALSE(number == other);
        EXPECT_TRUE(number != other);
    }
}

} // namespace

} // namespace osem::tests
