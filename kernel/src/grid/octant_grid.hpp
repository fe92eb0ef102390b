// A grid of 4 x 4 x 4 octants, two levels below the octant that they make up, and sets of them.
//
// A set is a mask of 64 bits in which octant (i, j, k) is bit i + 4j + 16k. Seen along an axis, the grid is 4
// x 4 squares: bit u + 4v of 16, u and v being the other two axes in ascending order.
#ifndef OSEM_GRID_OCTANT_GRID_HPP
#define OSEM_GRID_OCTANT_GRID_HPP

#include <cstdint>

#include "osem/lattice.hpp"

namespace osem {

/// Where a grid lies, and its reference points: an octant's minimum corner moved by `offset` along each axis,
/// and by (e, e^2, e^3). Precondition: 0 <= offset < 2^shift, so that they are in the open octants.
struct OctantGrid {
    Point corner;
    int shift;           ///< the side of the grid's octants is 2^shift
    std::int32_t offset; ///< of the reference points
    int last;            ///< the last index along each axis: 3, or 1 for a grid of eight octants

    constexpr std::int32_t side() const { return std::int32_t{1} << shift; }
    /// The corner of an octant by its indices.
    constexpr Point at(int i, int j, int k) const {
        return Point{{corner.x() + (i << shift), corner.y() + (j << shift), corner.z() + (k << shift)}};
    }
    /// Its reference point, before it is moved by (e, e^2, e^3).
    constexpr Point reference(int i, int j, int k) const {
        const Point p = at(i, j, k);
        return Point{{p.x() + offset, p.y() + offset, p.z() + offset}};
    }
};

/// A range of indices along one axis, empty when last < first.
struct IndexRange {
    int first;
    int last;

    constexpr bool empty() const { return last < first; }
    /// A bit for each index.
    constexpr unsigned bits() const { return empty() ? 0 : (2U << last) - (1U << first); }
};

/// Four bits moved to places 0, 4, 8, 12.
constexpr unsigned spread(unsigned bits) {
    return (bits & 1U) | ((bits & 2U) << 3) | ((bits & 4U) << 6) | ((bits & 8U) << 9);
}

/// The octants behind a set of squares seen along x, y or z.
constexpr std::uint64_t behind_x(unsigned squares) {
    std::uint64_t set = 0;
    for (unsigned k = 0; k < 4; ++k) {
        set |= std::uint64_t{spread(squares >> (4 * k) & 15U)} * 15U << (16 * k);
    }
    return set;
}
constexpr std::uint64_t behind_y(unsigned squares) {
    std::uint64_t set = 0;
    for (unsigned k = 0; k < 4; ++k) set |= std::uint64_t{squares >> (4 * k) & 15U} * 0x1111U << (16 * k);
    return set;
}
constexpr std::uint64_t behind_z(unsigned squares) { return squares * 0x0001000100010001U; }

/// The octants in a range of indices along each axis.
constexpr std::uint64_t octants_in(const IndexRange (&range)[3]) {
    const unsigned square = range[0].bits() * spread(range[1].bits());
    std::uint64_t set = 0;
    for (unsigned k = 0; k < 4; ++k) {
        if ((range[2].bits() >> k & 1U) != 0) set |= std::uint64_t{square} << (16 * k);
    }
    return set;
}

/// The octants of a set and, over and over, those of `among` beside them: the parts of `among` that it
/// touches by squares.
inline std::uint64_t grown(std::uint64_t set, std::uint64_t among) {
    constexpr std::uint64_t low_x = 0x1111111111111111U; // the octants at the low side of the grid
    constexpr std::uint64_t low_y = 0x000f000f000f000fU;
    for (std::uint64_t before = 0; set != before;) {
        before = set;
        set |= ((set << 1 & ~low_x) | (set >> 1 & ~(low_x << 3))) & among;
        set |= ((set << 4 & ~low_y) | (set >> 4 & ~(low_y << 12))) & among;
        set |= (set << 16 | set >> 16) & among;
    }
    return set;
}

/// The lowest member of a set that is not empty.
constexpr unsigned lowest_of(std::uint64_t set) {
    unsigned place = 0;
    if ((set & 0xffffffffU) == 0) place += 32, set >>= 32;
    if ((set & 0xffffU) == 0) place += 16, set >>= 16;
    if ((set & 0xffU) == 0) place += 8, set >>= 8;
    if ((set & 0xfU) == 0) place += 4, set >>= 4;
    if ((set & 0x3U) == 0) place += 2, set >>= 2;
    return place + ((set & 1U) == 0 ? 1 : 0);
}

/// A set in Morton order: bit 8c + g is child g of child c of the octant that the grid makes up. In a grid of
/// eight octants child g is bit g.
constexpr std::uint64_t in_morton_order(std::uint64_t set) {
    std::uint64_t ordered = 0;
    for (unsigned child = 0; child < 8; ++child) {
        const std::uint64_t part = set >> ((child & 1U) * 2 + (child & 2U) * 4 + (child & 4U) * 8);
        const std::uint64_t children =
            (part & 0x3U) | (part >> 2 & 0xcU) | (part >> 12 & 0x30U) | (part >> 14 & 0xc0U);
        ordered |= children << (8 * child);
    }
    return ordered;
}

/// The place in a set of the octant that is bit `m` in Morton order.
constexpr unsigned place_of(unsigned m) {
    const unsigned child = m >> 3;
    return (m & 1U) + (m & 2U) * 2 + (m & 4U) * 4 + (child & 1U) * 2 + (child & 2U) * 4 + (child & 4U) * 8;
}

} // namespace osem

#endif
