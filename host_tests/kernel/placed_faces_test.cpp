// Faces that are placed from the beginning, against a classification of each octant, or ways between leaves'
// centres; and how they are sorted.
#include "grid/placed_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "classify/crossing.hpp"
#include "grid/extent.hpp"
#include "grid/last_octants.hpp"
#include "osem/classify.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

// Octants that last grids divide into 2^leaf_levels leaves along each axis.
struct DividedOctants {
    Octant octant;
    int levels;
    int leaf_levels;
    LeafRule leaves;

    std::uint32_t count() const { return 1U << (3 * levels); }
    std::int32_t side() const { return octant.side() >> levels; }
    std::int32_t leaf() const { return side() >> leaf_levels; }
    std::int32_t offset() const { return leaves == LeafRule::centre ? leaf() / 2 : 0; }
    Octant at(std::uint32_t number) const {
        Octant result = octant;
        for (int level = levels - 1; level >= 0; --level) result = result.child(number >> (3 * level) & 7U);
        return result;
    }
    Point reference(std::uint32_t number) const {
        Point point = at(number).corner;
        for (std::int32_t& coordinate : point.at) coordinate += offset();
        return point;
    }
    LastOctants last() const {
        const int leaf_shift = lattice_bits - octant.level - levels - leaf_levels;
        return LastOctants(octant, levels, leaves == LeafRule::centre ? leaf_shift : 0, offset());
    }
};

// Whether a face lies on a way along an axis from one reference point of an octant's leaves to the next.
bool is_on_ways_between_leaves(const Solid& view, const DividedOctants& octants, std::uint32_t number) {
    const Point first = octants.reference(number);
    const std::int32_t leaf = octants.leaf();
    const int last = (1 << octants.leaf_levels) - 1;
    for (int i = 0; i <= last; ++i) {
        for (int j = 0; j <= last; ++j) {
            for (int k = 0; k <= last; ++k) {
                const int indices[3] = {i, j, k};
                const Point from = {{first.x() + i * leaf, first.y() + j * leaf, first.z() + k * leaf}};
                for (const Axis axis : {axis_x, axis_y, axis_z}) {
                    if (indices[axis] < last && crossing(view, 0, from, axis, leaf) != 0) return true;
                }
            }
        }
    }
    return false;
}

// The octants in which a face, which is all of a solid, has an effect.
std::vector<std::uint32_t> octants_with_effect(const SmallSolid& solid, const DividedOctants& octants) {
    std::vector<std::uint32_t> numbers;
    const Solid view = solid.view();
    const Extent extent(view, view.corners, view.corners + view.corner_count);
    for (std::uint32_t number = 0; number < octants.count(); ++number) {
        const Octant octant = octants.at(number);
        bool near = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t corner = octant.corner.at[axis];
            near = near && extent.low.at[axis] <= corner + octant.side() && extent.high.at[axis] >= corner;
        }
        const auto has_effect = [&] {
            return octants.leaves == LeafRule::centre
                       ? is_on_ways_between_leaves(solid.view(), octants, number)
                       : classify(solid.vouched(), 0, octant).meets;
        };
        if (near && has_effect()) numbers.push_back(number);
    }
    return numbers;
}

bool is_on_ways_between_octants(const Solid& view, const DividedOctants& octants) {
    const Point& low = octants.octant.corner;
    for (std::uint32_t number = 0; number < octants.count(); ++number) {
        for (const Axis axis : {axis_x, axis_y, axis_z}) {
            const std::int32_t next = octants.at(number).corner.at[axis] + octants.side();
            if (next == low.at[axis] + octants.octant.side()) continue;
            if (crossing(view, 0, octants.reference(number), axis, octants.side()) != 0) return true;
        }
    }
    return false;
}

// A triangle of about so many octants' sides, its corners often on their borders.
SmallSolid triangle(std::mt19937& random, const Octant& near, double sides) {
    const std::int32_t side = near.side();
    const auto reach = static_cast<std::int32_t>(sides * side) + 1;
    SmallSolid solid;
    Polygon corners(3);
    Point first = near.corner;
    for (std::int32_t& at : first.at) at += std::uniform_int_distribution<std::int32_t>(0, side)(random);
    for (Point& corner : corners) {
        corner = first;
        for (std::int32_t& at : corner.at) {
            at += std::uniform_int_distribution<std::int32_t>(-reach, reach)(random);
            if (std::uniform_int_distribution<int>(0, 4)(random) == 0) at = (at + side / 2) / side * side;
            at = std::clamp(at, 0, root_side);
        }
    }
    solid.add_face({corners});
    return solid;
}

