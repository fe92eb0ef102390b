// Conversion: every leaf's colour against interval arithmetic, every volume against algebra.
#include "osem/convert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "osem/query.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

constexpr WindingRule rules[] = {WindingRule::nonzero, WindingRule::odd, WindingRule::positive};
constexpr std::int32_t eighth = root_side / 8;

constexpr std::uint32_t pool_size = 60000;

// Compares a whole tree with the grid of a colour a cell.
template <class ColourOfCell>
void expect_tree(const SmallSolid& solid, const ConvertOptions& options, const ColourOfCell& colour_of_cell,
                 const std::string& name) {
    HeapPool pool(pool_size);
    const TreeOutcome outcome = converted(solid, options, &*pool);
    ASSERT_EQ(outcome.status, Status::ok) << name;
    const DenseGrid expected = make_grid(options.depth, colour_of_cell);
    EXPECT_EQ(outcome.tree.depth, options.depth);
    EXPECT_EQ(digest(outcome.tree), expected_digest(expected)) << name << ", depth " << options.depth;
    EXPECT_EQ(measure(outcome.tree).inner_volume, expected.volume(Colour::black)) << name;
    EXPECT_EQ(outcome.nodes_needed, preorder_masks(expected).size() - 1) << name;
}

// On a plane of octants, next to one, or anywhere.
std::int32_t random_coordinate(std::mt19937& random) {
    const std::int32_t on_plane = static_cast<std::int32_t>(random() % 17) * (root_side / 16);
    const std::uint32_t kind = random() % 4;
    if (kind < 2) return on_plane;
    if (kind == 2) return std::clamp(on_plane + static_cast<std::int32_t>(random() % 3) - 1, 0, root_side);
    return static_cast<std::int32_t>(random() % (std::uint32_t{root_side} + 1));
}

Box some_box(std::mt19937& random) {
    Box box = {{{0, 0, 0}}, {{0, 0, 0}}, random() % 2 == 0 ? 1 : -1};
    for (int axis = 0; axis < 3; ++axis) {
        while (box.low.at[axis] == box.high.at[axis]) {
            box.low.at[axis] = random_coordinate(random);
            box.high.at[axis] = random_coordinate(random);
        }
        if (box.low.at[axis] > box.high.at[axis]) std::swap(box.low.at[axis], box.high.at[axis]);
    }
    return box;
}

void expect_boxes(const std::vector<Box>& boxes, std::uint32_t seed) {
    const SmallSolid quads = boxes_solid(boxes);
    const SmallSolid mesh = quads.triangulated();
    const int depth = 1 + static_cast<int>(seed % 5);
    const std::string name = "seed " + std::to_string(seed);
    for (const WindingRule rule : rules) {
        const auto conservative = [&](const Point& p, std::int32_t s) {
            return box_colour(boxes, rule, p, s);
        };
        const auto centre = [&](const Point& p, std::int32_t s) {
            return box_centre_colour(boxes, rule, p, s);
        };
        for (const SmallSolid& solid : {quads, mesh}) {
            expect_tree(solid, {depth, LeafRule::conservative, rule}, conservative, name);
            expect_tree(solid, {depth, LeafRule::centre, rule}, centre, name + " centre");
        }
    }
}

TEST(Convert, RandomBoxes) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        std::mt19937 random(seed);
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < 1 + seed / 5 % 4; ++i) boxes.push_back(some_box(random));
        expect_boxes(boxes, seed);
    }
}

TEST(Convert, RandomOctahedra) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        Octahedron octahedron = {{{root_side / 2, root_side / 2, root_side / 2}}, root_side / 4};
        if (seed % 3 != 0) {
            for (std::int32_t& c : octahedron.centre.at) {
                c = root_side / 4 + random_coordinate(random) / 2;
            }
        }
        std::int32_t room = root_side;
        for (const std::int32_t c : octahedron.centre.at) room = std::min({room, c, root_side - c});
        if (seed % 2 != 0) octahedron.radius = 1 + static_cast<std::int32_t>(random()) % room;
        octahedron.radius = std::abs(octahedron.radius);
        const SmallSolid solid = octahedron_solid(octahedron);
        const int depth = 1 + static_cast<int>(seed % 5);
        const std::string name = "seed " + std::to_string(seed);
        expect_tree(
            solid, {depth},
            [&](const Point& p, std::int32_t s) { return octahedron_colour(octahedron, p, s); }, name);
        expect_tree(
            solid, {depth, LeafRule::centre},
            [&](const Point& p, std::int32_t s) { return octahedron_centre_colour(octahedron, p, s); }, name);
    }
}

