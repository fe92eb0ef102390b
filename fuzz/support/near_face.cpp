#include "support/near_face.hpp"

namespace osem::fuzz {

namespace {

std::int32_t on_lattice(std::int64_t c) {
    return static_cast<std::int32_t>(c < 0 ? 0 : c > root_side ? root_side : c);
}

std::int32_t near_coordinate(const Octant& octant, int axis, Choices& choices) {
    const std::int64_t low = octant.corner.at[axis];
    const std::int64_t side = octant.side();
    const std::uint8_t kind = choices.byte();
    switch (kind >> 5) {
    case 0:
        return on_lattice(low + side / 2 * (kind % 9 - 3) + choices.between(-1, 1));
    case 1:
        return on_lattice(low + side * (kind % 3 - 1) + choices.between(0, octant.side()));
    case 2:
        return kind % 2 == 0 ? 0 : root_side;
    case 3:
        return choices.between(0, root_side);
    default:
        return on_lattice(low + side / 2 * (kind % 9 - 3));
    }
}

// origin + i u + j v: on one plane whatever i and j are.
struct Span {
    Point origin;
    Point u;
    Point v;
    /// The origin where the point is off the lattice.
    Point at(int i, int j) const {
        Point p = {};
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t c =
                std::int64_t{origin.at[axis]} + std::int64_t{i} * u.at[axis] + std::int64_t{j} * v.at[axis];
            if (c < 0 || c > root_side) return origin;
            p.at[axis] = static_cast<std::int32_t>(c);
        }
        return p;
    }
};

Point any_step(std::int32_t unit, Choices& choices) {
    Point step = {};
    for (std::int32_t& at : step.at) {
        at = choices.below(3) == 0 ? choices.between(-unit, unit) : unit * choices.between(-2, 2);
    }
    return step;
}

tests::Polygon ring_on(const Span& span, Choices& choices) {
    tests::Polygon ring;
    const unsigned corners = 3 + choices.below(6);
    for (unsigned i = 0; i < corners; ++i) {
        const std::int32_t along = choices.between(-3, 4);
        ring.push_back(span.at(along, choices.between(-3, 4)));
    }
    return ring;
}

tests::Polygon axis_ring(const Octant& octant, int axis, std::int32_t height, Choices& choices) {
    tests::Polygon ring;
    const unsigned corners = 3 + choices.below(6);
    for (unsigned i = 0; i < corners; ++i) {
        ring.push_back(near_point(octant, choices));
        ring.back().at[axis] = height;
    }
    return ring;
}

} // namespace

Octant any_octant(Choices& choices) {
    Octant octant = {{{0, 0, 0}}, static_cast<std::uint8_t>(choices.below(max_depth + 1))};
    for (std::int32_t& at : octant.corner.at) {
        const std::int32_t last = (1 << octant.level) - 1;
        at = choices.between(0, last) * octant.side();
    }
    return octant;
}

Point near_point(const Octant& octant, Choices& choices) {
    Point p = {};
    for (int axis = 0; axis < 3; ++axis) p.at[axis] = near_coordinate(octant, axis, choices);
    return p;
}

tests::SmallSolid near_face(const Octant& octant, Choices& choices) {
    tests::SmallSolid solid;
    const std::uint32_t kind = choices.below(8);
    const std::uint32_t rings = kind < 3 ? 1 : 1 + choices.below(3);
    std::vector<tests::Polygon> face;
    if (kind < 3) {
        face.push_back(
            {near_point(octant, choices), near_point(octant, choices), near_point(octant, choices)});
    } else if (kind == 3) {
        const Point middle = near_point(octant, choices);
        face.push_back({near_point(octant, choices), middle, near_point(octant, choices), middle});
    } else if (kind < 6) {
        const std::int32_t unit = octant.side() > 1 && choices.flag() ? octant.side() / 2 : octant.side();
        const Span span = {near_point(octant, choices), any_step(unit, choices), any_step(unit, choices)};
        for (std::uint32_t i = 0; i < rings; ++i) face.push_back(ring_on(span, choices));
    } else {
        const auto axis = static_cast<int>(choices.below(3));
        const std::int32_t height = near_coordinate(octant, axis, choices);
        for (std::uint32_t i = 0; i < rings; ++i) face.push_back(axis_ring(octant, axis, height, choices));
    }
    solid.add_face(face);
    return solid;
}

} // namespace osem::fuzz
