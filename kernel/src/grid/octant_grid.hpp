// Grids of octants that make up an octant some levels above, and sets of them.
//
// A set is kept in rows along x: octant (i, j, k) is bit i of word j + side * k. A set of 64 is one mask in
// which it is bit i + 4j + 16k.
#ifndef OSEM_GRID_OCTANT_GRID_HPP
#define OSEM_GRID_OCTANT_GRID_HPP

#include <cstddef>
#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/register_word.hpp"
#include "tree/zeros.hpp"

namespace osem {

constexpr int least(int a, int b) { return a < b ? a : b; }
constexpr int greatest(int a, int b) { return a > b ? a : b; }

constexpr int clipped(std::int32_t index, int first, int last) {
    const int not_above = index < last ? static_cast<int>(index) : last;
    return not_above > first ? not_above : first;
}

/// A bit for each number from first to last in a word. Precondition: first <= last; of both the lowest five
/// bits count.
constexpr std::uint32_t bits_between(unsigned first, unsigned last) {
    return (std::uint32_t{2} << (last & 31U)) - (std::uint32_t{1} << (first & 31U));
}

/// A range of indices along one axis, empty when last < first.
struct IndexRange {
    int first;
    int last;

    constexpr bool empty() const { return last < first; }
    constexpr std::uint32_t count() const { return static_cast<std::uint32_t>(last + 1 - first); }
    /// A bit for each index. Precondition: not empty, and within a word.
    [[gnu::always_inline]] constexpr std::uint32_t bits() const {
        return bits_between(static_cast<unsigned>(first), static_cast<unsigned>(last));
    }
    /// The same, and none for an empty range.
    [[gnu::always_inline]] constexpr std::uint32_t bits_or_none() const { return empty() ? 0 : bits(); }
};

/// Where a grid lies, and its reference points: an octant's minimum corner moved by `offset` along each axis,
/// and by (e, e^2, e^3). Precondition: 0 <= offset < 2^shift, so that they are in the open octants.
struct OctantGrid {
    Point corner;
    int shift;           ///< the side of the grid's octants is 2^shift
    std::int32_t offset; ///< of the reference points
    int levels;          ///< 2^levels octants stand along each axis; 1 to 5, so that a row is a word

