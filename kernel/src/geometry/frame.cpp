#include "osem/frame.hpp"

namespace osem {

namespace {

constexpr int least_shift = -31;
constexpr int greatest_shift = lattice_bits;

bool shift_allowed(const Frame& frame) { return frame.shift >= least_shift && frame.shift <= greatest_shift; }

// |world - origin| < 2^32, so the scaled difference stays below 2^52, and below 2^32 + 2^30 before the
// rounding shift.
std::int64_t scale(std::int64_t difference, int shift) {
    if (shift >= 0) return difference * (std::int64_t{1} << shift);
    return (difference + (std::int64_t{1} << (-shift - 1))) >> -shift;
}

bool map_point(const Frame& frame, const WorldPoint& world, Point& lattice) {
    Point mapped = {};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t difference = std::int64_t{world.at[axis]} - frame.origin[axis];
        const std::int64_t coordinate = scale(difference, frame.shift);
        if (coordinate < 0 || coordinate > root_side) return false;
        mapped.at[axis] = static_cast<std::int32_t>(coordinate);
    }
    lattice = mapped;
    return true;
}

} // namespace

FrameOutcome to_lattice(const Frame& frame, const WorldPoint* world, std::size_t count, Point* lattice) {
    if (!shift_allowed(frame)) return {Status::shift_out_of_range, 0};
    for (std::size_t i = 0; i < count; ++i) {
        if (!map_point(frame, world[i], lattice[i])) return {Status::point_outside_frame, i};
    }
    return {Status::ok, 0};
}

Status to_world(const Frame& frame, const Point& lattice, WorldPoint& world) {
    if (!shift_allowed(frame)) return Status::shift_out_of_range;
    WorldPoint mapped = {};
    for (int axis = 0; axis < 3; ++axis) {
        // A lattice coordinate takes 32 bits at most and the shift is 31 at most: below 2^62.
        const std::int64_t coordinate = lattice.at[axis];
        const std::int64_t offset =
            frame.shift >= 0 ? coordinate >> frame.shift : coordinate * (std::int64_t{1} << -frame.shift);
        const std::int64_t value = offset + frame.origin[axis];
        if (value < INT32_MIN || value > INT32_MAX) return Status::point_outside_frame;
        mapped.at[axis] = static_cast<std::int32_t>(value);
    }
    world = mapped;
    return Status::ok;
}

} // namespace osem
