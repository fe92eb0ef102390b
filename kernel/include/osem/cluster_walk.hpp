// Walks what the leaves of an octree have in common. The leaves cut space into open cubes, squares, segments
// and points, and every one of these pieces is met once, with the one, two, four or eight leaves around it.
//
// This is the recursion on cells, faces, edges and vertices of an octree (Ju, Losasso, Schaefer and Warren,
// "Dual Contouring of Hermite Data", SIGGRAPH 2002; its two-dimensional form in Samet and Tamminen, PAMI
// 7(2), 1985), with an explicit stack and the four procedures as one: no neighbour is ever searched for.
#ifndef OSEM_CLUSTER_WALK_HPP
#define OSEM_CLUSTER_WALK_HPP

#include <cstdint>

#include "osem/node_pool.hpp"
#include "osem/octree.hpp"

namespace osem {

/// The octants around a piece of space. `axes` says along which axes the piece has no extent: none for a
/// cube, one for a square, two for a segment, three for a point. Slot s, s a subset of `axes`, is the octant
/// on the high side of the piece along the axes of s, on the low side along the others.
struct Cluster {
    std::uint8_t axes;
    std::uint8_t level; ///< the piece's side is root_side >> level; octants around it may be larger
    bool border;        ///< the piece lies on the root's border; what is outside the root is a white leaf
    std::uint8_t slots; ///< bit s is set when slot s is an octant
    std::uint8_t may;   ///< colour of slot s, as in a node; 0 where slot s is no octant
    std::uint8_t must;
    const std::uint32_t* places; ///< place of each slot's leaf (see LeafBlocks); 0: it has none
};

/// Numbers for the leaves of some colours, one word each, in memory of the caller. The words of a tree are a
/// block a node, in preorder: the number of words of the node's subtree, then a word for each of the node's
/// leaf children that count, in ascending order, then the blocks of its grey children. A subtree that
/// stands at several places has a block at each. A leaf's place is the index of its word.
struct LeafBlocks {
    const std::uint32_t* words; ///< null: leaves have no places
    std::uint8_t colours;       ///< bit c is set when leaves of colour c have a word
};

/// The walk: begin; then, while there is a cluster ahead, visit it, and take cluster() when it is of leaves
/// alone. State O(depth); clusters in all: at most 27 * (8 * nodes + 1), as all but the root's own have an
/// octant of their level, which has 27 pieces.
class OSEM_OF_INDEX_WIDTH ClusterWalk {
  public:
    /// Pieces of fewer than 3 - most_axes dimensions are left out, and those on the root's border unless
    /// `border`.
    void begin(const Octree& tree, unsigned most_axes, bool border, const LeafBlocks& blocks);

    /// Whether there is a cluster left to visit.
    bool ahead();

    /// Visits the next cluster; true when all of its octants are leaves. Precondition: ahead() was true.
    bool visit();

    /// The cluster visited last.
    Cluster cluster() const;

    std::uint64_t visited() const { return visited_; }

  private:
    struct Frame {
        NodeIndex nodes[8];      ///< of the slots that are grey
        std::uint32_t places[8]; ///< of their leaves' words, or of their blocks
        std::uint8_t axes;
        std::uint8_t may;
        std::uint8_t must;
        std::uint8_t next; ///< one more than the index of the next part to go to
    };
    bool fits(const Frame& frame) const;
    void place_root(unsigned part);
    void fill(const Frame& from, unsigned from_slot, unsigned child, Frame& to, unsigned slot) const;

    const NodePool* pool_ = nullptr;
    Node top_ = {};
    LeafBlocks blocks_ = {};
    std::uint64_t visited_ = 0;
    std::uint8_t most_axes_ = 0;
    std::uint8_t roots_ = 0; ///< placements of the root left, this one included
    bool border_ = false;
    int level_ = -1; ///< of the cluster being divided
    int found_ = 0;  ///< of the cluster visited last
    Frame frames_[max_depth + 1] = {};
};

} // namespace osem

#endif
