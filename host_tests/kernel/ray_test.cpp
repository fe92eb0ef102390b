// Segments, against the intervals in which they are in each leaf, one axis at a time.
#include "osem/ray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/leaf_list.hpp"
#include "support/query_oracles.hpp"

namespace osem::tests {

namespace {

bool same(const Passage& passage, const Stay& stay) {
    return same_leaf(passage.leaf, stay.leaf) && passage.entry == stay.entry.unmoved &&
           passage.exit == stay.exit.unmoved && passage.begins == (stay.entry.axis < 0) &&
           passage.ends == (stay.exit.axis < 0) &&
           (passage.begins || passage.entered_axis == stay.entry.axis) &&
           (passage.ends || passage.left_axis == stay.exit.axis);
}

::testing::AssertionResult passages_agree(const Octree& tree, const Point& p, const Point& q) {
    const std::vector<Stay> stays = expected_stays(leaves_of(tree), p, q);
    SegmentWalk walk(tree, {in_units(p), in_units(q)});
    if (walk.status() != Status::ok) return ::testing::AssertionFailure() << describe(walk.status());
    Passage passage = {};
    std::size_t met = 0;
    for (; walk.next(passage); ++met) {
        if (met >= stays.size() || !same(passage, stays[met])) {
            return ::testing::AssertionFailure() << "passage " << met << " of " << stays.size();
        }
    }
    if (met != stays.size()) return ::testing::AssertionFailure() << met << " of " << stays.size();
    if (walk.next(passage)) return ::testing::AssertionFailure() << "one more after the last";
    const std::size_t most = std::max<std::size_t>(stays.size(), 1) * tree.depth;
    if (walk.visited() > most) return ::testing::AssertionFailure() << "visited " << walk.visited();
    return ::testing::AssertionSuccess();
}

::testing::AssertionResult crossings_agree(const Octree& tree, const Point& p, const Point& q) {
    const std::vector<Crossing> expected = expected_crossings(expected_stays(leaves_of(tree), p, q));
    SegmentWalk walk(tree, {in_units(p), in_units(q)});
    Crossing found = {};
    for (const Crossing& crossing : expected) {
        if (!walk.next_crossing(found)) return ::testing::AssertionFailure() << "too few crossings";
        if (found.at != crossing.at || found.axis != crossing.axis || found.before != crossing.before ||
            found.after != crossing.after || !same_leaf(found.entered, crossing.entered)) {
            return ::testing::AssertionFailure() << "another crossing";
        }
    }
    for (int again = 0; again < 2; ++again) {
        if (walk.next_crossing(found)) return ::testing::AssertionFailure() << "too many crossings";
    }
    return ::testing::AssertionSuccess();
}

::testing::AssertionResult hits_agree(const Octree& tree, const Point& p, const Point& q) {
    const std::vector<Stay> stays = expected_stays(leaves_of(tree), p, q);
    for (std::uint8_t colours = 0; colours < 16; ++colours) {
        const auto first = std::find_if(stays.begin(), stays.end(), [colours](const Stay& stay) {
            return (colours & colour_bit(stay.leaf.colour)) != 0;
        });
        const HitOutcome found = first_hit(tree, {in_units(p), in_units(q)}, colours);
        if (found.status != Status::ok || found.hit != (first != stays.end()) ||
            (found.hit && !same(found.passage, *first))) {
            return ::testing::AssertionFailure() << "colours " << int{colours};
        }
    }
    return ::testing::AssertionSuccess();
}

Point random_point(std::mt19937& random) {
    Point p = {};
    for (std::int32_t& c : p.at) c = static_cast<std::int32_t>(random() % 33) - 8;
    return p;
}

// Half of the segments are made to run along faces, edges or diagonals.
Point random_end(std::mt19937& random, const Point& from) {
    Point to = random_point(random);
    if (random() % 2 == 0) return to;
    const auto length = static_cast<std::int32_t>(random() % 33) - 16;
    for (unsigned axis = 0; axis < 3; ++axis) {
        to.at[axis] = from.at[axis] + length * (static_cast<std::int32_t>(random() % 3) - 1);
    }
    return to;
}

TEST(SegmentWalk, MeetsTheLeavesWhoseIntervalsAreNotEmpty) {
    std::mt19937 random(21);
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        HeapPool pool(5000);
        const Octree tree = planted(grid_of(seed), *pool);
        for (int i = 0; i < 150; ++i) {
            const Point p = random_point(random);
            const Point q = random_end(random, p);
            ASSERT_TRUE(passages_agree(tree, p, q)) << "seed " << seed << ", segment " << i;
            ASSERT_TRUE(crossings_agree(tree, p, q)) << "seed " << seed << ", segment " << i;
            ASSERT_TRUE(hits_agree(tree, p, q)) << "seed " << seed << ", segment " << i;
        }
    }
}

// All pairs of the corners of the cells of a grid of depth 2, and of one cell around it.
TEST(SegmentWalk, AllPairsOfCorners) {
    HeapPool pool(100);
    const Octree tree = planted(random_grid(2, 3, three_colours), *pool);
    const auto corner = [](int i) { return Point{{4 * (i % 7 - 1), 4 * (i / 7 % 7 - 1), 4 * (i / 49 - 1)}}; };
    for (int i = 0; i < 343; ++i) {
        for (int j = 0; j < 343; ++j) {
            ASSERT_TRUE(passages_agree(tree, corner(i), corner(j))) << i << " " << j;
        }
    }
}

TEST(SegmentWalk, ReversedMeetsTheSameLeavesInReverse) {
    std::mt19937 random(22);
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        HeapPool pool(5000);
        const Octree tree = planted(grid_of(seed), *pool);
        for (int i = 0; i < 50; ++i) {
            const Point p = in_units(random_point(random));
            const Point q = in_units(random_end(random, random_point(random)));
            std::vector<Passage> there;
            std::vector<Passage> back;
            Passage passage = {};
            for (SegmentWalk walk(tree, {p, q}); walk.next(passage);) there.push_back(passage);
            for (SegmentWalk walk(tree, {q, p}); walk.next(passage);) back.push_back(passage);
            ASSERT_EQ(there.size(), back.size());
            std::reverse(back.begin(), back.end());
            for (std::size_t k = 0; k < there.size(); ++k) {
                ASSERT_TRUE(same_leaf(there[k].leaf, back[k].leaf));
                ASSERT_EQ(there[k].begins, back[k].ends);
            }
        }
    }
}

