// Conversion by grids: the trees of divide and conquer, node for node at the same places, whatever the solid.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "geometry/plane.hpp"
#include "osem/classify.hpp"
#include "osem/grid_convert.hpp"
#include "osem/query.hpp"
#include "support/grid_jobs.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

constexpr WindingRule rules[] = {WindingRule::nonzero, WindingRule::odd, WindingRule::positive};
constexpr LeafRule leaf_rules[] = {LeafRule::conservative, LeafRule::centre};

void expect_same(const SmallSolid& solid, const ConvertOptions& options) {
    HeapPool expected(300000);
    const TreeOutcome divided = converted(solid, options, &*expected);
    ASSERT_EQ(divided.status, Status::ok);
    // The largest last grids, and smaller ones in turn.
    for (const int last_levels : {most_grid_levels, 1 + (options.depth + int(options.winding)) % 4}) {
        HeapPool pool(divided.nodes_needed);
        GridScratch scratch(grid_scratch(solid.view(), options.depth, last_levels));
        GridConversion job;
        const TreeOutcome outcome = scratch.run(job, solid, options, &*pool, last_levels);
        ASSERT_EQ(outcome.status, Status::ok);
        ASSERT_EQ(outcome.nodes_needed, divided.nodes_needed);
        ASSERT_EQ(outcome.tree.top, divided.tree.top)
            << "depth " << options.depth << ", last grids of " << last_levels << " levels";
        ASSERT_EQ(outcome.tree.depth, options.depth);
        ASSERT_EQ(pool.used_nodes(), expected.used_nodes());
        ASSERT_LE(job.scratch_used(), scratch.size());
        // With no word to spare, where faces of any rings take another way.
        const std::uint32_t used = job.scratch_used();
        GridScratch needed(std::max(used, solid.face_count()));
        HeapPool again(divided.nodes_needed);
        ASSERT_EQ(needed.run(job, solid, options, &*again, last_levels).tree.top, divided.tree.top);
        ASSERT_EQ(again.used_nodes(), expected.used_nodes());
        ASSERT_EQ(job.scratch_used(), used);
    }
}

