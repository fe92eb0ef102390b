// Trees moved, turned, scaled, cut and made coarser, without loss: every cell of the result has the colour of
// the cell that it came from, a boundary leaf's parts being boundary. Only coarsening gives up detail, and
// only as its rule says.
//
// Results stand in the operand's pool and share its subtrees where they can. Each walk over the result's
// octants carries the operand's octants under it; see Samet, "Applications of Spatial Data Structures"
// (1990), on linear transformations of quadtrees.
#ifndef OSEM_TRANSFORM_HPP
#define OSEM_TRANSFORM_HPP

#include <cstdint>

#include "osem/octree.hpp"
#include "osem/query.hpp"
#include "osem/symmetry.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

/// The open octants of a walk: which children of each are still to be entered.
struct OpenOctants {
    int level = -1; ///< of the innermost one; none: -1
    std::uint8_t left[max_depth] = {};

    /// How much of the root's volume lies in children that are done, while some octant is open.
    std::uint64_t decided_volume() const;
};

/// Where a tree is put, and how much of it. The default is the tree as it is.
struct Placement {
    Point by = {{0, 0, 0}}; ///< lattice units added to every coordinate; any numbers
    /// The cells of the result that may be other than white.
    CellBox keep = {Point{{0, 0, 0}}, Point{{root_side, root_side, root_side}}};
    bool cut_at_root = false; ///< what would leave the root is dropped; else it is refused, unless white
    /// Greatest depth of the result; 0: whatever exactness needs, which is placed_depth.
    std::uint8_t depth = 0;
    /// At a depth below placed_depth an octant of several colours becomes boundary; else that is refused.
    bool mixed_as_boundary = false;
};

/// The depth at which a tree of some depth can be placed exactly: the greater one of its own depth and
/// 20 - z, where z is how many binary zeros the coordinates of the vector and of the box all end with.
constexpr int placed_depth(int tree_depth, const Placement& placement) {
    std::uint32_t bits = std::uint32_t{1} << max_depth;
    for (int axis = 0; axis < 3; ++axis) {
        bits |= static_cast<std::uint32_t>(placement.by.at[axis]);
        bits |= static_cast<std::uint32_t>(placement.keep.low.at[axis]);
        bits |= static_cast<std::uint32_t>(placement.keep.high.at[axis]);
    }
    int depth = max_depth;
    for (; (bits & 1U) == 0; bits >>= 1) --depth;
    return depth > tree_depth ? depth : tree_depth;
}

/// A lattice translation with a crop, in progress: begin, step until done, finish; holds all of its state,
/// O(depth). Between begin and finish nothing else may append to the pool.
class Translation {
  public:
    /// Starts placing into the operand's pool, or a counting pass. One that was not finished is given up
    /// first. Status: ok; pools_differ; point_off_root or box_empty for `keep`; depth_out_of_range when
    /// placement.depth is above 20; depth_too_coarse when it is below placed_depth and mixed octants may not
    /// become boundary.
    Status begin(const Octree& tree, const Placement& placement, NodePool& pool, bool count_only = false);

    /// Visits up to `nodes` octants; false when none is left. Octants of the result visited in all: those
    /// over which operand octants of several colours or the border of `keep` lie, down to where the vector is
    /// a multiple of the octant's side (there subtrees are shared), or to the depth asked for. Before that,
    /// unless what leaves is dropped, the operand's nodes on the border of what stays in the root.
    bool step(std::uint32_t nodes);

    bool exhausted() const { return builder_.exhausted(); }

    /// Exact progress: how much of the root's volume (2^60 cells) is decided.
    std::uint64_t decided_volume() const;

    /// Octants visited so far.
    std::uint64_t nodes_visited() const { return visited_; }

    /// The result; as Conversion::finish. Status: ok; part_leaves_root; pool_exhausted; unfinished. When not
    /// ok pool and operand are as they were at begin.
    TreeOutcome finish();

  private:
    struct Frame {
        Node from[8]; ///< operand octants of the same side that the octant overlaps, a bit of the index an
                      ///< axis
    };
    void start();
    void search();
    void enter(unsigned child);
    void visit();
    void settle(unsigned child, bool within);
    void found(unsigned child, Colour colour);
    void leave();
    void gather(unsigned child, Node (&from)[8]) const;
    bool aligned(std::int32_t side) const;

    NodePool* pool_ = nullptr;
    Octree tree_ = {};
    Placement placement_ = {};
    CellBox stays_ = {}; ///< the operand's cells that stay in the root
    Octant octant_ = root_octant;
    bool searching_ = false;
    bool leaves_root_ = false;
    std::uint8_t limit_ = 0; ///< the result's depth; below it mixed octants are only looked into
    std::uint8_t seen_ = 0;  ///< colours of the octant being looked into, a bit each
    std::uint64_t visited_ = 0;
    OpenOctants open_;
    Frame frames_[max_depth] = {};
    TreeBuilder builder_;
};

