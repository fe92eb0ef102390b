// What queries have to answer, found by arithmetic on single leaves or cells.
#ifndef OSEM_SUPPORT_QUERY_ORACLES_HPP
#define OSEM_SUPPORT_QUERY_ORACLES_HPP

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "osem/collide.hpp"
#include "osem/nearest.hpp"
#include "osem/neighbour.hpp"
#include "osem/ray.hpp"
#include "support/dense_grid.hpp"

namespace osem::tests {

// Segments. Their coordinates are counted in units of a sixteenth of the root, the cells of a grid of
// depth 4.
constexpr std::int32_t unit = root_side / 16;

inline Point in_units(const Point& p) { return {{p.x() * unit, p.y() * unit, p.z() * unit}}; }

// A segment is moved by (e, e^2, e^3) with e = 1 / 4096: differences of parameters of segments up to 64 units
// long are 0 or at least 1 / 64^2, and e^(k + 1) / e^k is below 1 / 64. Times are t * 4096^3.
constexpr std::int64_t per_unit = std::int64_t{1} << 36;
constexpr std::int64_t moved_by[3] = {std::int64_t{1} << 24, std::int64_t{1} << 12, 1};

struct Time {
    std::int64_t numerator;
    std::int64_t denominator; ///< above 0
    int axis;                 ///< of the plane met then; -1 at an end of the segment
    Parameter unmoved;
    bool operator<(const Time& other) const {
        return numerator * other.denominator < other.numerator * denominator;
    }
};

/// When a segment is in a leaf.
struct Stay {
    Leaf leaf;
    Time entry;
    Time exit;
};

inline Time time_of(std::int32_t plane, std::int32_t from, std::int32_t length, int axis) {
    const std::int64_t sign = length < 0 ? -1 : 1;
    const auto step = static_cast<std::int32_t>(sign);
    return {sign * (plane * per_unit - from * per_unit - moved_by[axis]), sign * length, axis,
            Parameter{step * (plane - from), step * length}};
}

/// When the segment from p to q (in units) is in the open leaf; false when it never is.
inline bool stay_in(const Leaf& leaf, const Point& p, const Point& q, Stay& stay) {
    stay = {leaf, {0, 1, -1, {0, 1}}, {per_unit, 1, -1, {1, 1}}};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t low = leaf.octant.corner.at[axis] / unit;
        const std::int32_t high = low + leaf.octant.side() / unit;
        const std::int32_t length = q.at[axis] - p.at[axis];
        if (length == 0) {
            if (p.at[axis] < low || p.at[axis] >= high) return false;
            continue;
        }
        Time in = time_of(low, p.at[axis], length, axis);
        Time out = time_of(high, p.at[axis], length, axis);
        if (length < 0) std::swap(in, out);
        if (stay.entry < in) stay.entry = in;
        if (out < stay.exit) stay.exit = out;
    }
    return stay.entry < stay.exit;
}

/// The stays in leaves that fill the root, in the order of time.
inline std::vector<Stay> expected_stays(const std::vector<Leaf>& leaves, const Point& p, const Point& q) {
    std::vector<Stay> stays;
    Stay stay = {};
    for (const Leaf& leaf : leaves) {
        if (stay_in(leaf, p, q, stay)) stays.push_back(stay);
    }
    std::sort(stays.begin(), stays.end(), [](const Stay& a, const Stay& b) { return a.entry < b.entry; });
    return stays;
}

/// The colour changes along the stays, the white around the root included.
inline std::vector<Crossing> expected_crossings(const std::vector<Stay>& stays) {
    std::vector<Crossing> crossings;
    Colour before = Colour::white;
    for (const Stay& stay : stays) {
        if (stay.entry.axis >= 0 && stay.leaf.colour != before) {
            crossings.push_back({stay.entry.unmoved, static_cast<Axis>(stay.entry.axis), before,
                                 stay.leaf.colour, stay.leaf});
        }
        before = stay.leaf.colour;
    }
    if (!stays.empty() && stays.back().exit.axis >= 0 && before != Colour::white) {
        crossings.push_back({stays.back().exit.unmoved, static_cast<Axis>(stays.back().exit.axis), before,
                             Colour::white, Leaf{root_octant, Colour::white}});
    }
    return crossings;
}

/// The cells of a grid whose colour is in a set, as leaves.
inline std::vector<Leaf> cells_of(const DenseGrid& grid, unsigned colours) {
    std::vector<Leaf> cells;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        if (((colours >> static_cast<unsigned>(grid[cell])) & 1U) == 0) continue;
        cells.push_back({{grid.corner(cell), static_cast<std::uint8_t>(grid.depth())}, grid[cell]});
    }
    return cells;
}

/// The squared distance between a closed box and a closed octant.
inline std::uint64_t distance_to(const Octant& octant, const CellBox& box) {
    std::uint64_t sum = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int64_t low = octant.corner.at[axis];
        const std::int64_t high = low + octant.side();
        std::int64_t gap = 0;
        if (box.high.at[axis] < low) gap = low - box.high.at[axis];
        if (box.low.at[axis] > high) gap = box.low.at[axis] - high;
        sum += static_cast<std::uint64_t>(gap * gap);
    }
    return sum;
}

struct Nearest {
    bool found = false;
    Point corner = {{0, 0, 0}}; ///< of the cell, the first in Morton order
    std::uint64_t distance = 0;
};

inline Nearest expected_nearest(const std::vector<Leaf>& cells, const CellBox& box) {
    Nearest nearest;
    for (const Leaf& cell : cells) {
        const std::uint64_t distance = distance_to(cell.octant, box);
        if (!nearest.found || distance < nearest.distance) nearest = {true, cell.octant.corner, distance};
    }
    return nearest;
}

/// How two leaves meet, b's moved by the offset.
inline Contact contact_of(const Leaf& a, const Leaf& b, const Point& offset) {
    if (a.colour == Colour::white || b.colour == Colour::white) return Contact::clear;
    bool overlap = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int64_t low_a = a.octant.corner.at[axis];
        const std::int64_t low_b = std::int64_t{b.octant.corner.at[axis]} + offset.at[axis];
        const std::int64_t high_a = low_a + a.octant.side();
        const std::int64_t high_b = low_b + b.octant.side();
        if (low_a > high_b || low_b > high_a) return Contact::clear;
        overlap = overlap && low_a < high_b && low_b < high_a;
    }
    if (!overlap) return Contact::touch;
    return a.colour == Colour::black && b.colour == Colour::black ? Contact::certain : Contact::possible;
}

inline Contact expected_contact(const std::vector<Leaf>& a, const std::vector<Leaf>& b, const Point& offset) {
    Contact strongest = Contact::clear;
    for (const Leaf& of_a : a) {
        for (const Leaf& of_b : b) strongest = std::max(strongest, contact_of(of_a, of_b, offset));
    }
    return strongest;
}

/// Whether the other octant has cells beyond the face and along it.
inline bool is_beyond(const Octant& octant, OctantFace face, const Octant& other) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t low = octant.corner.at[axis];
        const std::int32_t high = low + octant.side();
        const std::int32_t other_low = other.corner.at[axis];
        const std::int32_t other_high = other_low + other.side();
        if (axis != face.axis && (other_low >= high || other_high <= low)) return false;
        if (axis == face.axis && face.high && (other_low > high || other_high <= high)) return false;
        if (axis == face.axis && !face.high && (other_low >= low || other_high < low)) return false;
    }
    return true;
}

} // namespace osem::tests

#endif
