// Classification, crossings, planes, winding numbers along lines of sight, frames: against integers of any
// length, for single faces near an octant, most of them degenerate in some way.
#include <gmpxx.h>

#include <algorithm>
#include <vector>

#include "classify/box.hpp"
#include "classify/crossing.hpp"
#include "geometry/plane.hpp"
#include "geometry/sight.hpp"
#include "osem/bintree.hpp"
#include "osem/frame.hpp"
#include "osem/ray.hpp"
#include "support/exact.hpp"
#include "support/near_face.hpp"
#include "support/target.hpp"

namespace osem::fuzz {

namespace {

void classify_in(const tests::SmallSolid& face, const ExactFace& exact, const Box& box,
                 const Decision& decision) {
    const OpenBox open = {box.lo, box.hi};
    EXPECT_EQ(decision.meets, exact.meets(open));
    EXPECT_EQ(decision.stage == Stage::minimax, !exact.box_meets(open));
    const bool missed_by_plane = exact.box_meets(open) && exact.has_area() && !exact.plane_meets(open);
    EXPECT_EQ(decision.stage == Stage::plane, missed_by_plane);
    if (decision.stage == Stage::holes) {
        EXPECT_GT(face.faces()[0].size(), 1U);
    }
}

// The octant, its children, and a way down the halves between octants.
void test_classification(const tests::SmallSolid& face, const Octant& octant, Choices& choices) {
    const ExactFace exact(face.view(), 0);
    ASSERT_TRUE(exact.is_planar());
    const CheckedSolid solid = face.vouched();
    classify_in(face, exact, box_of(octant), classify(solid, 0, octant));
    if (octant.level == max_depth) return;
    for (unsigned k = 0; k < 8; ++k) {
        classify_in(face, exact, box_of(octant.child(k)), classify(solid, 0, octant.child(k)));
    }
    Block block = {octant.corner, static_cast<std::uint8_t>(3 * octant.level)};
    for (int halvings = 0; halvings < 3; ++halvings) {
        const unsigned high = choices.below(2);
        EXPECT_EQ(block.half(high).parent().corner, block.corner);
        EXPECT_EQ(block.half(high).is_high(), high != 0);
        block = block.half(high);
        Box box = {block.corner, block.corner};
        for (int axis = 0; axis < 3; ++axis) box.hi.at[axis] += block.side(axis);
        classify_in(face, exact, box, classify_box(face.view(), 0, box));
    }
}

void test_plane(const tests::SmallSolid& face, const Octant& octant, Choices& choices) {
    const ExactFace exact(face.view(), 0);
    const Plane plane(face.view(), 0);
    EXPECT_EQ(plane.is_null(), !exact.has_area());
    const Point q = near_point(octant, choices);
    const Point origin = face.faces()[0][0][0];
    mpz_class value = 0;
    mpz_class dot = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const mpz_class component = static_cast<long>(plane.normal(axis).value());
        value += component * (q.at[axis] - origin.at[axis]);
        dot += component * exact.normal()[static_cast<std::size_t>(axis)];
    }
    EXPECT_EQ(mpz_class(static_cast<long>(plane.at(q).value())), value);
    if (plane.is_null()) return;
    // The two normals are parallel, so the two sides are the same or opposite throughout.
    EXPECT_NE(dot, 0);
    EXPECT_EQ(plane.at(q).sign() * sgn(dot), sgn(exact.side(scaled(q))));
}

void test_crossing(const tests::SmallSolid& face, const Octant& octant, Choices& choices) {
    Point from = near_point(octant, choices);
    const auto axis = static_cast<Axis>(choices.below(3));
    if (choices.below(8) == 0) from.at[axis] = -1;
    const std::int32_t room = root_side - from.at[axis];
    if (room == 0) return;
    const std::int32_t length =
        choices.flag() ? std::min(room, octant.side())
                       : 1 + static_cast<std::int32_t>(choices.below(static_cast<std::uint32_t>(room)));
    Point to = from;
    to.at[axis] += length;
    const ExactFace exact(face.view(), 0);
    const std::optional<int> expected = exact.change(perturbed(from), perturbed(to));
    ASSERT_TRUE(expected.has_value());
    EXPECT_EQ(crossing(face.view(), 0, from, axis, length), *expected);
}

// Points as they are seen, and the winding number around the line of sight moved by (e, e^2), e = 2^-100.
int seen_winding(const tests::SmallSolid& face, const Point& from, int along, const int (&lean)[2]) {
    const int axes[2] = {along == 0 ? 1 : 0, along == 2 ? 1 : 2};
    const mpz_class moved[2] = {mpz_class(1) << 100, mpz_class(1)}; // in units of 2^-200
    int around = 0;
    for (const auto& ring : face.faces()[0]) {
        std::vector<std::array<mpz_class, 2>> seen;
        for (const Point& p : ring) {
            seen.emplace_back();
            for (std::size_t i = 0; i < 2; ++i) {
                const mpz_class offset = mpz_class(p.at[axes[i]]) - from.at[axes[i]] -
                                         mpz_class(lean[i]) * (p.at[along] - from.at[along]);
                seen.back()[i] = (offset << 200) - moved[i];
            }
        }
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const auto& a = seen[i];
            const auto& b = seen[(i + 1) % seen.size()];
            const int turn = sgn(mpz_class(a[0] * b[1] - a[1] * b[0]));
            if (sgn(a[1]) < 0 && sgn(b[1]) > 0 && turn > 0) ++around;
            if (sgn(b[1]) < 0 && sgn(a[1]) > 0 && turn < 0) --around;
        }
    }
    return around;
}

