// Connected components of a tree's leaves: the pieces of the solid, the cavities of the void.
#ifndef OSEM_COMPONENTS_HPP
#define OSEM_COMPONENTS_HPP

#include <cstdint>

#include "osem/cluster_walk.hpp"
#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/query.hpp"
#include "osem/status.hpp"

namespace osem {

/// What two leaves must have in common to hang together, as cells of side 1 do: a part of a face (every cell
/// has 6 such neighbours), or of an edge at least (18), or a point (26).
enum class Connectivity : std::uint8_t { faces = 1, edges = 2, corners = 3 };

/// Sets of leaf colours, each its colour_bit. Where a solid hangs together by corners, its void must hang
/// together by faces, and the other way round, for the two to make sense side by side.
constexpr std::uint8_t inner_solid = colour_bit(Colour::black);
constexpr std::uint8_t outer_solid = solid_colours;
constexpr std::uint8_t inner_void = colour_bit(Colour::white) | colour_bit(Colour::boundary);
constexpr std::uint8_t outer_void = colour_bit(Colour::white); ///< what the outer solid leaves

/// A component. What is outside the root counts as white, though it has no cells and is no component by
/// itself: where white is among the colours, all leaves on the root's border hang together through it. So a
/// component of the void that does not touch the border is a sealed cavity, and at most one does touch it.
struct Component {
    std::uint64_t volume; ///< cells of side 1
    std::uint64_t leaves;
    CellBox box;         ///< the smallest that holds all of its cells
    bool touches_border; ///< a leaf of it has a side on the root's border
};

/// Outcome of a labelling.
struct ComponentOutcome {
    Status status;
    std::uint32_t components;
    std::uint64_t scratch_needed; ///< words; known when status is ok or scratch_too_small
};

/// What component_of answers for a cell of no component.
constexpr std::uint32_t no_component = UINT32_MAX;

/// Words of scratch that a labelling needs: one a node and one a leaf that counts, shared subtrees as often
/// as they are reached; m is measure(tree). Past 2^31 - 1 words no scratch is large enough.
constexpr std::uint64_t component_scratch(const Measures& m, std::uint8_t colours) {
    return m.nodes + ((colours & colour_bit(Colour::white)) != 0 ? m.white_leaves : 0) +
           ((colours & colour_bit(Colour::boundary)) != 0 ? m.boundary_leaves : 0) +
           ((colours & colour_bit(Colour::black)) != 0 ? m.black_leaves : 0);
}

/// Labels the leaves of given colours by component: begin, step until nothing is left, finish; then ask. Tree
/// and scratch must stay as they are until the last question.
///
/// Three passes: the leaves get their words (preorder), the clusters of the tree unite the sets of their
/// leaves, and in Morton order every set gets a number: so components are numbered from 0 by their first leaf
/// in Morton order, whatever the steps. Source: Samet and Tamminen, "Efficient Component Labeling of Images
/// of Arbitrary Dimension Represented by Linear Bintrees", PAMI 10(4), 1988; here the adjacent leaves come
/// from the clusters and the equivalences go into disjoint sets (tree/disjoint_sets.hpp).
class OSEM_OF_INDEX_WIDTH ComponentLabelling {
  public:
    /// A labelling that was not finished is given up first. Scratch: component_scratch words. Precondition:
    /// colours is not empty and without grey.
    void begin(const Octree& tree, std::uint8_t colours, Connectivity connectivity, std::uint32_t* scratch,
               std::uint32_t scratch_size);

    /// Visits up to `units` nodes, clusters and leaves; false when nothing is left. Units in all: at most
    /// 27 * (8 * nodes + 1) + nodes + leaves that count. Cost: O(units * log(leaves)), in practice O(units).
    bool step(std::uint32_t units);

    /// Units visited so far.
    std::uint64_t units_visited() const { return passed_ + clusters_.visited(); }

    /// Status: ok; scratch_too_small, with the words needed; unfinished when units are left or nothing was
    /// begun.
    ComponentOutcome finish() const;

    /// Writes the first components, as many as there are and `capacity` has room for, and returns how many.
    /// Precondition: finish answered ok. Cost: O(nodes + leaves).
    std::uint32_t fill(Component* components, std::uint32_t capacity) const;

    /// The component that holds a cell; no_component when the cell's leaf does not count or the cell is
    /// outside the root. Precondition: finish answered ok. Cost: O(depth).
    std::uint32_t component_of(const Point& cell) const;

  private:
    /// Walks the nodes of a tree in preorder to write their blocks, and then the leaves that count in Morton
    /// order to read where they stand.
    class BlockWalk {
      public:
        void begin_writing(const Octree& tree, std::uint8_t colours, std::uint32_t* words,
                           std::uint32_t size);
        /// Writes the next node's block, every leaf a set of its own; false when it was the last one.
        bool write();
        std::uint64_t words_needed() const { return end_; } ///< so far; beyond `size` nothing is written
        std::uint64_t nodes() const { return nodes_; }      ///< so far

        void begin_reading(const Octree& tree, const LeafBlocks& blocks);
        /// The next leaf that counts, and its place; false when there is none.
        bool read(Leaf& leaf, std::uint32_t& place);

      private:
        struct Frame {
            std::uint32_t block; ///< writing: the node's own; reading: the next grey child's
            std::uint32_t leaf;  ///< reading: place of the next leaf that counts
            Node node;
            std::uint8_t child; ///< writing: mask of children not yet entered; reading: the next child
        };
        void open_block(const Node& node);
        void enter(const Node& node, std::uint32_t block);

        const NodePool* pool_ = nullptr;
        std::uint32_t* words_ = nullptr;
        std::uint32_t size_ = 0;
        LeafBlocks blocks_ = {};
        std::uint64_t end_ = 0;
        std::uint64_t nodes_ = 0;
        Octant octant_ = root_octant;
        int level_ = -1;
        Frame frames_[max_depth] = {};
    };

    enum class Pass : std::uint8_t { none, write, unite, number, done };

    void advance();
    void start_uniting();
    void start_numbering();
    void unite_cluster();
    void number_leaf(std::uint32_t place);
    LeafBlocks blocks() const { return LeafBlocks{words_, colours_}; }

    Octree tree_ = {};
    std::uint32_t* words_ = nullptr;
    std::uint32_t size_ = 0;
    std::uint8_t colours_ = 0;
    Pass pass_ = Pass::none;
    std::uint64_t passed_ = 0;     ///< nodes and leaves visited
    std::uint64_t leaves_ = 0;     ///< that have no number yet
    std::uint32_t outside_ = 0;    ///< place of a leaf that hangs together with what is outside; 0: none
    std::uint32_t components_ = 0; ///< numbered so far
    BlockWalk walk_;
    ClusterWalk clusters_;
};

} // namespace osem

#endif
