// Boundary to octree conversion by divide and conquer.
#ifndef OSEM_CONVERT_HPP
#define OSEM_CONVERT_HPP

#include <cstdint>

#include "osem/face_walk.hpp"
#include "osem/octree.hpp"
#include "osem/solid.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

/// Which winding numbers are inside.
enum class WindingRule : std::uint8_t { nonzero, odd, positive };

/// How an octant at full depth that a face meets is coloured.
enum class LeafRule : std::uint8_t {
    conservative, ///< boundary: black leaves are inside throughout, white ones outside throughout
    centre,       ///< black or white, as the leaf's centre moved by (e, e^2, e^3) for an infinitesimal e > 0
};

/// A leaf at full depth whose centre is asked for has one on the lattice.
constexpr int greatest_depth(LeafRule leaves) {
    return leaves == LeafRule::centre ? max_depth - 1 : max_depth;
}

struct ConvertOptions {
    int depth = 8; ///< leaves of side 2^(20 - depth); 1 to 20 (19 with centre leaves)
    LeafRule leaves = LeafRule::conservative;
    WindingRule winding = WindingRule::nonzero;
};

/// Entries of face-list scratch that conversion needs: one index a face.
constexpr std::uint32_t convert_scratch(const Solid& solid) { return solid.face_count; }

/// A conversion in progress: begin, step until done, finish. It holds all of its state, O(depth), so it may
/// be a static object; the solid's arrays, the scratch and the pool must outlive it. Between begin and
/// finish nothing else may append to the pool.
///
/// The octant that no face meets is white or black by the winding number of its reference point, its
/// minimum corner moved by (e, e^2, e^3); see kernel/DESIGN.md for why only local faces are looked at.
/// Source: Trstenjak, Zalik and Guid, Informatica 2/91, sections 2 and 3 (divide and conquer).
class Conversion {
  public:
    /// Starts. Nodes go to `pool`; with a null pool this is a counting pass, which says how many nodes the
    /// tree needs and writes nothing.
    /// Scratch: convert_scratch(solid.view()) indices, in use until finish.
    /// A conversion that was not finished is given up first. Status: ok; depth_out_of_range;
    /// scratch_too_small. When not ok, nothing has begun.
    Status begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                 std::uint32_t scratch_size, NodePool* pool);

    /// Visits up to `octants` octants; false when none is left. Cost of one visit: a classification and up to
    /// three crossing tests of each face in the parent's list; with centre leaves also three crossing tests
    /// of each face in the leaf's own list. The root's parent list is all faces.
    bool step(std::uint32_t octants);

    /// Whether the pool has run out. Going on to the end then finds out the exact number of nodes missing.
    bool exhausted() const { return builder_.exhausted(); }

    /// Exact progress: how much of the root's volume (2^60 cells) is decided.
    std::uint64_t decided_volume() const;

    /// Octants visited so far, the root included.
    std::uint64_t octants_visited() const { return visited_; }

    /// Nodes that the tree takes so far; it never falls, and in the end it is nodes_needed.
    std::uint32_t nodes_counted() const { return builder_.nodes_counted(); }

    /// What each stage rejected and accepted so far.
    const StageCounts& stages() const { return faces_.stages(); }

    /// The tree. Called before step has returned false it gives the conversion up. Status: ok;
    /// pool_exhausted (nodes_missing is 0, for unknown, if given up); unfinished if given up. When not ok the
    /// pool is as it was at begin.
    TreeOutcome finish();

  private:
    struct Frame : FaceFrame {
        std::uint8_t child; ///< the child being visited
    };
    void visit_root();
    void visit_child();
    void enter(const Octant& octant, std::uint32_t faces, std::int32_t winding);
    void leave();
    Colour colour_of(std::int32_t winding) const;

    FaceWalk faces_;
    ConvertOptions options_ = {0, LeafRule::conservative, WindingRule::nonzero};
    std::uint64_t visited_ = 0;
    Octant octant_ = root_octant; ///< that of the frame on top
    int level_ = 0;               ///< of the frame on top
    bool started_ = false;
    Frame frames_[max_depth] = {};
    TreeBuilder builder_;
};

/// Converts in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
TreeOutcome convert(Conversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool);

} // namespace osem

#endif
