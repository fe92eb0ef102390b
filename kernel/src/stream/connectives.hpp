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
[[gnu::always_inline]] inline std::uint32_t connected(Operator op, std::uint32_t a, std::uint32_t b) {
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

} // namespace osem

#endif