void test_sight(const tests::SmallSolid& face, const Octant& octant, Choices& choices) {
    const Point from = near_point(octant, choices);
    const auto along = static_cast<Axis>(choices.below(3));
    const int lean[2] = {choices.between(-2, 2), choices.between(-2, 2)};
    const std::int32_t found =
        winding_of_rings(face.view(), 0, static_cast<std::uint32_t>(face.faces()[0].size()),
                         Sight(from, along, lean[0], lean[1]));
    EXPECT_EQ(found, seen_winding(face, from, along, lean));
}

mpz_class floor_of(const mpq_class& value) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    return whole;
}

mpq_class power(int exponent) {
    mpq_class value = 1;
    if (exponent >= 0) mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    if (exponent < 0) mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    return value;
}

// A coordinate of any size, or one that the frame maps near an end of the root.
std::int32_t world_coordinate(std::int32_t origin, int shift, Choices& choices) {
    const std::uint8_t kind = choices.byte();
    if (kind < 64) return static_cast<std::int32_t>(choices.word());
    mpq_class place = power(-shift) * (kind < 128   ? root_side
                                       : kind < 160 ? 0
                                                    : choices.between(0, root_side));
    place += mpq_class(static_cast<long>(choices.between(-3, 3)), 2) * power(-shift);
    const mpz_class value = origin + floor_of(place);
    return value < INT32_MIN || value > INT32_MAX ? origin : static_cast<std::int32_t>(value.get_si());
}

