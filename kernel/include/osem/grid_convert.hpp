// Boundary to octree conversion by grids of octants: the tree of Conversion in a fraction of its time, for
// more memory and code.
#ifndef OSEM_GRID_CONVERT_HPP
#define OSEM_GRID_CONVERT_HPP

#include <cstdint>

#include "osem/convert.hpp"

namespace osem {

struct FacePlaces;

/// The last grid may divide an octant into 2^5 octants along each axis, or fewer.
constexpr int most_grid_levels = 5;

/// Levels above the last grids, whose octants are the leaves.
constexpr int upper_levels(int depth, int last_levels = most_grid_levels) {
    return depth > last_levels ? depth - last_levels : 0;
}

/// Grids that lie in one another above the last one, from the root down: two levels each, the first one level
/// if their levels are odd.
constexpr int nested_grids(int levels) { return (levels + 1) / 2; }

/// Words that a last grid takes beside its rows: for what is found out about rows and slabs as a face meets
/// them, and then for cubes of leaves. (For the former other grids take as many, among their winding
/// numbers.)
constexpr std::uint32_t last_grid_space(int last_levels) { return last_levels < most_grid_levels ? 48 : 72; }

/// Words of scratch that are always enough. The faces that meet an octant are a list: of one word each where
/// a last grid divides it, otherwise of three words each and 64 behind them (the innermost one 128).
/// Triangles of which it is known beforehand that they matter in one or two of the octants that last grids
/// divide are in no list, but take two words for each of these, throughout. A last grid takes four words
/// (with centre leaves three) for each of its 4^last_levels rows, 48 (or 72, of 5 levels) beside them, and
/// one more a row each time that what winding numbers in a row differ by from its first one outgrows a power
/// of two from 2 on. As a rule it does not, and a list is as long as what meets its octant: 4168 words for 32
/// x 32 rows, 64 for each grid above, about 3.5 a face (2.2 of a fine mesh) and 100 are mostly enough. In 64
/// bits, so that what exceeds the greatest scratch, 2^32 - 1 words, is told and not cut off. Preconditions:
/// depth is in [1, 20], last_levels in [1, 5].
constexpr std::uint64_t grid_scratch(const Solid& solid, int depth, int last_levels = most_grid_levels) {
    const int last = last_levels < depth ? last_levels : depth;
    const auto grids = static_cast<std::uint64_t>(nested_grids(upper_levels(depth, last)));
    // Octants met; rows' first winding numbers; and what others differ by from them, -2 to 1.
    std::uint64_t words_a_row = 4;
    for (std::uint32_t most = solid.corner_count; most > 1; most >>= 1) ++words_a_row;
    const std::uint64_t rows = std::uint64_t{1} << (2 * last);
    const std::uint64_t upper_rows = grids == 0 ? 0 : 16 * words_a_row;
    const std::uint64_t last_grid = rows * words_a_row + last_grid_space(last);
    return std::uint64_t{solid.face_count} * (3 * grids + 1) + 64 * grids +
           (last_grid > upper_rows ? last_grid : upper_rows);
}

/// How the work is cut up.
struct GridOptions {
    int last_levels = most_grid_levels; ///< 1 to 5: the more, the faster, and the more scratch
    Octant octant = root_octant;        ///< what is converted: it is the tree's root
};

/// A conversion in progress: as Conversion, and with the same tree, node for node at the same places of the
/// pool. It holds all of its state, so it may be a static object.
///
/// An octant that faces meet is divided into 4 x 4 x 4 octants at once (the root into 2 x 2 x 2 if the
/// levels above the last grids are odd), and at last into up to 32 x 32 x 32 leaves. Which octants a triangle
/// or a convex quadrangle meets is found row by row: the bounding box, three projections to squares and the
/// plane each leave a range of a row, and their ends go from row to row by additions. So do the places where
/// rows of reference points cross a face; winding numbers are added up a row at once. Of other faces the
/// octants near a ring are classified one by one, and one of each part of the plane between them, if a last
/// grid finds one more word of scratch for each of its rows, which is not counted as used; otherwise each
/// octant is. With centre leaves the reference points are the leaves' centres, so the last
/// grid classifies nothing. See kernel/DESIGN.md.
class GridConversion {
  public:
    /// Starts. Nodes go to `pool`; with a null pool this is a counting pass.
    /// Of an octant other than the root the tree is the subtree below it, of depth options.depth less the
    /// octant's level: so the eight children of an octant may be converted side by side, by a job each.
    /// Scratch: at least a word for each face, grid_scratch(solid.view(), that depth, grids.last_levels)
    /// words for certain; in use until finish. A conversion that was not finished is given up first. Status:
    /// ok; depth_out_of_range, also for last_levels and for an octant that is none or not above full depth;
    /// scratch_too_small for the faces. When not ok, nothing has begun.
    Status begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                 std::uint32_t scratch_size, NodePool* pool, const GridOptions& grids = GridOptions());