/// Places a tree in one call: begin, step to the end, finish; status and cost are theirs. `job` is the
/// working memory.
TreeOutcome translate(Translation& job, const Octree& tree, const Placement& placement, NodePool& pool);

/// The tree in a box of cells, white outside of it; as translate with `keep` alone. Cost: O(nodes on the
/// box's border), as the subtrees inside are shared.
TreeOutcome crop(Translation& job, const Octree& tree, const CellBox& box, NodePool& pool);

/// A symmetry applied to a tree, in progress; as Translation.
class Reorientation {
  public:
    /// Status: ok; pools_differ; symmetry_invalid.
    Status begin(const Octree& tree, const Symmetry& symmetry, NodePool& pool, bool count_only = false);

    /// Visits up to `nodes` nodes; false when none is left. Visited in all: the operand's nodes.
    bool step(std::uint32_t nodes);

    bool exhausted() const { return builder_.exhausted(); }
    std::uint64_t decided_volume() const;
    std::uint64_t nodes_visited() const { return visited_; }

    /// As Translation::finish. Status: ok; pool_exhausted; unfinished. The result takes at most as many nodes
    /// as the operand has, and none where the operand is its own image.
    TreeOutcome finish();

  private:
    void enter(const Node& node, unsigned child);

    NodePool* pool_ = nullptr;
    Symmetry symmetry_ = Symmetry::identity();
    std::uint8_t depth_ = 0;
    std::uint64_t visited_ = 0;
    OpenOctants open_;
    Node nodes_[max_depth] = {};
    TreeBuilder builder_;
};

/// The image of a tree in one call; as translate.
TreeOutcome reorient(Reorientation& job, const Octree& tree, const Symmetry& symmetry, NodePool& pool);

/// What an octant at the new depth becomes, and what boundary leaves become anywhere.
enum class Coarse : std::uint8_t {
    certified, ///< mixed: boundary. Boundary leaves stay: inner and outer solid go on being certified
    inner,     ///< mixed: white. Boundary leaves: white. The result is the inner solid's whole octants
    outer,     ///< mixed: black. Boundary leaves: black. All octants that the outer solid enters
    majority,  ///< mixed: black if it holds more black than white cells, boundary ones counting half; with as
               ///< many white. Boundary leaves, half of each being neither more nor less: white
};

/// Coarsening to a depth, in progress; as Translation.
class Coarsening {
  public:
    /// Status: ok; pools_differ; depth_out_of_range when depth is outside [1, 20].
    Status begin(const Octree& tree, int depth, Coarse mode, NodePool& pool, bool count_only = false);

    /// Visits up to `nodes` nodes; false when none is left. Visited in all: the operand's nodes above the new
    /// depth, in `majority` all of them.
    bool step(std::uint32_t nodes);

    bool exhausted() const { return builder_.exhausted(); }
    std::uint64_t decided_volume() const;
    std::uint64_t nodes_visited() const { return visited_; }

    /// As Translation::finish. Status: ok; pool_exhausted; unfinished. The result's depth is the smaller one
    /// of the operand's and the one asked for. It takes at most as many nodes as the operand has.
    TreeOutcome finish();

  private:
    void enter(const Node& node, unsigned child);
    void leave();

    NodePool* pool_ = nullptr;
    Coarse mode_ = Coarse::certified;
    std::uint8_t depth_ = 0;
    std::uint8_t child_ = 0;   ///< of its parent: the octant whose cells are counted
    std::uint64_t weight_ = 0; ///< its cells, a black one counting 2 and a boundary one 1; at most 2^58
    std::uint64_t visited_ = 0;
    OpenOctants open_;
    Node nodes_[max_depth] = {};
    TreeBuilder builder_;
};

/// A coarser tree in one call; as translate.
TreeOutcome coarsen(Coarsening& job, const Octree& tree, int depth, Coarse mode, NodePool& pool);

/// Scales up by 2^level: what the octant holds fills the root. The subtree is shared; no node is written. The
/// result's depth is the tree's less the octant's level, but at least 1. Status: ok; octant_invalid when the
/// octant's level is above 20, or its corner no multiple of its side in the root. Cost: O(depth).
TreeOutcome enlarged(const Octree& tree, const Octant& octant);

/// Scales down by 2^level: the whole tree becomes the octant, all around it is white. Takes a node for each
/// level (one less for a uniform tree, none for a white one) and shares the rest; the result's depth is the
/// sum of the tree's and the octant's level. Status: ok; octant_invalid; depth_out_of_range when that sum is
/// above 20; pools_differ; pool_exhausted, with the pool as it was. Cost: O(depth).
TreeOutcome reduced(const Octree& tree, const Octant& octant, NodePool& pool);

} // namespace osem

#endif