void test_frame(Choices& choices) {
    Frame frame = {{0, 0, 0}, static_cast<std::int8_t>(choices.between(-33, 22))};
    for (std::int32_t& at : frame.origin) at = choices.flag() ? static_cast<std::int32_t>(choices.word()) : 0;
    const bool allowed = frame.shift >= -31 && frame.shift <= 20;
    WorldPoint world[3] = {};
    Point lattice[3] = {};
    std::size_t good = 0;
    bool all_good = true;
    Point expected[3] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            world[i].at[axis] = world_coordinate(frame.origin[axis], frame.shift, choices);
            const mpq_class place =
                mpq_class(mpz_class(world[i].at[axis]) - frame.origin[axis]) * power(frame.shift);
            const mpz_class rounded = floor_of(place + mpq_class(1, 2));
            if (rounded < 0 || rounded > root_side) all_good = false;
            expected[i].at[axis] = static_cast<std::int32_t>(rounded.get_si());
        }
        if (all_good) good = i + 1;
    }
    const FrameOutcome outcome = to_lattice(frame, world, 3, lattice);
    if (!allowed) {
        EXPECT_EQ(outcome.status, Status::shift_out_of_range);
    } else {
        EXPECT_EQ(outcome.status, all_good ? Status::ok : Status::point_outside_frame);
        if (!all_good) {
            EXPECT_EQ(outcome.index, good);
        }
        for (std::size_t i = 0; i < good; ++i) EXPECT_EQ(lattice[i], expected[i]);
    }

    const Point p = {{static_cast<std::int32_t>(choices.word()), choices.between(0, root_side), 0}};
    WorldPoint back = {{7, 7, 7}};
    bool fits = true;
    WorldPoint expected_back = {};
    for (int axis = 0; axis < 3; ++axis) {
        const mpz_class value = floor_of(mpq_class(p.at[axis]) * power(-frame.shift)) + frame.origin[axis];
        if (value < INT32_MIN || value > INT32_MAX) fits = false;
        expected_back.at[axis] = static_cast<std::int32_t>(value.get_si());
    }
    const Status status = to_world(frame, p, back);
    EXPECT_EQ(status, !allowed ? Status::shift_out_of_range
                      : fits   ? Status::ok
                               : Status::point_outside_frame);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(back.at[axis], status == Status::ok ? expected_back.at[axis] : 7);
}

// The end is the direction times the greatest power of two that keeps it within reach.
void test_ray(Choices& choices) {
    Point from = {};
    Point direction = {};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t limit = 1 << choices.below(29);
        from.at[axis] = choices.between(-limit, limit);
        direction.at[axis] = choices.between(-limit, limit);
    }
    const Segment segment = ray(from, direction);
    EXPECT_EQ(segment.from, from);
    if (direction == Point{{0, 0, 0}}) {
        EXPECT_EQ(segment.to, from);
        return;
    }
    const auto fits = [&](const mpz_class& factor) {
        for (int axis = 0; axis < 3; ++axis) {
            if (abs(mpz_class(from.at[axis] + factor * direction.at[axis])) > segment_reach) return false;
        }
        return true;
    };
    mpz_class factor = 1;
    while (fits(2 * factor)) factor *= 2;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(mpz_class(segment.to.at[axis]), from.at[axis] + factor * direction.at[axis]);
    }
}

void test_parameter(Choices& choices) {
    const auto parameter = [&] {
        const std::int32_t denominator =
            1 + static_cast<std::int32_t>(choices.below(1U << choices.below(31)));
        return Parameter{choices.between(0, denominator), denominator};
    };
    const Parameter a = parameter();
    const Parameter b = parameter();
    mpq_class x(a.numerator, a.denominator);
    mpq_class y(b.numerator, b.denominator);
    x.canonicalize();
    y.canonicalize();
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a == b, x == y);
    EXPECT_EQ(a != b, x != y);
}

} // namespace

void run(Choices& choices) {
    const std::uint32_t what = choices.below(8);
    if (what == 6) {
        test_frame(choices);
        return;
    }
    if (what == 7) {
        test_ray(choices);
        test_parameter(choices);
        return;
    }
    const osem::Octant octant = any_octant(choices);
    const osem::tests::SmallSolid face = near_face(octant, choices);
    if (what < 3) test_classification(face, octant, choices);
    if (what == 3) test_plane(face, octant, choices);
    if (what == 4) test_crossing(face, octant, choices);
    if (what == 5) test_sight(face, octant, choices);
}

} // namespace osem::fuzz
