// Neighbours across faces, against the list of all leaves.
#include "osem/neighbour.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "osem/query.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/leaf_list.hpp"
#include "support/query_oracles.hpp"

namespace osem::tests {

namespace {

const std::vector<OctantFace> all_faces = {{axis_x, false}, {axis_x, true},  {axis_y, false},
                                           {axis_y, true},  {axis_z, false}, {axis_z, true}};

::testing::AssertionResult agrees(const Octree& tree, const std::vector<Leaf>& leaves, const Octant& octant,
                                  OctantFace face) {
    std::vector<Leaf> expected;
    for (const Leaf& leaf : leaves) {
        if (is_beyond(octant, face, leaf.octant)) expected.push_back(leaf);
    }
    const NeighbourOutcome found = face_neighbour(tree, octant, face);
    const bool divided = expected.size() > 1;
    if (found.status != Status::ok || found.outside != expected.empty() || found.visited > octant.level) {
        return ::testing::AssertionFailure() << describe(found.status) << " " << found.outside;
    }
    Leaf model = {root_octant, Colour::white};
    if (divided) {
        model = {octant, Colour::grey};
        model.octant.corner.at[face.axis] += face.high ? octant.side() : -octant.side();
    } else if (!expected.empty()) {
        model = expected[0];
    }
    if (!same_leaf({found.octant, found.colour}, model)) return ::testing::AssertionFailure() << "neighbour";

    NeighbourWalk walk(tree, octant, face);
    Leaf leaf = {};
    for (const Leaf& next : expected) {
        if (!walk.next(leaf) || !same_leaf(leaf, next)) return ::testing::AssertionFailure() << "walk";
    }
    if (walk.next(leaf) || walk.next(leaf)) return ::testing::AssertionFailure() << "walk goes on";
    if (walk.visited() > found.visited + expected.size()) return ::testing::AssertionFailure() << "visits";
    return ::testing::AssertionSuccess();
}

TEST(FaceNeighbour, OfEveryLeafAndEveryNode) {
    unsigned divided = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        HeapPool pool(5000);
        const Octree tree = planted(grid_of(seed), *pool);
        const std::vector<Leaf> leaves = leaves_of(tree);
        std::vector<Octant> octants;
        for (const Leaf& leaf : leaves) octants.push_back(leaf.octant);
        for (NodeWalk walk(tree); !walk.done(); walk.next()) octants.push_back(walk.octant());
        if (octants.size() > 600) octants.resize(600);
        for (const Octant& octant : octants) {
            for (const OctantFace face : all_faces) {
                ASSERT_TRUE(agrees(tree, leaves, octant, face)) << "seed " << seed;
                divided += face_neighbour(tree, octant, face).colour == Colour::grey ? 1U : 0U;
            }
        }
    }
    EXPECT_GT(divided, 500U);
}

// Octants of every level, leaves of the tree or parts of them.
TEST(FaceNeighbour, OfAnyOctant) {
    std::mt19937 random(31);
    for (int depth = 1; depth <= max_depth; ++depth) {
        HeapPool pool(max_depth);
        Leaf lone = {};
        const Octree tree = lone_leaf(depth, Colour::boundary, random, *pool, lone);
        const std::vector<Leaf> leaves = leaves_of(tree);
        for (int i = 0; i < 300; ++i) {
            Octant octant = lone.octant; // beside the path or below it
            const auto level = static_cast<std::uint8_t>(random() % (max_depth + 1));
            while (octant.level > level) octant = octant.parent();
            while (octant.level < level) octant = octant.child(static_cast<unsigned>(random() % 8));
            for (const OctantFace face : all_faces) ASSERT_TRUE(agrees(tree, leaves, octant, face));
        }
    }
}

TEST(FaceNeighbour, UniformTrees) {
    HeapPool pool(0);
    const Octree tree = Octree::uniform(*pool, Colour::black);
    for (const OctantFace face : all_faces) {
        EXPECT_TRUE(agrees(tree, leaves_of(tree), root_octant, face));
        EXPECT_EQ(face_neighbour(tree, root_octant.child(0), face).outside, !face.high);
    }
    const NeighbourOutcome found = face_neighbour(tree, root_octant.child(0), {axis_y, true});
    EXPECT_TRUE(same_leaf({found.octant, found.colour}, {root_octant, Colour::black}));
}

TEST(FaceNeighbour, RefusesWhatIsNoOctant) {
    HeapPool pool(0);
    const Octree tree = Octree::uniform(*pool, Colour::white);
    std::vector<Octant> bad = {{{{0, 0, 0}}, 21}, {{{0, 0, 0}}, 255}, {{{1, 0, 0}}, 19}};
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (const std::int32_t at : {-1, root_side, INT32_MIN, INT32_MAX}) {
            bad.push_back({{{0, 0, 0}}, 20});
            bad.back().corner.at[axis] = at;
        }
    }
    for (const Octant& octant : bad) {
        const NeighbourOutcome found = face_neighbour(tree, octant, {axis_x, true});
        EXPECT_EQ(found.status, Status::coordinate_out_of_range);
        EXPECT_TRUE(same_leaf({found.octant, found.colour}, {root_octant, Colour::boundary}));
        NeighbourWalk walk(tree, octant, {axis_x, true});
        Leaf leaf = {};
        EXPECT_EQ(walk.status(), Status::coordinate_out_of_range);
        EXPECT_FALSE(walk.next(leaf));
    }
}

} // namespace

} // namespace osem::tests