// Whether the point at a parameter is in the closed octant. Products are at most 2^60, so are their sums.
bool holds_at(const Octant& octant, const Segment& segment, const Parameter& at) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int64_t whole = at.denominator;
        const std::int64_t length = std::int64_t{segment.to.at[axis]} - segment.from.at[axis];
        const std::int64_t from_low = std::int64_t{segment.from.at[axis]} - octant.corner.at[axis];
        const std::int64_t position = from_low * whole + at.numerator * length;
        if (position < 0 || position > octant.side() * whole) return false;
    }
    return true;
}

// Coordinates of all sizes, in segments that pass through the one small leaf: each passage lies in its leaf,
// begins where the one before ended, and the small leaf is among them.
TEST(SegmentWalk, ExactInTheWholeRange) {
    std::mt19937 random(23);
    for (int round = 0; round < 200; ++round) {
        HeapPool pool(max_depth);
        Leaf target = {};
        const Octree tree = lone_leaf(max_depth, Colour::black, random, *pool, target);
        for (int i = 0; i < 50; ++i) {
            Segment segment = {};
            const auto bits = static_cast<unsigned>(random() % 28);
            for (unsigned axis = 0; axis < 3; ++axis) {
                const std::int32_t through =
                    target.octant.corner.at[axis] + static_cast<std::int32_t>(random() % 2);
                const auto reach =
                    static_cast<std::int32_t>(random() % (std::uint32_t{2} << bits)) - (1 << bits);
                segment.from.at[axis] = through - reach;
                segment.to.at[axis] = through + reach;
            }
            SegmentWalk walk(tree, segment);
            ASSERT_EQ(walk.status(), Status::ok);
            Passage passage = {};
            Passage last = {};
            std::size_t met = 0;
            bool near_target = false;
            for (; walk.next(passage); last = passage, ++met) {
                ASSERT_TRUE(same_leaf(passage.leaf, leaf_at(tree, passage.leaf.octant.corner).leaf));
                ASSERT_FALSE(passage.exit < passage.entry);
                ASSERT_TRUE(holds_at(passage.leaf.octant, segment, passage.entry));
                ASSERT_TRUE(holds_at(passage.leaf.octant, segment, passage.exit));
                ASSERT_EQ(passage.begins, leaf_at(tree, segment.from).status == Status::ok && met == 0);
                ASSERT_TRUE(met == 0 ||
                            (passage.entry == last.exit && passage.entered_axis == last.left_axis));
                const Parameter middle = {1, 2};
                near_target = near_target || (!(middle < passage.entry) && !(passage.exit < middle));
            }
            bool in_root = true; // the middle, moved
            for (unsigned axis = 0; axis < 3; ++axis) {
                in_root = in_root && (segment.from.at[axis] + segment.to.at[axis]) / 2 < root_side;
            }
            ASSERT_EQ(near_target, in_root);
            ASSERT_TRUE(met == 0 || last.ends == (leaf_at(tree, segment.to).status == Status::ok));
        }
    }
}

