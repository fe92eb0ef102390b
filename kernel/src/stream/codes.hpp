// Codes of octants, two bits each, many at a time.
#ifndef OSEM_STREAM_CODES_HPP
#define OSEM_STREAM_CODES_HPP

#include <cstddef>
#include <cstdint>

#include "osem/node_pool.hpp"
#include "osem/register_word.hpp"
#include "tree/zeros.hpp"

namespace osem {

/// As many codes as a register holds, two bits each, the first one lowest.
using Codes = RegisterWord;

/// Four bytes as a number, little-endian: written out, so that a compiler sees that it may be one load. A
/// call would take longer.
[[gnu::always_inline]] inline std::uint32_t word_at(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

/// Bytes that codes_at reads, and the bits and codes that they hold.
constexpr unsigned codes_size = sizeof(Codes);
constexpr unsigned codes_bits = 8 * codes_size;
constexpr unsigned codes_count = 4 * codes_size;

/// Codes that are in the buffer of a stream behind each at which one may go on: seven leaves, a grey octant
/// and its children.
constexpr unsigned codes_ahead = 16;

/// The codes from a bit on, the first one lowest; at most three are missing of what Codes could hold. A
/// call would take longer, and as much room.
[[gnu::always_inline]] inline Codes codes_at(const std::uint8_t* bytes, unsigned bit) {
    bytes += bit / 8;
    Codes codes = word_at(bytes);
    if constexpr (codes_size == 8) codes |= static_cast<Codes>(word_at(bytes + 4)) << (codes_size * 4);
    return codes >> (bit % 8);
}

/// The same with none missing; reads a byte more.
[[gnu::always_inline]] inline Codes all_codes_at(const std::uint8_t* bytes, unsigned bit) {
    const Codes last = bytes[bit / 8 + codes_size];
    return codes_at(bytes, bit) | last << (8 * codes_size - 8) << (8 - bit % 8);
}

/// One of two. Where registers are wide it is no branch: which one cannot be guessed where surfaces meet, and
/// a wrong guess takes longer than both.
template <class Number>
[[gnu::always_inline]] constexpr Number chosen(bool condition, Number yes, Number no) {
    if constexpr (!has_wide_registers) return condition ? yes : no;
    const Number mask = Number{0} - static_cast<Number>(condition);
    return (yes & mask) | (no & ~mask);
}

/// The lower bit of each code that is grey's.
constexpr Codes grey_codes(Codes codes) {
    return (codes >> 1) & ~codes & static_cast<Codes>(0x5555555555555555U);
}

/// The number of the lowest bit that is set, of bits 0, 2, 4 ... 16.
constexpr unsigned plain_lowest_bit(unsigned bits) {
    // The factor's top four bits tell the nine powers of four apart.
    constexpr std::uint8_t numbers[16] = {2, 10, 0, 4, 0, 0, 12, 0, 8, 0, 14, 16, 0, 0, 6, 0};
    return numbers[(((bits & (0U - bits)) * 0xc386bbc5U) & 0xffffffffU) >> 28];
}

constexpr unsigned lowest_bit(unsigned bits) {
#if OSEM_COUNTS_ZEROS
    return static_cast<unsigned>(__builtin_ctz(bits));
#else
    return plain_lowest_bit(bits);
#endif
}

// unreachable: at run time, as the compiler asks.
constexpr bool numbers_are_right() {
    for (unsigned number = 0; number <= 16; number += 2) {
        if (plain_lowest_bit(1U << number) != number) return false;
        if (plain_lowest_bit(0x15555U & ~((1U << number) - 1U)) != number) return false;
    }
    return true;
}
static_assert(numbers_are_right(), "one entry for each power of four");

/// The bits of the leaves that stand in a row, at most `left`, which is up to 16.
constexpr unsigned leaf_bits(Codes greys, unsigned left) {
    return lowest_bit(static_cast<unsigned>(greys) | 1U << left);
}

/// Whether none of the next eight codes is grey, and whether they are eight times the same.
constexpr bool eight_leaves(Codes greys) { return (greys & 0xffffU) == 0; }
constexpr bool eight_alike(Codes codes) { return ((codes ^ (codes & 3U) * 0x5555U) & 0xffffU) == 0; }

/// Groups of eight codes in a row, whichever octants they are of, as many as Codes holds, side by side in
/// sixteen bits each.
class CodeGroups {
  public:
    static constexpr unsigned count = codes_size / 2;

    // Each step adds neighbours; the product then adds up all bytes before one, and itself.
    explicit CodeGroups(Codes codes) {
        constexpr auto twos = static_cast<Codes>(0x3333333333333333U);
        constexpr auto fours = static_cast<Codes>(0x0f0f0f0f0f0f0f0fU);
        Codes found = grey_codes(codes);
        found = (found + (found >> 2)) & twos;
        found = (found + (found >> 4)) & fours;
        greys_ = found * (ones | ones << 8);
    }

    /// How many of the first `ready` groups end what so many are to come of, each grey code one more: all, if
    /// they do not. Precondition: to_come is in [1, 96]; of a tree's codes there are never more groups to
    /// come than octants open, 20.
    unsigned to_end(std::uint32_t to_come, unsigned ready) const {
        const Codes ends = ends_of(to_come);
        if (ends == 0) return ready;
        const unsigned end = lowest_end(ends);
        return end < ready ? end : ready;
    }

    /// Whether any of all groups ends it.
    bool any_ends(std::uint32_t to_come) const { return ends_of(to_come) != 0; }

    /// Grey codes of the first `groups`, at least one.
    unsigned greys(unsigned groups) const {
        return static_cast<unsigned>(greys_ >> (16 * groups - 8) & 0xffU);
    }

  private:
    // The number of the first group that has its sign set, from 1 on.
    static unsigned lowest_end(Codes ends) {
#if OSEM_COUNTS_ZEROS
        const int zeros =
            codes_size == 8 ? __builtin_ctzll(ends) : __builtin_ctz(static_cast<unsigned>(ends));
        return static_cast<unsigned>(zeros) / 16 + 1;
#else
        unsigned end = 1;
        for (ends >>= 15; (ends & 1U) == 0; ends >>= 16) ++end;
        return end;
#endif
    }

    static constexpr auto ones = static_cast<Codes>(0x0001000100010001U);

    // What is to come behind each group, less one, in its upper byte: of that the sign.
    Codes ends_of(std::uint32_t to_come) const {
        return (greys_ + (ones << 8) * to_come - static_cast<Codes>(0x0500040003000200U)) & ones << 15;
    }

    Codes greys_; ///< in the upper byte of each group: of the first one, of the first two, and so on
};

/// Codes of the complement, as many as there are: `may` is the even bits, `must` the odd ones, those of a
/// complement are (~must, ~may), and grey stays grey.
template <class Bits>
constexpr Bits complemented(Bits codes) {
    constexpr auto evens = static_cast<Bits>(0x5555555555555555U);
    return ~((codes & evens) << 1 | (codes >> 1 & evens));
}

/// The bits of a mask, each two places from the one before.
constexpr std::uint32_t spread(std::uint32_t mask) {
    mask = (mask | mask << 4) & 0x0f0fU;
    mask = (mask | mask << 2) & 0x3333U;
    return (mask | mask << 1) & 0x5555U;
}

/// Every second one of 16 bits, from the lowest on.
constexpr std::uint8_t gathered(std::uint32_t bits) {
    bits &= 0x5555U;
    bits = (bits | bits >> 1) & 0x3333U;
    bits = (bits | bits >> 2) & 0x0f0fU;
    return static_cast<std::uint8_t>(bits | bits >> 4);
}

/// The codes of a node's children, and the masks of eight codes.
constexpr std::uint32_t codes_of_node(const Node& node) { return spread(node.may) | spread(node.must) << 1; }
constexpr std::uint8_t may_of(std::uint32_t codes) { return gathered(codes); }
constexpr std::uint8_t must_of(std::uint32_t codes) { return gathered(codes >> 1); }

} // namespace osem

#endif
