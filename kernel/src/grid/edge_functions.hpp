// A small triangle as seen along an axis of the lattice.
#ifndef OSEM_GRID_EDGE_FUNCTIONS_HPP
#define OSEM_GRID_EDGE_FUNCTIONS_HPP

#include <cstdint>

#include "grid/four.hpp"
#include "grid/small_triangle.hpp"

namespace osem {

/// What a small triangle is seen to have of a grid's points, moved by e along the axis that comes first and
/// by e^2 along the other one, or to meet of its squares.
enum class SeenPlaces { points, squares };

/// A linear function: what it is at a place, and how it changes by an octant's side from there, divided by
/// that side. What it is may have 63 bits; the changes have 32, and are above INT32_MIN.
struct LinearFunction {
    std::int64_t value;
    std::int64_t by_u;
    std::int64_t by_v;
};

/// The triangle has those places where the function of no edge is below 0. A function is linear, so it goes
/// from place to place by one addition; it is divided by the octants' side, rounded down, which leaves its
/// sign. Four rows along u go side by side, from place to place of each; beside each other they are along v.
/// There is room for a fourth function.
template <int u, int v>
class EdgeFunctions {
  public:
    /// Stands at the first places of four rows, of which the very first one is that which the triangle's
    /// corners are told from: a point or a square's lower corner. Area: twice that of the triangle as it is
    /// seen, above 0 if its corners are seen to turn to the left, below if to the right; not 0. It is a
    /// component of its plane's normal, so below 2^62. If it is below 0 the fourth function is negated, of
    /// which the lowest 32 bits are kept. The side is 2^shift, at most 2^18, and the corner less than 64
    /// octants from that place.
    [[gnu::always_inline]] EdgeFunctions(const SmallTriangle& triangle, std::int64_t area, int shift,
                                         SeenPlaces seen, const LinearFunction& fourth = {0, 0, 0}) {
        FourSigned by_u = {};
        FourSigned by_v = {};
        set_sides<v>(by_u, triangle);
        set_sides<u>(by_v, triangle);
        by_u = -by_u;
        by_u[3] = static_cast<std::int32_t>(fourth.by_u);
        by_v[3] = static_cast<std::int32_t>(fourth.by_v);
        const std::int64_t turn = area >> 62; // if it is -1 all are negated
        by_u = (by_u ^ static_cast<std::int32_t>(turn)) - static_cast<std::int32_t>(turn);
        by_v = (by_v ^ static_cast<std::int32_t>(turn)) - static_cast<std::int32_t>(turn);

        FourSigned lowered = ~FourSigned{};
        if (seen == SeenPlaces::points) set_where_leads_out(lowered, by_u, by_v);
        // How far the first place is on the inner side of each edge, times its length: in sum the area.
        const std::int64_t of_first = inside_of(triangle.corner, triangle.to_second);
        const std::int64_t of_third = -inside_of(triangle.corner, triangle.to_third);
        const std::int64_t of_second = area - of_first - of_third;
        FourSigned at = {};
        set_divided(at, {of_first, of_second, of_third, fourth.value}, turn, lowered, shift);
        // Of a square that is said of the corner that is furthest; it is met if that is inside, not if it is
        // on the edge.
        if (seen == SeenPlaces::squares) at += (by_u & ~(by_u >> 31)) + (by_v & ~(by_v >> 31));
        set_rows(reinterpret_cast<Four>(at), reinterpret_cast<Four>(by_v));
        set_each(by_u_, reinterpret_cast<Four>(by_u));
        by_four_rows_ = reinterpret_cast<Four>(by_v) << 2;
    }

    /// Goes on to the next four rows, and stands at their first places.
    void next_four() {
        Four by_four_rows[4];
        set_each(by_four_rows, by_four_rows_);
        for (unsigned k = 0; k < 4; ++k) {
            value_[k] += by_four_rows[k];
            now_[k] = value_[k];
        }
    }
    /// Of the places at which it stands, in its highest bit: whether the triangle does not have it.
    void outside(Four& result) const { result = now_[0] | now_[1] | now_[2]; }
    /// The fourth function there.
    const Four& fourth() const { return now_[3]; }
    void next() {
        for (unsigned k = 0; k < 4; ++k) now_[k] += by_u_[k];
    }