    /// Visits up to `grids` grids; false when none is left. Cost of one visit: a pass over the list of the
    /// grid above (the first one: over all faces, and their corners), and three over the faces placed in the
    /// grid's octant; each triangle or convex quadrangle that meets the grid's octant against the rows that
    /// it is seen to meet and to cross; for other faces a classification of each octant near their rings (or
    /// of each near their plane, see above), and each edge against each row of rows; in a last grid also a
    /// few steps a row and leaf on the surface.
    bool step(std::uint32_t grids);

    /// Whether the pool has run out. Going on to the end then finds out the exact number of nodes missing.
    bool exhausted() const { return builder_.exhausted(); }

    /// Exact progress: how much of the octant's volume is decided, in cells of which the root has 2^60.
    std::uint64_t decided_volume() const;

    /// Grids visited so far.
    std::uint64_t grids_visited() const { return visited_; }

    /// Nodes that the tree takes so far; it never falls, and in the end it is nodes_needed.
    std::uint32_t nodes_counted() const { return builder_.nodes_counted(); }

    /// The most words of scratch in use at once so far. The same conversion does with no more, if that is a
    /// word for each face.
    std::uint32_t scratch_used() const { return scratch_used_ + placed_words(); }

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
        std::uint32_t placed; ///< faces placed from the beginning: the first one that meets octants left
        std::uint32_t placed_end;
        std::uint64_t left;   ///< octants met and not yet visited, in Morton order
        std::uint64_t inside; ///< black ones among the others, in Morton order
        std::uint8_t child;   ///< the open child of the grid's octant
    };
    struct Entry {
        Point corner;         ///< of the octant entered
        std::uint32_t first;  ///< word of its list
        std::uint32_t faces;  ///< in the list
        std::uint32_t placed; ///< the first face placed in it, and the end
        std::uint32_t placed_end;
        std::int32_t winding; ///< number of its reference point
    };
    bool enter_root(Entry& entry);
    bool list_or_place(std::uint32_t face, const FacePlaces& places, Entry& root);
    bool enter_next(Entry& entry);
    void visit(const Entry& entry);
    void open_child(Frame& frame, unsigned child);
    void visit_last(const Entry& entry);
    bool select(const Frame& above, unsigned place, Entry& entry);
    bool reserve(std::uint32_t first, std::uint32_t words);
    void overflow();
    void close();
    int levels() const { return options_.depth - octant_.level; }
    int levels_above() const { return levels() - last_levels_; } ///< of the last grid
    int level_of(int grid) const {
        return octant_.level + levels_above() - 2 * (nested_grids(levels_above()) - 1 - grid);
    }
    bool is_of_eight(int grid) const { return level_of(grid) == octant_.level + 1; }
    std::uint32_t placed_words() const { return scratch_size_ - room_; }
    int levels_below(int grid) const { return octant_.level + levels_above() - level_of(grid); }
    bool is_last() const { return grids_ == nested_grids(levels_above()); }
    std::int32_t offset() const {
        return options_.leaves == LeafRule::centre ? root_side >> (options_.depth + 1) : 0;
    }

    Solid solid_ = {};
    ConvertOptions options_ = {0, LeafRule::conservative, WindingRule::nonzero};
    std::uint32_t* scratch_ = nullptr;
    std::uint32_t scratch_size_ = 0;
    std::uint32_t scratch_used_ = 0;
    std::uint32_t room_ = 0; ///< words of scratch in front of the placed faces
    std::uint64_t visited_ = 0;
    Octant octant_ = root_octant;
    int last_levels_ = 0;
    int grids_ = 0; ///< that lie in one another, the innermost one's frame last
    bool started_ = false;
    bool overflowed_ = false;
    Frame frames_[nested_grids(max_depth - 1)] = {};
    TreeBuilder builder_;
};

/// Converts in one call: begin, step to the end, finish; status and cost are theirs. `job` is the working
/// memory.
TreeOutcome convert(GridConversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool,
                    const GridOptions& grids = GridOptions());

} // namespace osem

#endif