void expect_same(const SmallSolid& solid, int first_depth, int last_depth) {
    for (int depth = first_depth; depth <= last_depth; ++depth) {
        for (const WindingRule rule : rules) {
            for (const LeafRule leaves : leaf_rules) {
                if (leaves == LeafRule::centre && depth == max_depth) continue;
                SCOPED_TRACE(testing::Message() << "rule " << int(rule) << ", leaves " << int(leaves));
                expect_same(solid, ConvertOptions{depth, leaves, rule});
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

std::vector<std::vector<Box>> box_cases() {
    return {
        {box(2, 9)},
        {{{{100001, 90003, 120005}}, {{600007, 500009, 400011}}}},
        {box(1, 15), box(3, 12, -1), box(5, 9)},
        {box(0, 16), box(4, 12, -1)},
        {box(1, 9), box(5, 13)},
        {box(1, 15), box(2, 14), box(3, 13), box(4, 12), box(5, 11)}, // winding numbers up to 5
        {box(1, 15, -1), box(2, 14, -1), box(3, 13, -1)},
        {{{{0, 0, 0}}, {{root_side / 2, root_side, root_side}}},
         {{{root_side / 2, 0, 0}}, {{root_side, root_side, root_side}}}}, // a wall between equal windings
    };
}

TEST(GridConversion, BoxesNestedTouchingAndOverlapping) {
    for (const std::vector<Box>& boxes : box_cases()) {
        expect_same(boxes_solid(boxes), 1, 5);
        expect_same(boxes_solid(boxes).triangulated(), 1, 5);
    }
}

// Winding numbers up to 40 and down to -40, in one row, and from one face plane to the next.
TEST(GridConversion, DeepNests) {
    constexpr std::int32_t unit = root_side / 128;
    std::vector<Box> nest;
    for (std::int32_t i = 1; i <= 40; ++i) {
        nest.push_back({{{i * unit, i * unit, i * unit}}, {{64 * unit, 65 * unit, 66 * unit}}});
        nest.push_back(
            {{{127 * unit - i * unit, i * unit, i * unit}}, {{127 * unit, 65 * unit, 66 * unit}}, -1});
    }
    expect_same(boxes_solid(nest), 2, 5);
    expect_same(boxes_solid(nest).triangulated(), 5, 7);
}

TEST(GridConversion, TunnelsAndObliqueFaces) {
    for (int axis = 0; axis < 3; ++axis) {
        const Tunnel tunnel = {{{{70000, 80000, 90000}}, {{900001, 800001, 700001}}},
                               {{{300000, 300000, 300000}}, {{600000, 600000, 600000}}},
                               axis};
        expect_same(tunnel_solid(tunnel), 1, 5);
        const Diamond diamond = {{{500000, 500001, 500003}}, 300007, axis, 100001, 900001};
        expect_same(diamond_solid(diamond), 1, 5);
        expect_same(diamond_solid(diamond).triangulated(), 1, 5);
    }
    const std::int32_t half = root_side / 2;
    for (const Octahedron& octahedron :
         {Octahedron{{{half, half, half}}, half}, Octahedron{{{half, half, half}}, half / 2},
          Octahedron{{{400001, 500003, 600005}}, 399999}}) {
        expect_same(octahedron_solid(octahedron), 1, 6);
        expect_same(octahedron_solid(octahedron).inverted(), 4, 4);
    }
}

// Triangles from far below a leaf to some leaves, in one octant of the last grids, in two, and across others.
TEST(GridConversion, FineMeshes) {
    for (const std::int32_t rounded_to : {1, root_side / 256}) {
        expect_same(dented_ball(4, rounded_to), 7, 7);
        expect_same(dented_ball(12, rounded_to), 3, 7);
        expect_same(dented_ball(40, rounded_to), 5, 6);
    }
}

// Triangles in one octant of the last grids that are crossed by many rays, in several fours of rows.
TEST(GridConversion, TrianglesOfManyRays) {
    constexpr std::int32_t leaf = root_side >> 10;
    for (const std::int32_t off : {0, 1, leaf / 3}) {
        const Octahedron octahedron = {{{16 * leaf + off, 48 * leaf + off, 15 * leaf}}, 12 * leaf + off};
        expect_same(octahedron_solid(octahedron), 9, 11);
    }
}

// Leaves of side 1 and 2, and triangles no larger than they.
TEST(GridConversion, TheDeepestLeaves) {
    for (const std::int32_t low : {0, 12345, root_side - 9}) {
        const Octahedron octahedron = {{{low + 4, low + 5, low + 4}}, 4};
        expect_same(octahedron_solid(octahedron), max_depth - 3, max_depth);
        const Box small = {{{low + 1, low + 2, low + 3}}, {{low + 5, low + 4, low + 9}}};
        expect_same(box_solid(small).triangulated(), max_depth - 3, max_depth);
    }
}

Point random_point(std::mt19937& random, std::int32_t grain) {
    Point p = {};
    std::uniform_int_distribution<std::int32_t> coordinate(0, root_side / grain);
    for (std::int32_t& value : p.at) value = coordinate(random) * grain;
    return p;
}

// Tetrahedra of either orientation. On a coarse lattice many are flat, have corners in common, or faces in
// the planes of octants.
SmallSolid tetrahedra(std::uint32_t seed, std::int32_t grain, int count) {
    std::mt19937 random(seed);
    SmallSolid solid;
    for (; count > 0; --count) {
        const Point a = random_point(random, grain);
        const Point b = random_point(random, grain);
        const Point c = random_point(random, grain);
        const Point d = random_point(random, grain);
        solid.add_face({{a, b, c}});
        solid.add_face({{a, c, d}});
        solid.add_face({{a, d, b}});
        solid.add_face({{b, d, c}});
    }
    return solid;
}

TEST(GridConversion, RandomTetrahedra) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        expect_same(tetrahedra(seed, 1, 3), 3, 4);
        expect_same(tetrahedra(seed, root_side / 16, 5), 3, 5);
        expect_same(tetrahedra(seed, root_side / 4, 9), 2, 4);
        if (HasFatalFailure()) return;
    }
}

// A sheared prism over some corners in a plane: convex, concave, crossing itself, or with corners that
// coincide. Its sides are parallelograms.
SmallSolid prism(std::size_t corners, std::uint32_t seed, std::int32_t grain) {
    std::mt19937 random(seed);
    const Point up = {{root_side / 16, -root_side / 8, root_side / 4}};
    Polygon base;
    while (base.size() < corners) {
        Point p = random_point(random, grain);
        p.at[0] = p.at[0] / 2 + root_side / 4;
        p.at[1] = p.at[1] / 2 + root_side / 4;
        p.at[2] = root_side / 3;
        base.push_back(p);
    }
    const auto lifted = [&up](const Point& p) {
        return Point{{p.x() + up.x(), p.y() + up.y(), p.z() + up.z()}};
    };
    Polygon top;
    for (const Point& p : base) top.push_back(lifted(p));
    SmallSolid solid;
    solid.add_face({Polygon(base.rbegin(), base.rend())});
    solid.add_face({top});
    for (std::size_t i = 0; i < corners; ++i) {
        const std::size_t next = (i + 1) % corners;
        solid.add_face({{base[i], base[next], top[next], top[i]}});
    }
    return solid;
}

TEST(GridConversion, RandomPolygons) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        for (const std::size_t corners : {4U, 5U, 7U}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", corners " << corners);
            expect_same(prism(corners, seed, 1), 3, 5);
            expect_same(prism(corners, seed, root_side / 4), 3, 5);
            if (HasFatalFailure()) return;
        }
    }
}

