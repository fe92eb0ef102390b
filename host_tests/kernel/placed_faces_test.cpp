// Faces that are placed from the beginning, against a classification of each octant; and how they are sorted.
#include "grid/placed_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "classify/crossing.hpp"
#include "osem/classify.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

Octant octant_at(const LastOctants& octants, std::uint32_t number) {
    Octant octant = octants.octant;
    for (int level = octants.levels - 1; level >= 0; --level)
        octant = octant.child(number >> (3 * level) & 7U);
    return octant;
}

Point reference_of(const Octant& octant, std::int32_t offset) {
    Point point = octant.corner;
    for (std::int32_t& coordinate : point.at) coordinate += offset;
    return point;
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

std::uint64_t trials_placed(const LastOctants& octants, std::mt19937& random) {
    const std::uint32_t count = 1U << (3 * octants.levels);
    const auto any = [&] { return std::uniform_int_distribution<std::uint32_t>(0, count - 1)(random); };
    std::uint64_t placed = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const SmallSolid solid = triangle(random, octant_at(octants, any()), trial % 2 == 0 ? 0.2 : 0.7);
        const Solid view = solid.view();
        const FacePlaces places = places_of(view, 0, Extent(view, 0), octants);
        if (places.count == 0) continue;
        ++placed;
        std::vector<std::uint32_t> met;
        for (std::uint32_t number = 0; number < count; ++number) {
            const Octant octant = octant_at(octants, number);
            if (classify(solid.vouched(), 0, octant).meets) met.push_back(number);
            const Point reference = reference_of(octant, octants.offset);
            for (const Axis axis : {axis_x, axis_y, axis_z}) {
                EXPECT_EQ(crossing(view, 0, reference, axis, octant.side()), 0)
                    << "on the way to the next one";
            }
        }
        std::vector<std::uint32_t> found(places.octants, places.octants + places.count);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, met) << trial;
    }
    return placed;
}

TEST(PlacedFaces, MeetTheirOctantsAndNoWayBetweenReferencePoints) {
    std::mt19937 random(5);
    const Octant apart = root_octant.child(6).child(1);
    for (const Octant& octant : {root_octant, apart}) {
        for (const int levels : {1, 2, 3}) {
            const std::int32_t side = octant.side() >> levels;
            for (const std::int32_t offset : {0, side / 2, side / 64}) {
                EXPECT_GT(trials_placed({octant, levels, offset}, random), 500U);
            }
        }
    }
}

TEST(PlacedFaces, OthersAreNotPlaced) {
    const SmallSolid tiny = octahedron_solid(Octahedron{{{5, 5, 5}}, 2});
    const Solid view = tiny.view();
    EXPECT_EQ(places_of(view, 0, Extent(view, 0), {root_octant, 10, 0}).count, 1U);
    EXPECT_EQ(places_of(view, 0, Extent(view, 0), {root_octant, 11, 0}).count, 0U) << "of 33 bits";
    EXPECT_EQ(places_of(view, 0, Extent(view, 0), {root_octant, 0, 0}).count, 0U) << "there is one list";
    EXPECT_EQ(places_of(view, 0, Extent(view, 0), {root_octant.child(7), 3, 0}).count, 0U) << "elsewhere";
    SmallSolid quadrangle;
    quadrangle.add_face({{{{1, 1, 1}}, {{5, 1, 2}}, {{5, 5, 3}}, {{1, 5, 2}}}});
    EXPECT_EQ(places_of(quadrangle.view(), 0, Extent(quadrangle.view(), 0), {root_octant, 2, 0}).count, 0U);
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