// Slanted faces parallel to an axis, through corners of octants: points on them need the later moves.
TEST(Convert, Diamonds) {
    for (std::uint32_t seed = 0; seed < 90; ++seed) {
        std::mt19937 random(seed);
        const auto eighths = [&](std::uint32_t low, std::uint32_t high) {
            const auto n = static_cast<std::int32_t>(low + random() % (high - low + 1));
            return n * eighth + (seed % 2 == 0 ? 0 : static_cast<std::int32_t>(random() % 3) - 1);
        };
        Diamond diamond = {{{eighths(3, 5), eighths(3, 5), eighths(3, 5)}}, eighths(1, 2), 0, 0, 0};
        diamond.axis = static_cast<int>(seed % 3);
        diamond.low = eighths(1, 3);
        diamond.high = eighths(4, 7);
        const SmallSolid quads = diamond_solid(diamond);
        const int depth = 1 + static_cast<int>(seed / 3 % 5);
        const std::string name = "seed " + std::to_string(seed);
        for (const SmallSolid& solid : {quads, quads.triangulated()}) {
            expect_tree(
                solid, {depth}, [&](const Point& p, std::int32_t s) { return diamond_colour(diamond, p, s); },
                name);
            expect_tree(
                solid, {depth, LeafRule::centre},
                [&](const Point& p, std::int32_t s) { return diamond_centre_colour(diamond, p, s); }, name);
        }
    }
}

TEST(Convert, Tunnels) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        std::mt19937 random(seed);
        const std::int32_t unit = seed % 2 == 0 ? eighth : eighth - 77;
        const auto at = [&](std::int32_t n) { return seed % 2 == 0 ? n * unit : n * unit + 91; };
        const auto third = [&] { return static_cast<std::int32_t>(random() % 2); };
        Tunnel tunnel = {};
        tunnel.outer.winding = 1;
        tunnel.axis = static_cast<int>(seed % 3);
        for (int axis = 0; axis < 3; ++axis) {
            tunnel.outer.low.at[axis] = at(third());
            tunnel.inner.low.at[axis] = at(2 + third());
            tunnel.inner.high.at[axis] = at(4 + third());
            tunnel.outer.high.at[axis] = at(6 + 2 * third());
        }
        const SmallSolid solid = tunnel_solid(tunnel);
        for (int depth = 1; depth <= 5; ++depth) {
            const std::string name = "seed " + std::to_string(seed);
            expect_tree(
                solid, {depth}, [&](const Point& p, std::int32_t s) { return tunnel_colour(tunnel, p, s); },
                name);
            expect_tree(
                solid, {depth, LeafRule::centre},
                [&](const Point& p, std::int32_t s) { return tunnel_centre_colour(tunnel, p, s); }, name);
        }
    }
}

// Volumes in closed form: along each axis the cells inside an interval and those that meet it are counted.
struct BoxVolumes {
    std::uint64_t inner = 1; ///< cells of side 1
    std::uint64_t outer = 1;
    std::uint64_t exact = 1;
};

BoxVolumes box_volumes(const Box& box, int depth) {
    const std::int32_t side = root_side >> depth;
    BoxVolumes v;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t low = box.low.at[axis];
        const std::int32_t high = box.high.at[axis];
        const std::int32_t from = (low + side - 1) / side * side;
        const std::int32_t to = high / side * side;
        v.inner *= static_cast<std::uint64_t>(std::max(to - from, 0));
        v.outer *= static_cast<std::uint64_t>((high + side - 1) / side * side - low / side * side);
        v.exact *= static_cast<std::uint64_t>(high - low);
    }
    return v;
}

