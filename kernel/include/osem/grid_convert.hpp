// Boundary to octree conversion by grids of 64 octants: the tree of Conversion in a fraction of its time, for
// more memory and code.
#ifndef OSEM_GRID_CONVERT_HPP
#define OSEM_GRID_CONVERT_HPP

#include <cstdint>

#include "osem/convert.hpp"

namespace osem {

/// Grids that lie in one another, from the root down: two levels each, the first one level if depth is odd.
constexpr int nested_grids(int depth) { return (depth + 1) / 2; }

/// Words of scratch that are always enough: for each of the nested grids three a face, and between them 64. A
/// grid's list holds the faces that meet its octant, so about 3.5 words a face and 64 a level are mostly
/// enough. Precondition: depth is in [1, 20].
constexpr std::uint64_t grid_scratch(const Solid& solid, int depth) {
    const auto grids = static_cast<std::uint64_t>(nested_grids(depth));
    return 3 * std::uint64_t{solid.face_count} * grids + 64 * (grids - 1);
}

/// A conversion in progress: as Conversion, and with the same tree, node for node at the same places of the
/// pool. It holds all of its state, so it may be a static object.
///
/// An octant that faces meet is divided into 4 x 4 x 4 octants at once (the root into 2 x 2 x 2 if the depth
/// is odd). For triangles and convex quadrangles the separating axes of all 64 are found by additions, as
/// masks: the bounding box, three projections to squares, the plane. The reference points' winding numbers
/// are added up side by side. Other faces are classified octant by octant. With centre leaves the reference
/// points are the leaves' centres, so at full depth nothing is classified. See kernel/DESIGN.md.
class GridConversion {
  public:
    /// Starts. Nodes go to `pool`; with a null pool this is a counting pass.
    /// Scratch: at least 3 * solid.view().face_count words, grid_scratch(solid.view(), depth) for certain; in
    /// use until finish. A conversion that was not finished is given up first. Status: ok;
    /// depth_out_of_range; scratch_too_small for the faces. When not ok, nothing has begun.
    Status begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                 std::uint32_t scratch_size, NodePool* pool);

    /// Visits up to `grids` grids; false when none is left. Cost of one visit: a pass over the list of the
    /// grid above, and each triangle or convex quadrangle that meets the grid's octant against its 64
    /// octants; for other faces up to 64 classifications and 21 winding numbers each. At full depth also, for
    /// each part in which conservative octants that no face meets hang together, up to three crossing tests a
    /// face: two parts as a rule, 32 at most.
    bool step(std::uint32_t grids);

    /// Whether the pool has run out. Going on to the end then finds out the exact number of nodes missing.
    bool exhausted() const { return builder_.exhausted(); }

    /// Exact progress: how much of the root's volume (2^60 cells) is decided.
    std::uint64_t decided_volume() const;

    /// Grids visited so far.
    std::uint64_t grids_visited() const { return visited_; }

    /// Nodes that the tree takes so far; it never falls, and in the end it is nodes_needed.
    std::uint32_t nodes_counted() const { return builder_.nodes_counted(); }

    /// The most words of scratch in use at once so far.
    std::uint32_t scratch_used() const { return scratch_used_; }

    /// The tree. Called before step has returned false it gives the conversion up. Status: ok;
    /// scratch_too_small when a list did not fit; pool_exhausted (nodes_missing is 0, for unknown, if given
    /// up); unfinished if given up. When not ok the pool is as it was at begin.
    TreeOutcome finish();

  private:
    static constexpr std::uint8_t no_child = 8;
    struct Frame {
        Point corner;         ///< of the grid's octant
        std::uint32_t first;  ///< word of its list
        std::uint32_t faces;  ///< in the list
        std::uint64_t left;   ///< octants met and not yet visited, in Morton order
        std::uint64_t inside; ///< black ones among the others, in Morton order
        std::uint8_t child;   ///< the open child of the grid's octant
    };
    void visit_root();
    void visit_next();
    void visit(const Point& corner, std::uint32_t first, std::uint32_t faces, std::int32_t winding);
    void open_child(Frame& frame, unsigned child);
    bool select(const Frame& above, unsigned place, std::uint32_t first, std::uint32_t& faces);
    bool reserve(std::uint32_t first, std::uint32_t words);
    void overflow();
    void set_leaves(std::uint64_t may, std::uint64_t must, std::uint64_t open, bool whole);
    void close();
    int level_of(int grid) const { return options_.depth - 2 * (nested_grids(options_.depth) - 1 - grid); }
    bool is_of_eight(int grid) const { return level_of(grid) == 1; }
    std::int32_t offset() const {
        return options_.leaves == LeafRule::centre ? root_side >> (options_.depth + 1) : 0;
    }

    Solid solid_ = {};
    ConvertOptions options_ = {0, LeafRule::conservative, WindingRule::nonzero};
    std::uint32_t* scratch_ = nullptr;
    std::uint32_t scratch_size_ = 0;
    std::uint32_t scratch_used_ = 0;
    std::uint64_t visited_ = 0;
    int grids_ = 0; ///< that lie in one another, the innermost one's frame last
    bool started_ = false;
    bool overflowed_ = false;
    Frame frames_[nested_grids(max_depth) - 1] = {};
    std::uint64_t lanes_[32] = {}; ///< winding numbers being added up, a bit of all 64 each
    TreeBuilder builder_;
};

/// Converts in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
TreeOutcome convert(GridConversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool);

} // namespace osem

#endif
