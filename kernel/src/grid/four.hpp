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

} // namespace osem

#endif
