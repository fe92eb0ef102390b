// Codes of octants, two bits each, many at a time.
#ifndef OSEM_STREAM_CODES_HPP
#define OSEM_STREAM_CODES_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace osem {

/// Four bytes as a number, little-endian: written out, so that a compiler sees that it may be one load.
inline std::uint32_t word_at(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

inline void put_word(std::uint8_t* bytes, std::uint32_t word) {
    bytes[0] = static_cast<std::uint8_t>(word);
    bytes[1] = static_cast<std::uint8_t>(word >> 8);
    bytes[2] = static_cast<std::uint8_t>(word >> 16);
    bytes[3] = static_cast<std::uint8_t>(word >> 24);
}

/// As many codes as a register holds.
using Codes = std::conditional_t<sizeof(void*) == 8, std::uint64_t, std::uint32_t>;

/// Bytes that codes_at reads.
constexpr unsigned codes_size = sizeof(Codes);

/// The codes from number `at` on, the first one lowest; at most three are missing of what Codes could hold.
inline Codes codes_at(const std::uint8_t* bytes, unsigned at) {
    bytes += at / 4;
    Codes codes = word_at(bytes);
    if constexpr (codes_size == 8) codes |= static_cast<Codes>(word_at(bytes + 4)) << (codes_size * 4);
    return codes >> (2 * (at % 4));
}

/// The lower bit of each of eight codes that is grey's.
constexpr unsigned grey_codes(unsigned codes) { return (codes >> 1) & ~codes & 0x5555U; }

/// The place of the lowest bit that is set, of bits 0, 2, 4 ... 16; halved.
constexpr unsigned plain_place(unsigned bits) {
    // The factor's top four bits tell the nine powers of four apart.
    constexpr std::uint8_t places[16] = {1, 5, 0, 2, 0, 0, 6, 0, 4, 0, 7, 8, 0, 0, 3, 0};
    return places[(((bits & (0U - bits)) * 0xc386bbc5U) & 0xffffffffU) >> 28];
}

constexpr unsigned lowest_place(unsigned bits) {
#if defined(__ARM_FEATURE_CLZ) || defined(__x86_64__) || defined(__i386__) || defined(__aarch64__)
    return static_cast<unsigned>(__builtin_ctz(bits)) / 2;
#else
    return plain_place(bits);
#endif
}

constexpr bool places_are_right() {
    for (unsigned place = 0; place <= 8; ++place) {
        if (plain_place(1U << (2 * place)) != place) return false;
        if (plain_place(0x15555U & ~((1U << (2 * place)) - 1U)) != place) return false;
    }
    return true;
}
static_assert(places_are_right(), "one entry for each power of four");

/// How many leaves stand in a row: `left`, or fewer when a grey one is among the first eight codes.
constexpr unsigned leaf_run(unsigned codes, unsigned left) {
    return lowest_place(grey_codes(codes) | 1U << (2 * left));
}

/// Codes of the complement, as many as there are: `may` is the even bits, `must` the odd ones, those of a
/// complement are (~must, ~may), and grey stays grey.
constexpr std::uint32_t complemented(std::uint32_t codes) {
    return ~((codes & 0x55555555U) << 1 | (codes >> 1 & 0x55555555U));
}

} // namespace osem

#endif
