// Small operations on masks of the eight children.
#ifndef OSEM_TREE_MASKS_HPP
#define OSEM_TREE_MASKS_HPP

#include "osem/node_pool.hpp"
#include "tree/zeros.hpp"

namespace osem {

/// The children on the low side of an axis; the others are on its high side.
constexpr std::uint8_t low_children[3] = {0x55, 0x33, 0x0f};

/// True when member k is in a mask; the parameter's type keeps the shift unsigned.
constexpr bool contains(std::uint32_t mask, unsigned k) { return (mask >> k & 1U) != 0; }

/// The lowest child in a mask, as the number of bits below it: for parts that do not count zeros themselves.
constexpr unsigned plain_lowest(std::uint8_t mask) {
    return count_bits(
        static_cast<std::uint8_t>(static_cast<std::uint8_t>(mask - 1U) & static_cast<std::uint8_t>(~mask)));
}

/// The lowest child in a mask. Precondition: mask != 0.
constexpr unsigned lowest(std::uint8_t mask) {
#if OSEM_COUNTS_ZEROS
    return static_cast<unsigned>(__builtin_ctz(mask));
#else
    return plain_lowest(mask);
#endif
}

constexpr std::uint8_t without_lowest(std::uint8_t mask) {
    return static_cast<std::uint8_t>(mask & (mask - 1U));
}

/// Bytes of a set as members of a mask, by their lowest bits: byte c has the power 8c and is multiplied by
/// that of 56 - 7c, so that it comes to 56 + c; no two products coincide, so there are no carries.
constexpr std::uint8_t lowest_of_bytes(std::uint64_t set) {
    return static_cast<std::uint8_t>((set & 0x0101010101010101) * 0x0102040810204080 >> 56);
}

/// The members 8 child to 8 child + 7 of a set in Morton order.
constexpr std::uint8_t children_of(std::uint64_t set, unsigned child) {
    return static_cast<std::uint8_t>(set >> (8 * child));
}

/// Sets the two bits of one child to a colour.
inline void assign_colour(std::uint8_t& may, std::uint8_t& must, unsigned child, Colour colour) {
    const unsigned bits = static_cast<unsigned>(colour);
    const unsigned others = ~(1U << child);
    may = static_cast<std::uint8_t>((may & others) | ((bits & 1U) << child));
    must = static_cast<std::uint8_t>((must & others) | ((bits >> 1) << child));
}

/// The children of one colour.
constexpr std::uint8_t whites(const Node& node) { return static_cast<std::uint8_t>(~node.may & ~node.must); }
constexpr std::uint8_t blacks(const Node& node) { return static_cast<std::uint8_t>(node.may & node.must); }
constexpr std::uint8_t boundaries(const Node& node) {
    return static_cast<std::uint8_t>(node.may & ~node.must);
}

} // namespace osem

#endif
