// What Boolean operators make of codes of leaves.
#ifndef OSEM_STREAM_CONNECTIVES_HPP
#define OSEM_STREAM_CONNECTIVES_HPP

#include "osem/boolean.hpp"
#include "stream/codes.hpp"

namespace osem {

constexpr std::uint16_t low_bits(std::uint32_t bits) { return static_cast<std::uint16_t>(bits); }

/// Times a code: that code for all children, and more.
constexpr std::uint32_t all_children = 0x55555555U;

/// Kleene's connectives, on as many codes as there are; exclusive or is (a and not b) or (not a and b). In
/// line: calls would be a twentieth of the instructions of a Boolean.
[[gnu::always_inline]] constexpr std::uint32_t connected(Operator op, std::uint32_t a, std::uint32_t b) {
    switch (op) {
    case Operator::unite:
        return a | b;
    case Operator::intersect:
        return a & b;
    case Operator::subtract:
        return a & complemented(b);
    default: // exclusive or
        return (a & complemented(b)) | (complemented(a) & b);
    }
}

/// What becomes of a grey octant beside a leaf of the other operand: a leaf; or it stays grey, and what is
/// below it is connected with the leaf, copied, or inverted.
enum class Becomes : std::uint8_t {
    white = 0,
    boundary = 1,
    connected = 2,
    black = 3,
    copied = 4,
    inverted = 5
};

// unreachable: at run time, as the compiler makes the table.
constexpr Becomes plain_becomes(Operator op, bool leaf_is_a, Colour colour) {
    constexpr std::uint32_t each_leaf = 0b110100;
    constexpr std::uint32_t each_complement = 0b000111;
    const std::uint32_t leaf = 0b010101U * static_cast<std::uint32_t>(colour);
    const std::uint32_t made =
        (leaf_is_a ? connected(op, leaf, each_leaf) : connected(op, each_leaf, leaf)) & 0b111111U;
    if (made == each_leaf) return Becomes::copied;
    if (made == each_complement) return Becomes::inverted;
    return made == (made & 3U) * 0b010101U ? static_cast<Becomes>(made & 3U) : Becomes::connected;
}

/// The same, looked up.
struct BecomesTable {
    // unreachable: at run time, as the compiler asks.
    constexpr BecomesTable() {
        for (unsigned at = 0; at < sizeof of / sizeof *of; ++at) {
            of[at] =
                plain_becomes(static_cast<Operator>(at / 8), at / 4 % 2 != 0, static_cast<Colour>(at % 4));
        }
    }
    Becomes of[32] = {};
};
inline constexpr BecomesTable becomes_table;

[[gnu::always_inline]] inline Becomes becomes_beside_leaf(Operator op, bool leaf_is_a, unsigned code) {
    return becomes_table.of[8 * static_cast<unsigned>(op) + (leaf_is_a ? 4U : 0U) + (code & 3U)];
}

} // namespace osem

#endif