TEST(SegmentWalk, UniformTrees) {
    HeapPool pool(0);
    for (const Colour colour : {Colour::white, Colour::boundary, Colour::black}) {
        const Octree tree = Octree::uniform(*pool, colour);
        for (const Point& q : {Point{{20, 3, 4}}, Point{{8, 8, 8}}, Point{{-1, 16, 0}}, Point{{8, 2, 8}}}) {
            ASSERT_TRUE(passages_agree(tree, {{8, 8, 8}}, q));
            ASSERT_TRUE(passages_agree(tree, {{-3, 8, 18}}, q));
            ASSERT_TRUE(crossings_agree(tree, {{-3, 8, 18}}, q));
            ASSERT_TRUE(crossings_agree(tree, {{8, 8, 8}}, q));
        }
    }
}

TEST(SegmentWalk, RefusesWhatIsOutOfReach) {
    HeapPool pool(0);
    const Octree tree = Octree::uniform(*pool, Colour::black);
    const Segment whole = {{{-segment_reach, -segment_reach, -segment_reach}},
                           {{segment_reach, segment_reach, segment_reach}}};
    EXPECT_EQ(SegmentWalk(tree, whole).status(), Status::ok);
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (const std::int32_t bad : {-segment_reach - 1, segment_reach + 1, INT32_MIN, INT32_MAX}) {
            for (const bool first : {true, false}) {
                Segment segment = whole;
                (first ? segment.from : segment.to).at[axis] = bad;
                SegmentWalk walk(tree, segment);
                Passage passage = {};
                Crossing crossing = {};
                EXPECT_EQ(walk.status(), Status::coordinate_out_of_range);
                EXPECT_FALSE(walk.next(passage) || walk.next_crossing(crossing));
                const HitOutcome found = first_hit(tree, segment);
                EXPECT_EQ(found.status, Status::coordinate_out_of_range);
                EXPECT_FALSE(found.hit || found.visited != 0);
            }
        }
    }
}

TEST(Ray, EndsOutsideAndKeepsItsDirection) {
    std::mt19937 random(24);
    for (int i = 0; i < 20000; ++i) {
        Point from = {};
        Point direction = {};
        const auto range = [&random](unsigned bits) {
            return static_cast<std::int32_t>(random() % (std::uint32_t{2} << bits)) - (1 << bits);
        };
        const auto bits = static_cast<unsigned>(random() % 29);
        for (unsigned axis = 0; axis < 3; ++axis) {
            from.at[axis] = range(static_cast<unsigned>(random() % 29));
            direction.at[axis] = random() % 4 == 0 ? 0 : range(bits);
        }
        const Segment segment = ray(from, direction);
        ASSERT_EQ(segment.from, from);
        if (direction == Point{{0, 0, 0}}) {
            ASSERT_EQ(segment.to, from);
            continue;
        }
        std::int32_t longest = 0;
        std::int64_t scale = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (direction.at[axis] == 0) continue;
            scale = (std::int64_t{segment.to.at[axis]} - from.at[axis]) / direction.at[axis];
            longest = std::max(longest, std::abs(segment.to.at[axis] - from.at[axis]));
        }
        for (unsigned axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(segment.to.at[axis] - from.at[axis], scale * direction.at[axis]);
            ASSERT_LE(std::abs(segment.to.at[axis]), segment_reach);
        }
        ASSERT_TRUE(scale > 0 && (scale & (scale - 1)) == 0);
        ASSERT_GE(longest, segment_reach / 4) << "it leaves the root";
    }
}

// As fractions, whatever their denominators are.
TEST(Parameters, AreOrderedAsFractions) {
    for (std::int32_t d = 1; d <= 6; ++d) {
        for (std::int32_t n = 0; n <= d; ++n) {
            for (std::int32_t e = 1; e <= 6; ++e) {
                for (std::int32_t m = 0; m <= e; ++m) {
                    const Parameter a = {n, d};
                    const Parameter b = {m, e};
                    const std::int32_t difference = n * (60 / d) - m * (60 / e);
                    EXPECT_EQ(a < b, difference < 0);
                    EXPECT_EQ(a == b, difference == 0);
                    EXPECT_EQ(a != b, difference != 0);
                }
            }
        }
    }
    const std::int32_t greatest = 1 << 30;
    EXPECT_TRUE((Parameter{greatest - 2, greatest - 1}) < (Parameter{greatest - 1, greatest}));
    EXPECT_FALSE((Parameter{greatest - 1, greatest}) < (Parameter{greatest - 2, greatest - 1}));
}

} // namespace

} // namespace osem::tests
