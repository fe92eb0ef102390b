// A tree from the leaves of a record.
#ifndef OSEM_CROSS_REPLAY_LEAF_PLANTER_HPP
#define OSEM_CROSS_REPLAY_LEAF_PLANTER_HPP

#include "format.hpp"
#include "osem/tree_builder.hpp"
#include "reader.hpp"

namespace osem::cross {

/// Most nodes of a tree of so many leaves, the top included: every node divides one octant into eight.
constexpr std::uint32_t nodes_of(std::uint32_t leaves) { return leaves / 7 + 1; }

/// Builds a tree from its leaves, which come in Morton order.
class LeafPlanter {
  public:
    LeafPlanter(TreeBuilder& builder, NodePool& pool) : builder_(builder) { builder_.begin(&pool); }

    void add(int level, Colour colour) {
        if (level == 0) {
            const Node node = Node::uniform(colour);
            builder_.leaves(node.may, node.must);
            builder_.close();
            return;
        }
        while (open_ < level - 1) {
            builder_.open(next_[open_]++);
            next_[++open_] = 0;
        }
        builder_.leaf(next_[open_]++, colour);
        while (open_ >= 0 && next_[open_] == 8) {
            builder_.close();
            --open_;
        }
    }

  private:
    TreeBuilder& builder_;
    int open_ = 0; ///< level of the innermost open octant
    std::uint8_t next_[max_depth] = {};
};

/// Reads the leaves and builds their tree into the pool.
inline TreeOutcome plant_leaves(Reader& reader, std::uint8_t depth, std::uint32_t leaves,
                                TreeBuilder& builder, NodePool& pool) {
    LeafPlanter planter(builder, pool);
    for (std::uint32_t i = 0; i < leaves; ++i) {
        const std::uint8_t leaf = reader.u8();
        planter.add(encoded_level(leaf), static_cast<Colour>(leaf & 3U));
    }
    return builder.finish(depth);
}

} // namespace osem::cross

#endif
