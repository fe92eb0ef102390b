// Four numbers side by side: in one register of parts that have such ones, else in four.
#ifndef OSEM_GRID_FOUR_HPP
#define OSEM_GRID_FOUR_HPP

#include <cstdint>

namespace osem {

using Four [[gnu::vector_size(16)]] = std::uint32_t;
using FourSigned [[gnu::vector_size(16)]] = std::int32_t;

/// -1 for each that is below 0, in two's complement.
inline void set_signs(Four& signs, const Four& numbers) {
    signs = reinterpret_cast<Four>(reinterpret_cast<FourSigned>(numbers) < 0);
}

} // namespace osem

#endif
