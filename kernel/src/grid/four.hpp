// Four numbers side by side, as GCC and Clang have them: in one register of parts that have such ones, else
// in four.
#ifndef OSEM_GRID_FOUR_HPP
#define OSEM_GRID_FOUR_HPP

#include <cstdint>

#include "osem/lattice.hpp"

namespace osem {

using Four [[gnu::vector_size(16)]] = std::uint32_t;
using FourSigned [[gnu::vector_size(16)]] = std::int32_t;
using TwoWide [[gnu::vector_size(16)]] = std::uint64_t; ///< the same bits, two numbers in each

/// All bits for each number that is below 0 in two's complement, none for others. By reference, as how a
/// function gets and gives vectors depends on what registers the part has.
inline void set_where_negative(Four& result, const Four& numbers) {
    result = reinterpret_cast<Four>(reinterpret_cast<FourSigned>(numbers) < 0);
}

/// The same for each number that is below another one, both in two's complement.
inline void set_where_below(Four& result, const Four& numbers, const Four& others) {
    result =
        reinterpret_cast<Four>(reinterpret_cast<FourSigned>(numbers) < reinterpret_cast<FourSigned>(others));
}

/// The same for each of the lowest four bits that is set.
inline void set_where_has(Four& result, std::uint32_t bits) {
    result = reinterpret_cast<Four>(((Four{} + bits) & Four{1, 2, 4, 8}) != 0);
}

/// 0, 1, 2 and 3 times a number, of which there are four.
inline void set_multiples(Four& result, const Four& number) {
    result = (number & Four{0, ~0U, 0, ~0U}) + ((number + number) & Four{0, 0, ~0U, ~0U});
}

/// Others in the place of those numbers for which a comparison was true.
[[gnu::always_inline]] inline void choose(FourSigned& numbers, const FourSigned& where,
                                          const FourSigned& others) {
    numbers = (others & where) | (numbers & ~where);
}

/// The lower ones of numbers and others, and the greater ones.
[[gnu::always_inline]] inline void lower(FourSigned& numbers, const FourSigned& others) {
    choose(numbers, others < numbers, others);
}
[[gnu::always_inline]] inline void raise(FourSigned& numbers, const FourSigned& others) {
    choose(numbers, others > numbers, others);
}

/// Whether one of them is not 0 at least.
inline bool any(const Four& numbers) {
    const auto two = reinterpret_cast<TwoWide>(numbers);
    return (two[0] | two[1]) != 0;
}

/// Whether one of them is below 0 at least.
inline bool any_negative(const FourSigned& numbers) {
    const auto two = reinterpret_cast<TwoWide>(numbers);
    return ((two[0] | two[1]) & 0x8000000080000000) != 0;
}

/// The bits of a word above each one, by its number.
struct BitsAbove {
    std::uint32_t of[32];

    // unreachable: at run time, as the compiler asks.
    constexpr BitsAbove() : of() {
        for (unsigned bit = 0; bit < 32; ++bit) of[bit] = ~std::uint32_t{1} << bit;
    }
};
inline constexpr BitsAbove bits_above;

/// Those of four, of whose numbers the lowest five bits count.
inline void set_bits_above(Four& result, const Four& bits) {
    const Four bit = bits & 31;
    result = Four{bits_above.of[bit[0]], bits_above.of[bit[1]], bits_above.of[bit[2]], bits_above.of[bit[3]]};
}

/// Four numbers that stand in a row, wherever that begins.
inline void load(Four& numbers, const std::uint32_t* from) {
    __builtin_memcpy(&numbers, __builtin_assume_aligned(from, alignof(std::uint32_t)), sizeof numbers);
}
inline void store(std::uint32_t* to, const Four& numbers) {
    __builtin_memcpy(__builtin_assume_aligned(to, alignof(std::uint32_t)), &numbers, sizeof numbers);
}

/// Numbers of two fours by their places, those of the second one from 4 on.
template <int first, int second, int third, int last, class Numbers>
[[gnu::always_inline]] inline void pick(Numbers& result, const Numbers& a, const Numbers& b) {
#if defined(__clang__)
    result = __builtin_shufflevector(a, b, first, second, third, last);
#else
    result = __builtin_shuffle(a, b, FourSigned{first, second, third, last});
#endif
}

/// Where of two such numbers that are a long one that with its lowest bits stands.
constexpr int low_half = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? 0 : 1;

/// Each number four times.
[[gnu::always_inline]] inline void set_each(Four (&results)[4], const Four& numbers) {
    pick<0, 0, 0, 0>(results[0], numbers, numbers);
    pick<1, 1, 1, 1>(results[1], numbers, numbers);
    pick<2, 2, 2, 2>(results[2], numbers, numbers);
    pick<3, 3, 3, 3>(results[3], numbers, numbers);
}

/// Where a coordinate along an axis is among a point's.
constexpr unsigned place_of_axis(int axis) { return axis == axis_z ? 3U : static_cast<unsigned>(axis); }

/// A point's coordinates: x, y, again y, and z, as these are two pairs that may be read at once.
[[gnu::always_inline]] inline void load(FourSigned& numbers, const Point& point) {
    std::uint64_t pairs[2];
    __builtin_memcpy(&pairs[0], &point.at[0], sizeof pairs[0]);
    __builtin_memcpy(&pairs[1], &point.at[1], sizeof pairs[1]);
    numbers = reinterpret_cast<FourSigned>(TwoWide{pairs[0], pairs[1]});
}

} // namespace osem

#endif
