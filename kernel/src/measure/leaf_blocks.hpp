// Where the words of leaves stand; the layout is that of LeafBlocks.
#ifndef OSEM_MEASURE_LEAF_BLOCKS_HPP
#define OSEM_MEASURE_LEAF_BLOCKS_HPP

#include "osem/cluster_walk.hpp"
#include "osem/query.hpp"
#include "tree/masks.hpp"

namespace osem {

/// The leaf children of a node that have a word. A uniform node, which only the top may be, is one leaf, its
/// child 0.
constexpr std::uint8_t counted_children(const Node& node, std::uint8_t colours) {
    const auto counts = [colours](Colour colour) { return (colours & colour_bit(colour)) != 0 ? 0xff : 0; };
    const int mask = (whites(node) & counts(Colour::white)) | (blacks(node) & counts(Colour::black)) |
                     (boundaries(node) & counts(Colour::boundary));
    return static_cast<std::uint8_t>(node.is_uniform() ? mask & 1 : mask);
}

/// The place of leaf child k of a node whose block stands at `block`; 0 when it has none.
constexpr std::uint32_t leaf_place(const Node& node, std::uint8_t colours, std::uint32_t block, unsigned k) {
    const std::uint8_t counted = counted_children(node, colours);
    if (!contains(counted, k)) return 0;
    return block + 1 + count_bits(static_cast<std::uint8_t>(counted & ((1U << k) - 1U)));
}

/// The block of grey child k of a node whose block stands at `block`.
inline std::uint32_t child_block(const Node& node, const LeafBlocks& blocks, std::uint32_t block,
                                 unsigned k) {
    std::uint32_t place = block + 1 + count_bits(counted_children(node, blocks.colours));
    const auto before = static_cast<std::uint8_t>(node.grey() & ((1U << k) - 1U));
    for (unsigned left = count_bits(before); left > 0; --left) place += blocks.words[place];
    return place;
}

} // namespace osem

#endif