// A sheet of two sides with any rings in it, which may run along leaves' borders, cross each other and
// themselves.
SmallSolid sheet(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&random](std::uint32_t end) { return static_cast<std::int32_t>(random() % end); };
    constexpr std::int32_t steps = 64;
    Point along[2];
    for (Point& step : along) {
        for (std::int32_t& coordinate : step.at) {
            // Leaves of depth 5 and 6 are multiples of these, or not.
            coordinate = seed % 2 == 0 ? (below(2) * root_side / 512) : below(root_side / 256);
        }
    }
    const auto at = [&](std::int32_t s, std::int32_t t) {
        Point p = {};
        for (unsigned i = 0; i < 3; ++i) {
            p.at[i] = root_side / 8 + s * along[0].at[i] + t * along[1].at[i];
        }
        return p;
    };
    std::vector<std::vector<Point>> rings = {{at(0, 0), at(steps, 0), at(steps, steps), at(0, steps)}};
    for (int hole = 0; hole < 6; ++hole) {
        const std::int32_t s = below(steps);
        const std::int32_t t = below(steps);
        std::vector<Point> ring(3 + random() % 5);
        for (Point& p : ring) p = at(s + below(20) - 10, t + below(20) - 10);
        rings.push_back(ring);
    }
    SmallSolid solid;
    solid.add_face(rings);
    for (std::vector<Point>& ring : rings) std::reverse(ring.begin(), ring.end());
    solid.add_face(rings);
    return solid;
}

TEST(GridConversion, SheetsWithAnyRings) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        for (const int depth : {5, 6, 7}) {
            expect_same(sheet(seed), ConvertOptions{depth});
            if (HasFatalFailure()) return;
        }
    }
}

// Faces without area, which no other face covers: lines through many octants, and points.
TEST(GridConversion, FacesWithoutArea) {
    const Point a = {{100001, 200003, 300007}};
    const Point b = {{500001, 620003, 500007}}; // half way to the end
    const Point end = {{900001, 1040003, 700007}};
    SmallSolid lines;
    lines.add_face({{a, b, end}});
    lines.add_face({{end, b, a}});
    expect_same(lines, 1, 6);
    SmallSolid points;
    points.add_face({{a, a, a}});
    points.add_face({{end, end, end}});
    expect_same(points, 1, 6);
}

// Along edges and a side of octants of depth 4, from corner to corner and back: in none of them, though its
// corners are as far apart as theirs.
TEST(GridConversion, QuadranglesThatRunBackOnThemselvesBesideOctants) {
    constexpr std::int32_t side = root_side / 16;
    const auto at = [](std::int32_t x, std::int32_t y, std::int32_t z) {
        return Point{{5 * side + x, 7 * side + y, 9 * side + z}};
    };
    const Point b = at(side, 0, 0);
    SmallSolid solid;
    solid.add_face({{at(0, 0, 0), b, at(side, side, side), b}});
    expect_same(solid, 2, 6);
}