    /// Of each row so many places, 1 to 32, from those on at which it stands: a bit for each that the
    /// triangle has, the first one lowest. It does not stand anywhere then.
    void see(std::uint32_t places, Four& seen) {
        seen = Four{};
        for (std::uint32_t left = places; left != 0; --left, next()) { // the last one is the highest bit
            Four not_had = {};
            outside(not_had);
            seen = seen >> 1 | (~not_had & 0x80000000U);
        }
        seen >>= 32 - places;
    }

  private:
    // Of an edge that runs so far from that corner, or to it the other way.
    [[gnu::always_inline]] static std::int64_t inside_of(const FourSigned& corner, const FourSigned& run) {
        return std::int64_t{corner[place_of_axis(u)]} * run[place_of_axis(v)] -
               std::int64_t{corner[place_of_axis(v)]} * run[place_of_axis(u)];
    }

    // A point on an edge is inside if the movement leads there, not where the step along the first axis is
    // below 0, or it is 0 and the other one is. All bits then, for edges alone.
    [[gnu::always_inline]] static void set_where_leads_out(FourSigned& result, const FourSigned& by_u,
                                                           const FourSigned& by_v) {
        const FourSigned& first = u < v ? by_u : by_v;
        const FourSigned& second = u < v ? by_v : by_u;
        // Of edges twice the first one fits; of the fourth function it may not, which does not matter.
        const Four sum = reinterpret_cast<Four>(first) * 2 + reinterpret_cast<Four>(second >> 31);
        result = reinterpret_cast<FourSigned>(sum) >> 31 & FourSigned{-1, -1, -1, 0};
    }

    // Numbers, negated where all are, and lowered by one where all bits are set, by a power of two; of what
    // comes of that the lowest 32 bits, so that it does not matter whether signs are shifted in.
    struct FourWide {
        std::int64_t at[4];
    };
    [[gnu::always_inline]] static void set_divided(FourSigned& result, const FourWide& numbers,
                                                   std::int64_t turn, const FourSigned& lowered, int shift) {
        FourSigned low[2] = {};
        pick<0, 0, 1, 1>(low[0], lowered, lowered);
        pick<2, 2, 3, 3>(low[1], lowered, lowered);
        for (unsigned k = 0; k < 2; ++k) {
            TwoWide two = {static_cast<std::uint64_t>(numbers.at[2 * k]),
                           static_cast<std::uint64_t>(numbers.at[2 * k + 1])};
            two = (two ^ static_cast<std::uint64_t>(turn)) - static_cast<std::uint64_t>(turn);
            two = (two + reinterpret_cast<TwoWide>(low[k])) >> shift;
            low[k] = reinterpret_cast<FourSigned>(two);
        }
        pick<low_half, low_half + 2, low_half + 4, low_half + 6>(result, low[0], low[1]);
    }

    // All functions at the first places of four rows. Two's complement; those of edges are below 2^30, with
    // steps over as many places and rows as a box has, 20 at most, as the side is 2^18 at most.
    [[gnu::always_inline]] void set_rows(const Four& first, const Four& by_row) {
        const Four second = first + by_row;
        const Four third = second + by_row;
        const Four last = third + by_row;
        Four halves[4] = {};
        pick<0, 4, 1, 5>(halves[0], first, second);
        pick<0, 4, 1, 5>(halves[1], third, last);
        pick<2, 6, 3, 7>(halves[2], first, second);
        pick<2, 6, 3, 7>(halves[3], third, last);
        pick<0, 1, 4, 5>(value_[0], halves[0], halves[1]);
        pick<2, 3, 6, 7>(value_[1], halves[0], halves[1]);
        pick<0, 1, 4, 5>(value_[2], halves[2], halves[3]);
        pick<2, 3, 6, 7>(value_[3], halves[2], halves[3]);
        for (unsigned k = 0; k < 4; ++k) now_[k] = value_[k];
    }

    Four value_[4] = {}; ///< at the first places of these four rows
    Four now_[4] = {};
    Four by_u_[4] = {};
    Four by_four_rows_ = {}; ///< a number for each function
};

} // namespace osem

#endif
