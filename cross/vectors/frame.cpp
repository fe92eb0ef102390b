// Points at the middles between lattice points, at the root's border and at the ends of 32 bits.
#include "osem/frame.hpp"

#include <CGAL/Gmpq.h>

#include "exact.hpp"
#include "random.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using Rational = CGAL::Gmpq;

constexpr int frames = 12500;
constexpr int points = 8;

Rational power_of_two(int exponent) {
    Integer power(1);
    for (int i = 0; i < std::abs(exponent); ++i) power *= Integer(2);
    return exponent >= 0 ? Rational(power) : Rational(Integer(1), power);
}

Integer floor_of(const Rational& value) {
    const Integer quotient = value.numerator() / value.denominator(); // towards 0
    return Rational(quotient) > value ? quotient - Integer(1) : quotient;
}

bool shift_allowed(int shift) { return -31 <= shift && shift <= 20; }
bool is_i32(std::int64_t value) { return INT32_MIN <= value && value <= INT32_MAX; }

struct Answer {
    osem::Status status;
    osem::Point point; // all 0 unless ok
};

// The nearest lattice point, halves upwards: the greatest integer not above the value and a half.
Answer to_lattice(const osem::Frame& frame, const osem::Point& world) {
    if (!shift_allowed(frame.shift)) return {osem::Status::shift_out_of_range, {}};
    osem::Point lattice{};
    for (int axis = 0; axis < 3; ++axis) {
        const Rational offset(integer(world.at[axis]) - integer(frame.origin[axis]));
        const Integer nearest = floor_of(offset * power_of_two(frame.shift) + power_of_two(-1));
        if (nearest < 0 || nearest > Integer(osem::root_side)) {
            return {osem::Status::point_outside_frame, {}};
        }
        lattice.at[axis] = static_cast<std::int32_t>(to_i64(nearest));
    }
    return {osem::Status::ok, lattice};
}

Answer to_world(const osem::Frame& frame, const osem::Point& lattice) {
    if (!shift_allowed(frame.shift)) return {osem::Status::shift_out_of_range, {}};
    osem::Point world{};
    for (int axis = 0; axis < 3; ++axis) {
        const Rational offset = Rational(integer(lattice.at[axis])) * power_of_two(-frame.shift);
        const std::int64_t value = to_i64(floor_of(offset) + integer(frame.origin[axis]));
        if (!is_i32(value)) return {osem::Status::point_outside_frame, {}};
        world.at[axis] = static_cast<std::int32_t>(value);
    }
    return {osem::Status::ok, world};
}

std::int32_t end_of_i32(Random& random) {
    return random.below(2) == 0 ? INT32_MIN + random.below(2) : INT32_MAX - random.below(2);
}

osem::Frame random_frame(Random& random) {
    constexpr int outside[] = {-128, -32, 21, 127};
    osem::Frame frame{};
    for (std::int32_t& c : frame.origin) {
        switch (random.below(4)) {
        case 0:
            c = 0;
            break;
        case 1:
            c = end_of_i32(random);
            break;
        case 2:
            c = random.between(-(1 << 20), 1 << 20);
            break;
        default:
            c = random.any_i32();
            break;
        }
    }
    frame.shift =
        static_cast<std::int8_t>(random.below(40) == 0 ? outside[random.below(4)] : random.between(-31, 20));
    return frame;
}

// At or beside a middle between two lattice points, or at or beside a lattice point; or at an end of 32 bits.
std::int32_t world_coordinate(Random& random, std::int32_t origin, int shift) {
    if (random.below(24) == 0) return end_of_i32(random);
    if (random.below(24) == 0) return random.any_i32();
    const std::int64_t target = random.coordinate() + (random.below(6) == 0 ? random.between(-1, 1) : 0);
    const int bits = shift_allowed(shift) ? -shift : 0;
    std::int64_t world = origin + random.between(-1, 1);
    if (bits > 0) {
        world += target * (std::int64_t{1} << bits);
        if (random.below(2) == 0) world -= std::int64_t{1} << (bits - 1);
    } else {
        world += target >> -bits;
    }
    return is_i32(world) ? static_cast<std::int32_t>(world) : origin;
}

bool is_end_of_i32(const osem::Point& p) {
    for (const std::int32_t c : p.at) {
        if (c <= INT32_MIN + 1 || c >= INT32_MAX - 1) return true;
    }
    return false;
}

// Some coordinate lies in the middle between two lattice points.
bool is_tie(const osem::Frame& frame, const osem::Point& world) {
    if (!shift_allowed(frame.shift)) return false;
    for (int axis = 0; axis < 3; ++axis) {
        const Rational offset(integer(world.at[axis]) - integer(frame.origin[axis]));
        const Rational twice = offset * power_of_two(frame.shift + 1);
        if (twice.denominator() == 1 && to_i64(twice.numerator()) % 2 != 0) return true;
    }
    return false;
}

void put_answer(Bytes& body, const Answer& answer) {
    body.u8(static_cast<std::uint64_t>(answer.status));
    body.point(answer.point);
}

} // namespace

void write_frame(const std::string& folder) {
    VectorFile file(osem::cross::Topic::frame);
    Random random(15);
    for (int i = 0; i < frames; ++i) {
        const osem::Frame frame = random_frame(random);
        Bytes body;
        for (const std::int32_t c : frame.origin) body.i32(c);
        body.u8(static_cast<std::uint8_t>(frame.shift));
        for (int k = 0; k < points; ++k) {
            osem::Point world{};
            for (int axis = 0; axis < 3; ++axis) {
                world.at[axis] = world_coordinate(random, frame.origin[axis], frame.shift);
            }
            body.point(world);
            put_answer(body, to_lattice(frame, world));
            const osem::Point lattice = random.vertex();
            body.point(lattice);
            put_answer(body, to_world(frame, lattice));
            file.tally().count(is_tie(frame, world),
                               is_end_of_i32(world) ||
                                   is_end_of_i32({{frame.origin[0], frame.origin[1], frame.origin[2]}}));
        }
        file.add_record(std::move(body));
    }
    file.write(folder);
}

} // namespace vectors