void expect_volumes(const Box& box, int depth) {
    HeapPool pool(pool_size);
    const TreeOutcome outcome = converted(box_solid(box), {depth}, &*pool);
    ASSERT_EQ(outcome.status, Status::ok) << "depth " << depth;
    const BoxVolumes expected = box_volumes(box, depth);
    const Measures m = measure(outcome.tree);
    EXPECT_EQ(m.inner_volume, expected.inner) << "depth " << depth;
    EXPECT_EQ(m.outer_volume, expected.outer) << "depth " << depth;
    EXPECT_LE(m.inner_volume, expected.exact);
    EXPECT_GE(m.outer_volume, expected.exact);
}

TEST(Convert, BoxVolumesAtEveryDepth) {
    const Box unaligned = {{{123457, 200001, 300007}}, {{345679, 431001, 500009}}};
    const Box across_the_middle = {{{root_side / 2 - 54321, root_side / 2 - 1, root_side / 2 - 99999}},
                                   {{root_side / 2 + 65432, root_side / 2 + 1, root_side / 2 + 3}}};
    for (int depth = 1; depth <= 8; ++depth) {
        expect_volumes(unaligned, depth);
        expect_volumes(across_the_middle, depth);
    }
}

TEST(Convert, AlignedBoxesAreExact) {
    const Box box = {{{eighth, 2 * eighth, 0}}, {{4 * eighth, 5 * eighth, 8 * eighth}}};
    const std::uint64_t exact = std::uint64_t{3} * 3 * 8 << 51;
    for (int depth = 3; depth <= 8; ++depth) {
        HeapPool pool(pool_size);
        const TreeOutcome outcome = converted(box_solid(box), {depth}, &*pool);
        const Measures m = measure(outcome.tree);
        EXPECT_EQ(m.inner_volume, exact);
        EXPECT_EQ(m.outer_volume, exact);
        EXPECT_EQ(outcome.nodes_needed, converted(box_solid(box), {3}, nullptr).nodes_needed);
    }
}

TEST(Convert, TinySolidsAtTheGreatestDepth) {
    const std::int32_t middle = root_side / 2;
    for (const std::int32_t near : {0, 1, middle - 2, middle, 777777, root_side - 5}) {
        const Box box = {{{near, near, near}}, {{near + 5, near + 3, near + 4}}};
        for (int depth = 14; depth <= max_depth; ++depth) expect_volumes(box, depth);
        const Box slanted = {{{near, middle - 1, root_side - 2}}, {{near + 1, middle + 2, root_side}}};
        expect_volumes(slanted, max_depth);
    }
}

// The colours of the cells of a window at a great depth.
template <class ColourOfCell>
void expect_window(const Octree& tree, const Point& low, int cells, const ColourOfCell& colour_of_cell) {
    const std::int32_t side = root_side >> tree.depth;
    for (int z = 0; z < cells; ++z) {
        for (int y = 0; y < cells; ++y) {
            for (int x = 0; x < cells; ++x) {
                const Point p = {{low.x() + x * side, low.y() + y * side, low.z() + z * side}};
                ASSERT_EQ(leaf_at(tree, p).leaf.colour, colour_of_cell(p, side))
                    << p.x() << " " << p.y() << " " << p.z() << ", depth " << int{tree.depth};
            }
        }
    }
}

TEST(Convert, TinyOctahedraCellByCell) {
    for (const std::int32_t near : {8, root_side / 2, 333333, root_side - 8}) {
        for (std::int32_t radius = 1; radius <= 7; ++radius) {
            const Octahedron octahedron = {{{near, near, near}}, radius};
            const SmallSolid solid = octahedron_solid(octahedron);
            HeapPool pool(pool_size);
            const TreeOutcome outcome = converted(solid, {max_depth}, &*pool);
            ASSERT_EQ(outcome.status, Status::ok);
            const Point low = {{near - 8, near - 8, near - 8}};
            expect_window(outcome.tree, low, 16, [&](const Point& p, std::int32_t s) {
                return octahedron_colour(octahedron, p, s);
            });
            const TreeOutcome centre = converted(solid, {max_depth - 1, LeafRule::centre}, &*pool);
            ASSERT_EQ(centre.status, Status::ok);
            const Point even = {{low.x() & ~1, low.y() & ~1, low.z() & ~1}};
            expect_window(centre.tree, even, 8, [&](const Point& p, std::int32_t s) {
                return octahedron_centre_colour(octahedron, p, s);
            });
        }
    }
}

