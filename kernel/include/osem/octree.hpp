// An octree as a value: measures, walks and compaction. Queries are in query.hpp.
#ifndef OSEM_OCTREE_HPP
#define OSEM_OCTREE_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/node_pool.hpp"
#include "osem/status.hpp"

namespace osem {

/// An octree: its top node by value, over a pool that holds the rest. It is never changed; copying it costs
/// nothing; subtrees may be shared with other trees of the same pool. Trees are canonical: below the top no
/// node has eight equal leaf children, so two trees of one function are equal node for node.
///
/// Only the top node may be uniform; the root octant is then of that one colour.
struct OSEM_OF_INDEX_WIDTH Octree {
    const NodePool* pool;
    Node top;
    std::uint8_t depth; ///< the depth it was built to; no leaf is smaller than root_side >> depth

    /// A tree of one leaf colour, at depth 1; needs no node. Precondition: colour is not grey.
    static constexpr Octree uniform(const NodePool& pool, Colour colour) {
        return Octree{&pool, Node::uniform(colour), 1};
    }
};

/// A leaf: its octant and its colour (never grey). As a set of cells a leaf is half-open: a lattice point
/// belongs to the leaf whose minimum corner side it is on.
struct Leaf {
    Octant octant;
    Colour colour;
};

/// Exact measures of a tree. A uniform root octant is one leaf of level 0.
struct Measures {
    std::uint64_t nodes; ///< nodes of the tree, the top included; shared ones as often as they are reached
    std::uint64_t white_leaves;
    std::uint64_t black_leaves;
    std::uint64_t boundary_leaves;
    std::uint64_t inner_volume; ///< cells of side 1 in black leaves; the root holds 2^60
    std::uint64_t outer_volume; ///< inner_volume and the cells in boundary leaves
};

/// Counts leaves, nodes and volumes. Cost: O(nodes of the tree).
Measures measure(const Octree& tree);

/// A 64-bit digest of the structure: FNV-1a over the bytes may, must of every node in preorder. The same on
/// every architecture; independent of the pool, of sharing and of the stated depth. Cost: O(nodes).
std::uint64_t digest(const Octree& tree);

/// Whether two trees have the same leaves. They may live in different pools. Cost: O(nodes), less what they
/// share.
bool same_leaves(const Octree& a, const Octree& b);

/// Walks the nodes of a tree in preorder with O(depth) state: for (NodeWalk w(t); !w.done(); w.next()).
class NodeWalk {
  public:
    explicit NodeWalk(const Octree& tree);
    bool done() const { return done_; }
    const Node& node() const { return frames_[level_].node; }
    /// The octant that the node divides.
    const Octant& octant() const { return octant_; }
    void next();
    /// Leaves the current node's subtree out: goes on behind it.
    void skip();

  private:
    struct Frame {
        Node node;
        std::uint8_t left; ///< grey children not yet entered
    };
    const NodePool* pool_;
    Octant octant_;
    int level_ = 0;
    bool done_ = false;
    Frame frames_[max_depth];
};

/// Walks the leaves of a tree in Morton order with O(depth) state: while (walk.next(leaf)) ...
class LeafWalk {
  public:
    explicit LeafWalk(const Octree& tree);
    /// Takes the next leaf; false when there is none.
    bool next(Leaf& leaf);

  private:
    struct Frame {
        Node node;
        std::uint8_t child; ///< the next child
    };
    const NodePool* pool_;
    Octant octant_;
    int level_ = 0;
    Frame frames_[max_depth];
};

/// Words of scratch that compaction needs: one bit for each node in use.
constexpr std::uint32_t compact_scratch(std::uint32_t nodes_used) {
    return nodes_used / 32 + (nodes_used % 32 != 0 ? 1 : 0);
}

/// Slides the nodes that the given trees reach to the front of their pool, keeping their order, and forgets
/// the rest. The given trees are rewritten and stay as they were node for node; every other tree of the pool
/// is gone, and none may be read meanwhile. The pool's used() is afterwards the number of nodes reached.
///
/// Scratch: compact_scratch(pool.used()) words; overwritten. Cost: O(used + trees * used / 32).
/// Status: ok; pool_read_only; scratch_too_small; pools_differ when a tree is of another pool. When not ok,
/// nothing changed.
Status compact(NodePool& pool, Octree* trees, std::uint32_t tree_count, std::uint32_t* scratch,
               std::uint32_t scratch_size);

} // namespace osem

#endif
