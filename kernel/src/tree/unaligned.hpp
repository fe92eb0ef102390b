// Words of a register written where no such word need be aligned.
#ifndef OSEM_TREE_UNALIGNED_HPP
#define OSEM_TREE_UNALIGNED_HPP

#include <cstdint>

#include "osem/register_word.hpp"

namespace osem {

/// A register's bytes, the lowest one first: one store where there are unaligned ones, which compilers for
/// ARM do not see in four.
inline void put_word(std::uint8_t* bytes, RegisterWord word) {
    struct [[gnu::packed, gnu::may_alias]] Unaligned {
        RegisterWord word;
    };
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    if constexpr (sizeof word == 8) {
        word = __builtin_bswap64(word);
    } else {
        word = __builtin_bswap32(static_cast<std::uint32_t>(word));
    }
#endif
    reinterpret_cast<Unaligned*>(bytes)->word = word;
}

} // namespace osem

#endif
