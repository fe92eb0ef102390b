// Words of a grid's tables, before anything is in them.
#ifndef OSEM_GRID_SET_ZERO_HPP
#define OSEM_GRID_SET_ZERO_HPP

#include <cstddef>
#include <cstdint>

#include "tree/guesses.hpp"

namespace osem {

/// Sets words to 0. Parts of 64 bits have libraries that do it by the widest registers there are, which a
/// compiler makes no use of by itself where it must not take a loop for a library's function; those of small
/// parts may do it byte by byte.
inline void set_zero(std::uint32_t* words, std::uint32_t count) {
    if constexpr (guesses_cost_much) {
        __builtin_memset(words, 0, std::size_t{count} * sizeof *words);
    } else {
        for (std::uint32_t word = 0; word < count; ++word) words[word] = 0;
    }
}

} // namespace osem

#endif
