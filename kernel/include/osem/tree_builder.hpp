// Assembles one canonical tree in a pool, children before parents, in memory fixed beforehand. What the
// conversion, the Booleans and the stream reader have in common; also for callers with trees of their own.
#ifndef OSEM_TREE_BUILDER_HPP
#define OSEM_TREE_BUILDER_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"

namespace osem {

/// Outcome of building a tree, whichever way.
struct TreeOutcome {
    Status status;
    std::uint32_t nodes_needed; ///< nodes the tree takes from the pool beside those it shares; 2^32 - 1: that
                                ///< many or more
    std::uint32_t nodes_missing; ///< with pool_exhausted: how many more free nodes it would have needed (0,
                                 ///< for unknown, if the build was given up); else 0
    Octree tree;                 ///< meaningful when status is ok and the build was not a counting pass
};

/// The octants of the tree are opened and closed in depth-first order. When the pool runs out it is rolled
/// back at once to where it was, and building goes on without writing, so that the number of nodes missing
/// is known exactly in the end. Without a pool nothing is ever written: a counting pass.
class TreeBuilder {
  public:
    /// Starts a tree with the root octant open, its children white. A build that was not finished is given up
    /// first, so its pool must still be there. A counting pass may still be given the
    /// pool whose subtrees are grafted; `pool` may be null in a counting pass without grafts.
    void begin(NodePool* pool, bool count_only = false);

    /// Opens child `child` of the open octant, its children white.
    /// Precondition: fewer than max_depth octants are open.
    void open(unsigned child);

    /// Makes child `child` of the open octant a leaf. Precondition: colour is not grey.
    void leaf(unsigned child, Colour colour);

    /// Sets all eight children of the open octant as leaves by two masks. Precondition: no child is grey.
    void leaves(std::uint8_t may, std::uint8_t must);

    /// Sets all 64 octants two levels below the open one as leaves by two sets in Morton order (bit 8c + g is
    /// child g of child c), eight equal ones as one leaf; but leaves out children that hold an octant of
    /// `to_open`: they are leaves until they are opened. Preconditions: none of the 64 is grey, and fewer
    /// than max_depth octants are open.
    void grandchildren(std::uint64_t may, std::uint64_t must, std::uint64_t to_open = 0);

    /// Makes child `child` of the open octant one of eight leaves: as open(child), leaves(may, must),
    /// close(), in one step. Preconditions: those of open, and no child of it is grey.
    void eight_leaves(unsigned child, std::uint8_t may, std::uint8_t must);

    /// Makes child `child` of the open octant a subtree of 64 such leaves: as open(child),
    /// grandchildren(may, must), close(), in one step. Preconditions: none of the 64 is grey, and fewer
    /// than max_depth - 1 octants are open.
    void subtree(unsigned child, std::uint64_t may, std::uint64_t must);

    /// Makes child `child` of the open octant a subtree of 512 such leaves, two sets in Morton order for each
    /// child of that one: as open(child), subtree(part, may[part], must[part]) for each part, close(), in one
    /// step. Where none is boundary the two may be the same memory: that takes less time. Preconditions: none
    /// of the 512 is grey, and fewer than max_depth - 2 octants are open.
    void subtree_of_512(unsigned child, const std::uint64_t (&may)[8], const std::uint64_t (&must)[8]);

    /// Makes child `child` of the open octant an existing subtree of the same pool, shared. Preconditions:
    /// the node is not uniform, and no octant of the subtree comes to lie deeper than max_depth.
    void graft(unsigned child, const Node& node);

    /// Closes the open octant: eight equal leaves become one leaf, and a group of grey children that equals
    /// the one of `like` or `or_like` (nodes of the same pool, or null) is shared with it instead of written.
    void close(const Node* like = nullptr, const Node* or_like = nullptr);

    /// Whether the root octant has been closed.
    bool finished() const { return closed_; }
    /// Whether octants are open.
    bool building() const { return building_; }
    /// Whether the pool has run out (it has been rolled back; building may go on to count).
    bool exhausted() const { return exhausted_; }

    /// Nodes written or counted so far; 2^32 - 1: that many or more.
    std::uint32_t nodes_counted() const { return needed_; }

    /// The tree, or what kept it from being. Status: ok; pool_exhausted; unfinished when the root octant is
    /// still open or nothing was begun (pool_exhausted if the pool has run out by then), in which case the
    /// pool is as it was, and the build is given up: asked again it is unfinished. Precondition of a
    /// tree: depth is in [1, 20], and no leaf is deeper.
    TreeOutcome finish(int depth);

    /// Gives the pool's nodes back, and what was counted stays. After finish it does nothing.
    void abandon();
    /// The same, as if the build had never begun.
    void reset() {
        abandon();
        needed_ = 0;
    }

  private:
    template <bool is_boundary_free>
    void subtree_of_parts(unsigned child, const std::uint64_t (&may)[8], const std::uint64_t (&must)[8]);
    struct Level {
        Node pending[8];
        std::uint8_t may;
        std::uint8_t must;
        std::uint8_t child; ///< which child of the level above this is
    };
    bool equals_group(const Level& level, std::uint8_t grey, const Node* like) const;
    Node* extend(std::uint32_t count, NodeIndex& first);
    void write_group(const Level& level, std::uint8_t grey, NodeIndex& first);
    void set_child(unsigned child, std::uint8_t may, std::uint8_t must, NodeIndex first);

    NodePool* pool_ = nullptr;
    std::uint32_t mark_ = 0;
    std::uint32_t needed_ = 0;
    int level_ = 0;
    bool building_ = false;
    bool closed_ = false;
    bool writing_ = false;
    bool exhausted_ = false;
    Node top_ = {};
    Level levels_[max_depth] = {};
};

} // namespace osem

#endif
