// The words of a bintree in preorder. The word of a block that is halved holds the place of its second half's
// word, which is greater than its own; the first half's follows. The word of a free leaf holds its own place
// or that of a lower leaf of its component, until the component's colour is known.
#ifndef OSEM_BINTREE_WORDS_HPP
#define OSEM_BINTREE_WORDS_HPP

#include <cstdint>

namespace osem {

constexpr std::uint32_t met_block = UINT32_MAX; ///< a boundary leaf
constexpr std::uint32_t black_block = UINT32_MAX - 1;
constexpr std::uint32_t white_block = UINT32_MAX - 2;
constexpr std::uint32_t most_blocks = UINT32_MAX - 2; ///< so that no place is one of these

/// Whether the block at a place is halved, before colours stand in the words.
constexpr bool is_halved(std::uint32_t place, std::uint32_t word) {
    return word > place && word < white_block;
}

} // namespace osem

#endif
