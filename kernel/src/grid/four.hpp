// Four numbers side by side: a register of parts that have such ones, else four.
#ifndef OSEM_GRID_FOUR_HPP
#define OSEM_GRID_FOUR_HPP

#include <cstdint>

namespace osem {

using Four [[gnu::vector_size(16)]] = std::uint32_t;

/// Four words in a row as they lie in memory.
using FourWords [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = std::uint32_t;
inline const FourWords& four_at(const std::uint32_t* words) {
    return *reinterpret_cast<const FourWords*>(words);
}

} // namespace osem

#endif
