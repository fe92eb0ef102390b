#include "osem/frame.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace osem::tests {

namespace {

std::int64_t floor_division(std::int64_t dividend, std::int64_t divisor) {
    const std::int64_t quotient = dividend / divisor;
    return dividend % divisor < 0 ? quotient - 1 : quotient;
}

// (world - origin) * 2^shift, rounded as floor(x + 1/2); by division, without a shift to the right.
std::int64_t expected_lattice(std::int32_t world, std::int32_t origin, int shift) {
    const std::int64_t difference = std::int64_t{world} - origin;
    if (shift >= 0) return difference * (std::int64_t{1} << shift);
    const std::int64_t unit = std::int64_t{1} << -shift;
    return floor_division(2 * difference + unit, 2 * unit);
}

// origin + lattice / 2^shift, rounded down.
std::int64_t expected_world(std::int32_t lattice, std::int32_t origin, int shift) {
    if (shift < 0) return origin + std::int64_t{lattice} * (std::int64_t{1} << -shift);
    return origin + floor_division(lattice, std::int64_t{1} << shift);
}

Frame frame_of(std::int32_t origin, int shift) {
    return Frame{{origin, origin, origin}, static_cast<std::int8_t>(shift)};
}

// The same coordinate on each axis in turn, beside coordinates that map to 0.
void expect_mapping(const Frame& frame, std::int32_t world) {
    const std::int64_t expected = expected_lattice(world, frame.origin[0], frame.shift);
    const bool fits = expected >= 0 && expected <= root_side;
    for (int axis = 0; axis < 3; ++axis) {
        WorldPoint point = {{frame.origin[0], frame.origin[1], frame.origin[2]}};
        point.at[axis] = world;
        Point lattice = {{-1, -1, -1}};
        const FrameOutcome outcome = to_lattice(frame, &point, 1, &lattice);
        ASSERT_EQ(outcome.status, fits ? Status::ok : Status::point_outside_frame)
            << "shift " << int{frame.shift} << ", origin " << frame.origin[0] << ", world " << world;
        if (!fits) continue;
        Point wanted = {{0, 0, 0}};
        wanted.at[axis] = static_cast<std::int32_t>(expected);
        ASSERT_EQ(lattice, wanted) << "shift " << int{frame.shift} << ", world " << world;
    }
}

constexpr int least_shift = -31;
constexpr int greatest_shift = 20;

TEST(Frame, EveryShiftNearItsBoundaries) {
    for (int shift = least_shift; shift <= greatest_shift; ++shift) {
        for (const std::int32_t origin : {0, 1, -1, 1000, INT32_MIN, INT32_MIN + 1, INT32_MAX}) {
            const std::int64_t unit = shift < 0 ? std::int64_t{1} << -shift : 1;
            const std::int64_t extent = shift < 0 ? root_side * unit : root_side >> shift;
            for (const std::int64_t place : {std::int64_t{0}, unit, 3 * unit, extent / 2, extent}) {
                for (const std::int64_t off : {std::int64_t{0}, std::int64_t{1}, unit / 2, unit}) {
                    for (const std::int64_t sign : {-1, 0, 1}) {
                        const std::int64_t world = origin + place + sign * off + (off == unit / 2 ? sign : 0);
                        if (world < INT32_MIN || world > INT32_MAX) continue;
                        expect_mapping(frame_of(origin, shift), static_cast<std::int32_t>(world));
                    }
                }
            }
            expect_mapping(frame_of(origin, shift), INT32_MIN);
            expect_mapping(frame_of(origin, shift), INT32_MAX);
        }
    }
}

TEST(Frame, RandomPoints) {
    std::mt19937 random(20);
    for (int i = 0; i < 20000; ++i) {
        const int shift = least_shift + static_cast<int>(random() % 52);
        const auto origin = static_cast<std::int32_t>(random());
        const auto far = static_cast<std::int32_t>(random());
        expect_mapping(frame_of(origin, shift), far);
        const std::int64_t near =
            std::int64_t{origin} + static_cast<std::int32_t>(random() >> (random() % 32));
        if (near <= INT32_MAX) expect_mapping(frame_of(origin, shift), static_cast<std::int32_t>(near));
    }
}

TEST(Frame, HalvesGoUp) {
    const Frame frame = frame_of(-10, -2); // four raw units a lattice unit
    const WorldPoint world[2] = {{{-12, -11, -9}}, {{-8, -7, -6}}};
    Point lattice[2] = {};
    ASSERT_EQ(to_lattice(frame, world, 2, lattice).status, Status::ok);
    EXPECT_EQ(lattice[0], (Point{{0, 0, 0}})); // -1/2 goes to 0, -1/4 and 1/4 too
    EXPECT_EQ(lattice[1], (Point{{1, 1, 1}})); // 1/2 goes to 1, 3/4 too

    const WorldPoint outside = {{-13, -10, -10}}; // -3/4
    EXPECT_EQ(to_lattice(frame, &outside, 1, lattice).status, Status::point_outside_frame);
}

TEST(Frame, BothEndsOfTheRootBelongToIt) {
    const Frame frame = frame_of(100, 0);
    const std::int32_t end = 100 + root_side;
    const WorldPoint corners[2] = {{{100, 100, 100}}, {{end, end, end}}};
    Point lattice[2] = {};
    ASSERT_EQ(to_lattice(frame, corners, 2, lattice).status, Status::ok);
    EXPECT_EQ(lattice[0], (Point{{0, 0, 0}}));
    EXPECT_EQ(lattice[1], (Point{{1 << 20, 1 << 20, 1 << 20}}));
    for (int axis = 0; axis < 3; ++axis) {
        for (const std::int32_t outside : {99, end + 1}) {
            WorldPoint point = corners[0];
            point.at[axis] = outside;
            EXPECT_EQ(to_lattice(frame, &point, 1, lattice).status, Status::point_outside_frame);
        }
    }
}

TEST(Frame, TheFirstPointRefusedIsNamed) {
    const Frame frame = frame_of(0, 0);
    for (std::size_t bad = 0; bad < 5; ++bad) {
        std::vector<WorldPoint> world(5, WorldPoint{{1, 2, 3}});
        world[bad].at[bad % 3] = -1;
        world[4].at[0] = -1;
        std::vector<Point> lattice(5, Point{{9, 9, 9}});
        const FrameOutcome outcome = to_lattice(frame, world.data(), world.size(), lattice.data());
        EXPECT_EQ(outcome.status, Status::point_outside_frame);
        EXPECT_EQ(outcome.index, bad);
        for (std::size_t i = 0; i < bad; ++i) EXPECT_EQ(lattice[i], (Point{{1, 2, 3}}));
        for (std::size_t i = bad + 1; i < 5; ++i) EXPECT_EQ(lattice[i], (Point{{9, 9, 9}}));
    }
}

TEST(Frame, NoPointsAreNoTrouble) {
    EXPECT_EQ(to_lattice(frame_of(0, 0), nullptr, 0, nullptr).status, Status::ok);
}

TEST(Frame, ShiftsOutOfRange) {
    for (int shift = -128; shift <= 127; ++shift) {
        const bool is_allowed = shift >= least_shift && shift <= greatest_shift;
        const Frame frame = frame_of(0, shift);
        const WorldPoint world = {{0, 0, 0}};
        Point lattice = {{7, 7, 7}};
        WorldPoint back = {{7, 7, 7}};
        const Status expected = is_allowed ? Status::ok : Status::shift_out_of_range;
        EXPECT_EQ(to_lattice(frame, &world, 1, &lattice).status, expected) << shift;
        EXPECT_EQ(to_world(frame, Point{{0, 0, 0}}, back), expected) << shift;
        EXPECT_EQ(lattice.x(), is_allowed ? 0 : 7);
        EXPECT_EQ(back.at[0], is_allowed ? 0 : 7);
    }
}

TEST(Frame, BackToTheWorld) {
    std::mt19937 random(21);
    for (int i = 0; i < 20000; ++i) {
        const int shift = least_shift + static_cast<int>(random() % 52);
        const auto origin = static_cast<std::int32_t>(random());
        const auto coordinate = static_cast<std::int32_t>(i % 4 == 0   ? root_side
                                                          : i % 4 == 1 ? random() % 3
                                                                       : random() % (1U << 20));
        const int axis = i % 3;
        Frame frame = frame_of(0, shift);
        frame.origin[axis] = origin;
        Point lattice = {{0, 0, 0}};
        lattice.at[axis] = coordinate;
        WorldPoint world = {{5, 6, 7}};
        const std::int64_t expected = expected_world(coordinate, origin, shift);
        if (expected > INT32_MAX) {
            ASSERT_EQ(to_world(frame, lattice, world), Status::point_outside_frame);
            ASSERT_TRUE(world.at[0] == 5 && world.at[1] == 6 && world.at[2] == 7);
        } else {
            ASSERT_EQ(to_world(frame, lattice, world), Status::ok);
            ASSERT_EQ(world.at[axis], expected) << "shift " << shift;
        }
    }
}

TEST(Frame, RoundTripThroughTheWorld) {
    std::mt19937 random(22);
    for (int i = 0; i < 5000; ++i) {
        const int shift = least_shift + static_cast<int>(random() % 32); // up to 0: exact
        const Frame frame = frame_of(INT32_MIN, shift);
        const auto unit_bits = static_cast<unsigned>(-shift);
        const auto greatest = unit_bits > 11 ? (std::uint64_t{1} << (32 - unit_bits)) - 1 : 1U << 20;
        const auto coordinate = static_cast<std::int32_t>(random() % (greatest + 1));
        const Point lattice = {{coordinate, 0, coordinate}};
        WorldPoint world = {};
        Point back = {};
        ASSERT_EQ(to_world(frame, lattice, world), Status::ok) << shift << " " << coordinate;
        ASSERT_EQ(to_lattice(frame, &world, 1, &back).status, Status::ok);
        ASSERT_EQ(back, lattice);
    }
}

TEST(Frame, RoundTripThroughTheLattice) {
    for (int shift = 0; shift <= greatest_shift; ++shift) { // whole raw units are lattice points
        for (std::int32_t offset : {0, 1, (root_side >> shift) / 2, root_side >> shift}) {
            const Frame frame = frame_of(-77, shift);
            const WorldPoint world = {{-77 + offset, -77, -77 + offset}};
            Point lattice = {};
            WorldPoint back = {};
            ASSERT_EQ(to_lattice(frame, &world, 1, &lattice).status, Status::ok);
            ASSERT_EQ(to_world(frame, lattice, back), Status::ok);
            for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(back.at[axis], world.at[axis]);
        }
    }
}

// Points beside the lattice are mapped as well, as far as the world goes.
TEST(Frame, TheWorldEndsAtBothEnds) {
    for (int axis = 0; axis < 3; ++axis) {
        Frame frame = frame_of(0, 0);
        Point lattice = {{0, 0, 0}};
        WorldPoint world = {{5, 6, 7}};
        frame.origin[axis] = INT32_MIN;
        lattice.at[axis] = -1;
        EXPECT_EQ(to_world(frame, lattice, world), Status::point_outside_frame);
        EXPECT_TRUE(world.at[0] == 5 && world.at[1] == 6 && world.at[2] == 7);
        frame.origin[axis] = INT32_MIN + 1;
        EXPECT_EQ(to_world(frame, lattice, world), Status::ok);
        EXPECT_EQ(world.at[axis], INT32_MIN);
    }
}

} // namespace

} // namespace osem::tests