    constexpr std::int32_t length() const { return std::int32_t{1} << shift; } ///< of an octant's side
    constexpr int side() const { return 1 << levels; }
    constexpr int rows() const { return 1 << (2 * levels); }
    constexpr int row(int j, int k) const { return j + (k << levels); }
    /// The corner of an octant by its indices.
    constexpr Point at(int i, int j, int k) const {
        return Point{{corner.x() + (i << shift), corner.y() + (j << shift), corner.z() + (k << shift)}};
    }
    /// The reference point of an octant by its indices, before it is moved by (e, e^2, e^3).
    constexpr Point point(int i, int j, int k) const {
        const Point low = at(i, j, k);
        return Point{{low.x() + offset, low.y() + offset, low.z() + offset}};
    }
    /// That of the first octant: written out, as its shifts by 0 took a hundredth of a conversion's
    /// instructions where a compiler saves room.
    constexpr Point reference() const {
        return Point{{corner.x() + offset, corner.y() + offset, corner.z() + offset}};
    }
    /// The reference points along an axis between two coordinates: moved by an infinitesimal, they are above
    /// one with which they are level. There may be none: then it is told all the same where the two lie.
    constexpr IndexRange points_between(int axis, std::int32_t low, std::int32_t high) const {
        const std::int32_t first = corner.at[axis] + offset;
        return {clipped((low - first + length() - 1) >> shift, 0, side()),
                clipped((high - 1 - first) >> shift, -1, side() - 1)};
    }
};

/// Four rows beside each other at a time: how many fours a range of rows takes, and where the first one
/// begins for all of them to be in a grid.
constexpr int fours_of(const IndexRange& rows) { return (rows.last - rows.first + 4) / 4; }
constexpr int first_of_fours(const IndexRange& rows, int side) {
    return least(rows.first, side - 4 * fours_of(rows));
}

/// Whether a point on a plane, moved by (e, e^2, e^3) as reference points are, comes to be where its normal
/// points away from: the first component that is not 0 decides.
constexpr bool moves_against(std::int64_t normal_x, std::int64_t normal_y, std::int64_t normal_z) {
    return (normal_x != 0 ? normal_x : normal_y != 0 ? normal_y : normal_z) < 0;
}

constexpr IndexRange common(const IndexRange& a, const IndexRange& b) {
    return {a.first > b.first ? a.first : b.first, a.last < b.last ? a.last : b.last};
}

/// Two rows as one word, the first one lowest.
inline std::uint64_t two_rows(const std::uint32_t* row) { return row[0] | std::uint64_t{row[1]} << 32; }

/// All octants of a grid of one or two levels, as one mask.
inline std::uint64_t as_mask(const std::uint32_t* row, int levels) {
    if (levels == 1) return (row[0] & 3U) | (row[1] & 3U) << 4 | (row[2] & 3U) << 16 | (row[3] & 3U) << 20;
    std::uint64_t set = 0;
    constexpr std::uint64_t of_two = 0x0000000f0000000f;
    for (unsigned k = 0; k < 4; ++k, row += 4) {
        const std::uint64_t layer = (two_rows(row) & of_two) | (two_rows(row + 2) & of_two) << 8;
        set = set >> 16 | (layer | layer >> 28) << 48;
    }
    return set;
}

/// The lowest member of a set that is not empty, for parts that do not count zeros themselves.
constexpr unsigned plain_lowest_of(std::uint64_t set) {
    unsigned place = 0;
    if ((set & 0xffffffffU) == 0) place += 32, set >>= 32;
    if ((set & 0xffffU) == 0) place += 16, set >>= 16;
    if ((set & 0xffU) == 0) place += 8, set >>= 8;
    if ((set & 0xfU) == 0) place += 4, set >>= 4;
    if ((set & 0x3U) == 0) place += 2, set >>= 2;
    return place + ((set & 1U) == 0 ? 1 : 0);
}

/// The lowest member of a set that is not empty.
constexpr unsigned lowest_of(std::uint64_t set) {
#if OSEM_COUNTS_ZEROS
    const auto low = static_cast<std::uint32_t>(set); // a word at a time, as no part calls a function for one
    return static_cast<unsigned>(low != 0 ? __builtin_ctz(low)
                                          : 32 + __builtin_ctz(static_cast<std::uint32_t>(set >> 32)));
#else
    return plain_lowest_of(set);
#endif
}

/// Exchanges two bits of the numbers of a set's members: those with the low one alone, which are named, move
/// up by the difference of what the bits stand for, those with the high one alone move down.
constexpr std::uint64_t with_bits_exchanged(std::uint64_t set, std::uint64_t low_alone, unsigned difference) {
    const std::uint64_t changes = (set ^ set >> difference) & low_alone;
    return set ^ changes ^ changes << difference;
}

/// A set in Morton order: bit 8c + g is child g of child c of the octant that the grid makes up. In a grid of
/// eight octants child g is bit g. Numbers are (k1 k0 j1 j0 i1 i0) and become (k1 j1 i1 k0 j0 i0).
constexpr std::uint64_t in_morton_order(std::uint64_t set) {
    set = with_bits_exchanged(set, 0x0c0c0c0c0c0c0c0c, 2);
    set = with_bits_exchanged(set, 0x0000ff000000ff00, 8);
    return with_bits_exchanged(set, 0x00f000f000f000f0, 4);
}

/// Exchanges a bit of the numbers of two sets' members, by which those of the second one have `difference`
/// more, with the bit that tells the sets apart. Those without it are named.
inline void exchange_between(std::uint64_t& set, std::uint64_t& other, std::uint64_t without,
                             unsigned difference) {
    const std::uint64_t changes = (set >> difference ^ other) & without;
    set ^= changes << difference;
    other ^= changes;
}

/// A part of 8 x 8 x 8 octants of a grid, as one set in Morton order for each of its eight children. The row
/// is that of its first octant, which is octant x of it.
inline void eight_in_morton_order(const std::uint32_t* row, unsigned x, int levels,
                                  std::uint64_t (&sets)[8]) {
    // Numbers are (k2 k1 k0), of the set, and (j0 j1 j2 i2 i1 i0): so it is two rows at a time.
    const auto two = [row, x](std::size_t j) {
        if constexpr (has_wide_registers) { // as one holds both
            return two_rows(row + j) >> x & 0x000000ff000000ff;
        } else {
            return (row[j] >> x & 0xffU) | std::uint64_t{row[j + 1] >> x & 0xffU} << 32;
        }
    };
    for (std::size_t k = 0; k < 8; ++k) {
        const std::size_t j = k << levels;
        sets[k] = two(j) | two(j + 4) << 8 | two(j + 2) << 16 | two(j + 6) << 24;
    }
    for (unsigned k = 0; k < 4; ++k) {
        const unsigned low = k + (k & 2U);
        exchange_between(sets[low], sets[low + 2], 0x00ff00ff00ff00ff, 8);
    }
    for (unsigned k = 0; k < 8; k += 2) exchange_between(sets[k], sets[k + 1], 0x0f0f0f0f0f0f0f0f, 4);
    // They are (k2 j2 i2) and (j0 j1 k1 k0 i1 i0), and become (k2 j2 i2) and (k1 j1 i1 k0 j0 i0).
    for (std::uint64_t& set : sets) {
        set = with_bits_exchanged(set, 0x00000000ff00ff00, 24);
        set = with_bits_exchanged(set, 0x00cc00cc00cc00cc, 6);
    }
}

/// The place in a mask of the octant that is bit `m` in Morton order.
constexpr unsigned place_of(unsigned m) {
    const unsigned child = m >> 3;
    return (m & 1U) + (m & 2U) * 2 + (m & 4U) * 4 + (child & 1U) * 2 + (child & 2U) * 4 + (child & 4U) * 8;
}

// unreachable: at run time, as the compiler asks.
constexpr bool places_are_right() {
    for (unsigned m = 0; m < 64; ++m) {
        if (in_morton_order(std::uint64_t{1} << place_of(m)) != std::uint64_t{1} << m) return false;
    }
    return true;
}
static_assert(places_are_right(), "the order and the places in it belong together");

} // namespace osem

#endif