TEST(GridConversion, WindingNumbersOfManyTetrahedra) { expect_same(tetrahedra(7, root_side / 8, 300), 2, 4); }

Octree subtree(const Octree& tree, unsigned child) {
    const Colour colour = tree.top.colour(child);
    const auto depth = static_cast<std::uint8_t>(tree.depth - 1);
    if (colour != Colour::grey) return Octree{tree.pool, Node::uniform(colour), depth};
    return Octree{tree.pool, tree.pool->child(tree.top, child), depth};
}

// Converts an octant apart, and its children in it; each is what it is of the whole tree.
void expect_apart(const SmallSolid& solid, const ConvertOptions& options, const Octant& octant,
                  const Octree& expected) {
    HeapPool pool(100000);
    const int last_levels = 1 + octant.level;
    GridScratch scratch(grid_scratch(solid.view(), expected.depth, last_levels));
    GridConversion job;
    ASSERT_EQ(job.begin(solid.checked(), options, scratch.words.data(), scratch.size(), &*pool,
                        {last_levels, octant}),
              Status::ok);
    while (job.step(1)) EXPECT_LT(job.decided_volume(), volume_at(octant.level));
    EXPECT_EQ(job.decided_volume(), volume_at(octant.level));
    const TreeOutcome outcome = job.finish();
    ASSERT_EQ(outcome.status, Status::ok);
    ASSERT_EQ(outcome.tree.depth, expected.depth);
    ASSERT_TRUE(same_leaves(outcome.tree, expected));
    if (octant.level == 2) return;
    for (unsigned child = 0; child < 8; ++child) {
        expect_apart(solid, options, octant.child(child), subtree(expected, child));
        if (testing::Test::HasFatalFailure()) return;
    }
}

// Tetrahedra that are smaller than leaves, but for those that lie across several.
SmallSolid crumbs(int count) {
    constexpr std::int32_t size = root_side / 128;
    std::mt19937 random(9);
    SmallSolid solid;
    for (; count > 0; --count) {
        const Point a = random_point(random, size);
        Point b[3] = {a, a, a};
        for (std::size_t axis = 0; axis < 3; ++axis)
            b[axis].at[axis] += a.at[axis] < root_side ? size : -size;
        solid.add_face({{a, b[1], b[0]}});
        solid.add_face({{a, b[2], b[1]}});
        solid.add_face({{a, b[0], b[2]}});
        solid.add_face({{b[0], b[1], b[2]}});
    }
    return solid;
}

TEST(GridConversion, OctantsApart) {
    const SmallSolid soup = tetrahedra(5, root_side / 64, 6);
    const SmallSolid boxes = boxes_solid({box(1, 15), box(3, 12, -1), box(5, 9)});
    const std::int32_t half = root_side / 2; // into every child of the root by one
    const SmallSolid speck = octahedron_solid(Octahedron{{{half, half, half}}, 1});
    for (const SmallSolid& solid : {soup, boxes, crumbs(50), speck}) {
        for (const LeafRule leaves : leaf_rules) {
            const ConvertOptions options = {5, leaves};
            HeapPool pool(100000);
            const TreeOutcome whole = converted(solid, options, &*pool);
            ASSERT_EQ(whole.status, Status::ok);
            expect_apart(solid, options, root_octant, whole.tree);
            if (HasFatalFailure()) return;
        }
    }
}

