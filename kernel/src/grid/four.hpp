// Four numbers side by side, as GCC and Clang have them: in one register of parts that have such ones, else
// in four.
#ifndef OSEM_GRID_FOUR_HPP
#define OSEM_GRID_FOUR_HPP

#include <cstdint>

namespace osem {

using Four [[gnu::vector_size(16)]] = std::uint32_t;
using FourSigned [[gnu::vector_size(16)]] = std::int32_t;

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

/// 0, 1, 2 and 3 times a number.
inline void set_multiples(Four& result, std::uint32_t number) {
    const Four once = Four{} + number;
    result = (once & Four{0, ~0U, 0, ~0U}) + ((once + once) & Four{0, 0, ~0U, ~0U});
}

/// Four numbers that stand in a row, wherever that begins.
inline void load(Four& numbers, const std::uint32_t* from) {
    __builtin_memcpy(&numbers, __builtin_assume_aligned(from, alignof(std::uint32_t)), sizeof numbers);
}
inline void store(std::uint32_t* to, const Four& numbers) {
    __builtin_memcpy(__builtin_assume_aligned(to, alignof(std::uint32_t)), &numbers, sizeof numbers);
}

} // namespace osem

#endif