TEST(Convert, CentreLeavesHoldTheLowSidesOfABox) {
    // Centres of the cells of depth 3 are odd sixteenths: a side through them decides by the rule alone.
    const std::int32_t sixteenth = eighth / 2;
    const Box box = {{{3 * sixteenth, 5 * sixteenth, sixteenth}},
                     {{9 * sixteenth, 7 * sixteenth, 15 * sixteenth}}};
    HeapPool pool(pool_size);
    const TreeOutcome outcome = converted(box_solid(box), {3, LeafRule::centre}, &*pool);
    const std::uint64_t cells =
        std::uint64_t{3} * 1 * 7; // from 3 to 9, 5 to 7, 1 to 15, in steps of 2, the last left out
    EXPECT_EQ(measure(outcome.tree).inner_volume, cells << 51);
    EXPECT_EQ(measure(outcome.tree).boundary_leaves, 0U);
}

TEST(Convert, WindingRules) {
    const Box big = {{{0, eighth, eighth}}, {{7 * eighth, 7 * eighth, 8 * eighth}}};
    const Box small = {{{2 * eighth, 2 * eighth, 3 * eighth}}, {{4 * eighth, 5 * eighth, 6 * eighth}}};
    const std::uint64_t whole = std::uint64_t{7} * 6 * 7 << 51;
    const std::uint64_t part = std::uint64_t{2} * 3 * 3 << 51;
    const auto turned = [](Box box) {
        box.winding = -1;
        return box;
    };
    struct Case {
        std::vector<Box> boxes;
        std::uint64_t volumes[3]; ///< nonzero, odd, positive
    };
    const Case cases[] = {
        {{big}, {whole, whole, whole}},
        {{turned(big)}, {whole, whole, 0}},
        {{big, big}, {whole, 0, whole}},
        {{big, big, big}, {whole, whole, whole}},
        {{big, turned(big)}, {0, 0, 0}},
        {{big, small}, {whole, whole - part, whole}},
        {{big, turned(small)}, {whole - part, whole - part, whole - part}},
        {{turned(big), small}, {whole - part, whole - part, 0}},
        {{big, turned(small), turned(small)}, {whole, whole, whole - part}},
        {{turned(big), small, small}, {whole, whole, part}},
    };
    for (std::size_t i = 0; i < std::size(cases); ++i) {
        for (std::size_t rule = 0; rule < 3; ++rule) {
            for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
                HeapPool pool(pool_size);
                const SmallSolid solid = boxes_solid(cases[i].boxes);
                const TreeOutcome outcome = converted(solid, {3, leaves, rules[rule]}, &*pool);
                EXPECT_EQ(measure(outcome.tree).inner_volume, cases[i].volumes[rule]) << i << " " << rule;
                EXPECT_EQ(measure(outcome.tree).boundary_leaves, 0U);
            }
        }
    }
}

TEST(Convert, NothingAndEverything) {
    const Box root = {{{0, 0, 0}}, {{root_side, root_side, root_side}}};
    for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
        for (int depth = 1; depth <= 19; ++depth) {
            const TreeOutcome nothing = converted(SmallSolid(), {depth, leaves}, nullptr);
            ASSERT_EQ(nothing.status, Status::ok);
            EXPECT_EQ(nothing.tree.top, Node::uniform(Colour::white));
            EXPECT_EQ(nothing.nodes_needed, 0U);
            const TreeOutcome everything = converted(box_solid(root), {depth, leaves}, nullptr);
            EXPECT_EQ(everything.tree.top, Node::uniform(Colour::black));
            EXPECT_EQ(everything.nodes_needed, 0U);
        }
    }
    Box inward = root;
    inward.winding = -1;
    const SmallSolid solid = box_solid(inward);
    HeapPool pool(0);
    EXPECT_EQ(converted(solid, {4}, &*pool).tree.top, Node::uniform(Colour::black));
    EXPECT_EQ(converted(solid, {4, LeafRule::conservative, WindingRule::positive}, &*pool).tree.top,
              Node::uniform(Colour::white));
}

} // namespace

} // namespace osem::tests