// Grids of cells of side 64 and 2 that lie somewhere on a tetrahedron as large as the root, so that its edges
// run far past them. Each leaf is what the stages say of it; where no face meets, it lies inside if its
// centre is on the same side of each face as the corner across.
TEST(GridConversion, SmallGridsOnLargeFaces) {
    const Point corners[4] = {{{3, 5, 1}},
                              {{root_side - 7, 70001, 90007}},
                              {{50021, root_side - 2, 130003}},
                              {{210001, 170003, root_side - 1}}};
    SmallSolid solid;
    for (const auto& [a, b, c] :
         {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{0, 3, 2}}) {
        solid.add_face({{corners[a], corners[b], corners[c]}});
    }
    constexpr int across[4] = {3, 2, 0, 1};
    const CheckedSolid checked = solid.checked();
    std::mt19937 random(3);
    for (const int level : {9, 14}) {
        for (int round = 0; round < 12; ++round) {
            // Around a point of a face: a mean of its corners.
            const auto& face = solid.faces()[static_cast<std::size_t>(round % 4)][0];
            const std::int64_t weights[2] = {static_cast<std::int64_t>(random() % 100),
                                             static_cast<std::int64_t>(random() % 100)};
            Octant octant = {{}, static_cast<std::uint8_t>(level)};
            for (unsigned axis = 0; axis < 3; ++axis) {
                const std::int64_t sum = face[0].at[axis] * (200 - weights[0] - weights[1]) +
                                         face[1].at[axis] * weights[0] + face[2].at[axis] * weights[1];
                octant.corner.at[axis] = static_cast<std::int32_t>(sum / 200) & -octant.side();
            }
            const ConvertOptions options = {level + 5};
            HeapPool pool(20000);
            GridScratch scratch(grid_scratch(solid.view(), options.depth));
            GridConversion job;
            ASSERT_EQ(job.begin(checked, options, scratch.words.data(), scratch.size(), &*pool,
                                {most_grid_levels, octant}),
                      Status::ok);
            while (job.step(1000)) {
            }
            const Octree tree = job.finish().tree; // the octant is its root
            std::uint32_t on_surface = 0;
            for (std::uint32_t cell = 0; cell < 32 * 32 * 32; ++cell) {
                const std::uint32_t at[3] = {cell & 31U, cell >> 5 & 31U, cell >> 10};
                Octant leaf = {octant.corner, static_cast<std::uint8_t>(options.depth)};
                Point centre = {};
                Point place = {};
                for (unsigned axis = 0; axis < 3; ++axis) {
                    leaf.corner.at[axis] += static_cast<std::int32_t>(at[axis]) * leaf.side();
                    centre.at[axis] = leaf.corner.at[axis] + leaf.side() / 2;
                    place.at[axis] = static_cast<std::int32_t>(at[axis]) * (root_side / 32);
                }
                bool meets = false;
                bool inside = true;
                for (std::uint32_t f = 0; f < 4; ++f) {
                    meets = meets || classify(checked, f, leaf).meets;
                    const Plane plane(checked.view(), f);
                    inside = inside && plane.at(centre).sign() == plane.at(corners[across[f]]).sign();
                }
                const Colour expected = meets ? Colour::boundary : inside ? Colour::black : Colour::white;
                ASSERT_EQ(leaf_at(tree, place).leaf.colour, expected)
                    << "level " << level << ", cell " << cell;
                on_surface += meets ? 1U : 0U;
            }
            EXPECT_GT(on_surface, 0U);
        }
    }
}

// A triangle with a spike, as a quadrangle that turns one way at three corners and back at the fourth: not
// convex.
TEST(GridConversion, QuadranglesWithASpike) {
    std::mt19937 random(11);
    for (int round = 0; round < 12; ++round) {
        const Point a = random_point(random, root_side / 64);
        const Point b = random_point(random, root_side / 64);
        Point c = {};
        Point tip = {};
        for (unsigned axis = 0; axis < 3; ++axis) { // the tip is as far past a as c is before it
            c.at[axis] = a.at[axis] / 2 + static_cast<std::int32_t>(random() % (root_side / 4));
            tip.at[axis] = 2 * a.at[axis] - c.at[axis];
            if (tip.at[axis] >= 0 && tip.at[axis] <= root_side) continue;
            c.at[axis] = tip.at[axis] = a.at[axis];
        }
        SmallSolid solid;
        solid.add_face({{a, b, c, tip}});
        solid.add_face({{tip, c, b, a}});
        expect_same(solid, 4, 5);
        if (HasFatalFailure()) FAIL() << "round " << round;
    }
}

} // namespace

} // namespace osem::tests