struct Trials {
    std::uint64_t placed = 0;
    std::uint64_t without_effect = 0;
    std::uint64_t on_way = 0;
};

void try_face(const SmallSolid& solid, const DividedOctants& octants, Trials& trials) {
    const Solid view = solid.view();
    const FacePlaces places = octants.last().places_of(view, 0);
    Point start = octants.reference(0);
    const std::int32_t length = start.x() + 1;
    start.at[axis_x] = -1;
    const bool is_on_way = crossing(view, 0, start, axis_x, length) != 0;
    EXPECT_TRUE(places.is_on_way || !is_on_way);
    trials.on_way += is_on_way ? 1 : 0;
    if (places.has_effect && places.count == 0) return;
    ++(places.has_effect ? trials.placed : trials.without_effect);
    EXPECT_FALSE(is_on_ways_between_octants(view, octants));
    std::vector<std::uint32_t> found(places.octants, places.octants + places.count);
    std::sort(found.begin(), found.end());
    const std::vector<std::uint32_t> needed = octants_with_effect(solid, octants);
    if (octants.leaves == LeafRule::centre) {
        EXPECT_TRUE(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
    } else {
        EXPECT_EQ(found, needed);
    }
}

Trials try_faces(const DividedOctants& octants, std::mt19937& random) {
    Trials trials;
    for (int trial = 0; trial < 2000; ++trial) {
        const auto near = std::uniform_int_distribution<std::uint32_t>(0, octants.count() - 1)(random);
        try_face(triangle(random, octants.at(trial % 5 == 0 ? 0 : near), trial % 2 == 0 ? 0.2 : 0.7), octants,
                 trials);
    }
    return trials;
}

TEST(PlacedFaces, HaveNoEffectElsewhere) {
    std::mt19937 random(5);
    const Octant apart = root_octant.child(6).child(1);
    std::uint64_t on_way = 0;
    for (const Octant& octant : {root_octant, apart}) {
        for (const int levels : {1, 2, 3}) {
            const Trials met = try_faces({octant, levels, 2, LeafRule::conservative}, random);
            EXPECT_GT(met.placed, 300U);
            const Trials passed = try_faces({octant, levels, 2, LeafRule::centre}, random);
            EXPECT_GT(passed.placed, 300U);
            EXPECT_GT(passed.without_effect, 100U);
            on_way += met.on_way + passed.on_way;
        }
    }
    EXPECT_GT(on_way, 20U);
}

TEST(PlacedFaces, AreInOneOctantIfOnlyThereCentresArePassed) {
    const auto places_of = [](const Polygon& corners, LeafRule leaves) {
        SmallSolid solid;
        solid.add_face({corners});
        const DividedOctants octants = {root_octant, 2, 3, leaves};
        return octants.last().places_of(solid.view(), 0);
    };
    const std::int32_t side = root_side / 4;
    const std::int32_t leaf = side / 8;
    const std::int32_t z = 3 * leaf;
    const Polygon behind = {
        {{side - leaf / 3, leaf, z}}, {{side + leaf, leaf, z + 5}}, {{side, 3 * leaf, z}}};
    EXPECT_EQ(places_of(behind, LeafRule::conservative).count, 2U);
    const FacePlaces second = places_of(behind, LeafRule::centre);
    EXPECT_EQ(second.count, 1U);
    EXPECT_EQ(second.octants[0], 1U);
    const Polygon before = {
        {{side + leaf / 3, leaf, z}}, {{side - leaf, leaf, z + 5}}, {{side, 3 * leaf, z}}};
    const FacePlaces first = places_of(before, LeafRule::centre);
    EXPECT_EQ(first.count, 1U);
    EXPECT_EQ(first.octants[0], 0U);
    const Polygon both = {{{side + leaf, leaf, z}}, {{side - leaf, leaf, z + 5}}, {{side, 3 * leaf, z}}};
    EXPECT_EQ(places_of(both, LeafRule::centre).count, 2U);
    const Polygon narrow = {{{side + 1, leaf, z}}, {{side - 1, leaf, z + 5}}, {{side, 3 * leaf, z}}};
    EXPECT_FALSE(places_of(narrow, LeafRule::centre).has_effect) << "it passes centres along y alone";
    EXPECT_EQ(places_of(narrow, LeafRule::conservative).count, 2U);
    const Polygon between = {{{side + 1, leaf, z}}, {{side - 1, leaf, 2 * z}}, {{side, 3 * leaf, z}}};
    EXPECT_EQ(places_of(between, LeafRule::centre).count, 0U) << "the centres beside it are in two octants";
    EXPECT_TRUE(places_of(between, LeafRule::centre).has_effect);
}

TEST(PlacedFaces, OthersAreNotPlaced) {
    const auto places_of = [](const SmallSolid& solid, const Octant& octant, int levels) {
        return LastOctants(octant, levels, 0, 0).places_of(solid.view(), 0);
    };
    const SmallSolid tiny = octahedron_solid(Octahedron{{{5, 5, 5}}, 2});
    EXPECT_EQ(places_of(tiny, root_octant, 10).count, 1U);
    EXPECT_EQ(places_of(tiny, root_octant, 11).count, 0U) << "of 33 bits";
    EXPECT_TRUE(places_of(tiny, root_octant, 11).has_effect);
    EXPECT_EQ(places_of(tiny, root_octant, 0).count, 0U) << "there is one list";
    EXPECT_TRUE(places_of(tiny, root_octant, 0).has_effect);
    EXPECT_EQ(places_of(tiny, root_octant.child(7), 3).count, 0U) << "elsewhere";
    EXPECT_FALSE(places_of(tiny, root_octant.child(7), 3).has_effect);
    SmallSolid quadrangle;
    quadrangle.add_face({{{{1, 1, 1}}, {{5, 1, 2}}, {{5, 5, 3}}, {{1, 5, 2}}}});
    EXPECT_EQ(places_of(quadrangle, root_octant, 2).count, 0U);
    EXPECT_TRUE(places_of(quadrangle, root_octant, 2).has_effect);
}

TEST(PlacedFaces, AreSortedByDigits) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        const PlacedFaces::Digit digit = {static_cast<unsigned>(3 * (trial % 4)), trial % 3 == 0 ? 7U : 63U};
        const auto count = std::uniform_int_distribution<std::uint32_t>(0, 90)(random);
        const auto most = std::uniform_int_distribution<std::uint32_t>(0, 1U << 15)(random);
        std::vector<std::array<std::uint32_t, 2>> faces(count);
        for (auto& face : faces) {
            face = {std::uniform_int_distribution<std::uint32_t>(0, most)(random),
                    static_cast<std::uint32_t>(random())};
        }
        std::vector<std::uint32_t> memory;
        for (const auto& face : faces) memory.insert(memory.end(), face.begin(), face.end());
        std::vector<std::uint32_t> space(PlacedFaces::words_to_sort);
        const PlacedFaces placed = {memory.data()};
        const PlacedFaces::Range range = {count / 5, count - count / 7};
        const std::uint64_t present = placed.sort(range, digit, space.data());
        std::uint64_t expected = 0;
        std::uint32_t next = range.first;
        for (std::uint32_t value = 0; value <= digit.greatest; ++value) {
            const PlacedFaces::Range front = placed.front({next, range.end}, digit, value);
            ASSERT_EQ(front.first, next);
            for (std::uint32_t i = front.first; i != front.end; ++i)
                ASSERT_EQ(digit.of(placed.octant(i)), value);
            if (front.first != front.end) expected |= std::uint64_t{1} << value;
            next = front.end;
        }
        EXPECT_EQ(next, range.end) << "they ascend";
        EXPECT_EQ(present, expected);
        std::vector<std::array<std::uint32_t, 2>> sorted;
        for (std::uint32_t i = 0; i < count; ++i) sorted.push_back({placed.octant(i), placed.face(i)});
        for (std::uint32_t i = 0; i < count; ++i) {
            if (i < range.first || i >= range.end) {
                EXPECT_EQ(sorted[i], faces[i]) << "of another range";
            }
        }
        std::sort(sorted.begin(), sorted.end());
        std::sort(faces.begin(), faces.end());
        EXPECT_EQ(sorted, faces);
    }
}

} // namespace

} // namespace osem::tests
