// A tree of a record, in a pool of its own.
#ifndef OSEM_CROSS_REPLAY_PLANTED_TREE_HPP
#define OSEM_CROSS_REPLAY_PLANTED_TREE_HPP

#include "arena.hpp"
#include "leaf_planter.hpp"
#include "records.hpp"

namespace osem::cross {

/// Reads u8 depth, u32 leaves and the leaves in Morton order. The builder's memory is given back.
class PlantedTree {
  public:
    /// The pool has room for so many more nodes.
    PlantedTree(Reader& reader, Arena& arena, std::uint32_t more = 0)
        : depth_(reader.u8()), leaves_(reader.u32()), capacity_(nodes_of(leaves_) + more),
          memory_(take_nodes(arena, capacity_)), pool_(memory_, memory_ == nullptr ? 0 : capacity_),
          tree_(Octree::uniform(pool_, Colour::white)) {
        if (memory_ == nullptr) return;
        const ArenaScope scope(arena);
        auto* const builder = arena.take<TreeBuilder>(1);
        if (builder == nullptr) return;
        const TreeOutcome outcome = plant_leaves(reader, depth_, leaves_, *builder, pool_);
        if (outcome.status == Status::ok) tree_ = outcome.tree;
        fits_ = true;
    }

    /// Whether the arena had room for the tree; else its leaves have not been read.
    bool fits() const { return fits_; }
    /// White if it could not be built, so that the answers are wrong.
    const Octree& tree() const { return tree_; }
    NodePool& pool() { return pool_; }

  private:
    std::uint8_t depth_;
    std::uint32_t leaves_;
    std::uint32_t capacity_;
    Node* memory_;
    NodePool pool_;
    Octree tree_;
    bool fits_ = false;
};

} // namespace osem::cross

#endif
