// Signs of a linear function at the points of a grid, by additions.
//
// Only signs are asked for, at points whose distances are multiples of the octants' side. So values are
// divided by the side first, rounded down: where n steps lead is below 0 before if and only if it is
// afterwards. Steps are then differences of vertices, or components of a normal, whatever the size of the
// octants.
#ifndef OSEM_GRID_LINEAR_HPP
#define OSEM_GRID_LINEAR_HPP

#include <cstdint>

#include "grid/octant_grid.hpp"

namespace osem {

/// Of four values in a row, from `value` by steps of `step`: a bit for each that is below 0. The sign is
/// shifted in, the last one first.
inline unsigned below_zero(std::int32_t value, std::int32_t step) {
    value += 3 * step;
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) {
        bits = bits << 1 | static_cast<std::uint32_t>(value) >> 31;
        value -= step;
    }
    return bits;
}
inline unsigned below_zero(std::int64_t value, std::int64_t step) {
    value += 3 * step;
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) {
        bits = bits << 1 | static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 63);
        value -= step;
    }
    return bits;
}

/// A rectangle of squares.
struct Squares {
    IndexRange u;
    IndexRange v;

    constexpr bool empty() const { return u.empty() || v.empty(); }
    constexpr unsigned all() const { return u.bits() * spread(v.bits()); }
};

/// A linear function over the 4 x 4 squares: a value for each, that of the first one and the steps.
struct SquareFunction {
    std::int32_t value;  ///< at most 2^24 + 2^21
    std::int32_t step_u; ///< at most 2^20
    std::int32_t step_v;

    /// Squares at which it is below 0: among those of the rectangle just these, beside it any.
    unsigned below(const Squares& squares) const {
        // Its extremes stand at corners of the rectangle: mostly they decide for all of it.
        const int rows = squares.v.last - squares.v.first;
        const std::int32_t first = value + squares.u.first * step_u + squares.v.first * step_v;
        const std::int32_t way_u = (squares.u.last - squares.u.first) * step_u;
        const std::int32_t way_v = rows * step_v;
        if (first + (way_u > 0 ? way_u : 0) + (way_v > 0 ? way_v : 0) < 0) return 0xffff;
        if (first + (way_u < 0 ? way_u : 0) + (way_v < 0 ? way_v : 0) >= 0) return 0;
        unsigned set = 0;
        std::int32_t row = first - squares.u.first * step_u + way_v;
        for (int v = rows; v >= 0; --v) {
            set = set << 4 | below_zero(row, step_u);
            row -= step_v;
        }
        return set << (4 * squares.v.first);
    }
};

} // namespace osem

#endif
