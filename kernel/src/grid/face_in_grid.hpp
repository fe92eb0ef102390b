// One face against the octants of a grid.
#ifndef OSEM_GRID_FACE_IN_GRID_HPP
#define OSEM_GRID_FACE_IN_GRID_HPP

#include "geometry/plane.hpp"
#include "grid/octant_grid.hpp"
#include "grid/row_windings.hpp"
#include "osem/solid.hpp"

namespace osem {

struct SeenEdge;

/// A face and a grid, which must both outlive it. Cost of making it: O(corners of the face).
class FaceInGrid {
  public:
    static constexpr std::uint32_t scratch_words = 48;

    FaceInGrid(const Solid& solid, std::uint32_t face, const OctantGrid& grid);

    /// The octants of a grid of up to 64 that it meets: as mark. Scratch: 16 + scratch_words words.
    std::uint64_t octants_met(std::uint32_t* scratch) const;

    /// Adds the octants that it meets to a set in rows: as classify of each. Cost for triangles and convex
    /// quadrangles: a few steps for each row of octants that it is seen to meet along x, and for each row of
    /// squares that it is seen to meet along y and z. For other faces: a classification of each octant in the
    /// face's bounding box through which its plane passes. Scratch: scratch_words words.
    void mark(std::uint32_t* rows, std::uint32_t* scratch) const;

    /// Adds what it adds to the winding number on the way from the reference point of the grid's corner
    /// octant to every other one: along z first, then y, then x, as crossing of each step. Cost: a few steps
    /// for each row that it crosses; for other faces than above also each edge for each row of rows. Scratch:
    /// scratch_words.
    void add_crossings(RowWindings& windings, std::uint32_t* scratch) const;

  private:
    class Slabs;
    class Passages;
    bool is_convex(const Plane& plane) const;
    // It must reach beyond both ends of an open interval.
    IndexRange overlapped(int axis) const {
        return grid_.octants_between(axis, low_.at[axis], high_.at[axis]);
    }
    bool is_within(int axis, const IndexRange& range) const;
    int axes_within(const IndexRange (&range)[3]) const;
    bool meets_all_of(const IndexRange (&range)[3]) const {
        return end_ - corners_ == 3 && axes_within(range) > 1;
    }
    IndexRange between(int axis) const { return grid_.points_between(axis, low_.at[axis], high_.at[axis]); }
    void mark_in(const IndexRange (&range)[3], std::uint32_t* rows, std::uint32_t* scratch) const;
    void mark_convex(const Plane& plane, const IndexRange (&range)[3], std::uint32_t* rows,
                     std::uint32_t* scratch) const;
    void mark_all(const IndexRange (&range)[3], std::uint32_t* rows) const;
    void see(int u, int v, const Plane& plane, const IndexRange (&range)[3], Slabs& slabs) const;
    void add_edge(int u, int v, const SeenEdge& edge, bool left, Slabs& slabs) const;
    void classify_octants(const Plane& plane, const IndexRange (&range)[3], std::uint32_t* rows) const;
    void pass(int axis, const IndexRange& along_u, const IndexRange& along_v, RowWindings& windings,
              std::uint32_t* scratch) const;
    void pass_convex(int axis, const IndexRange& along_u, const IndexRange& along_v, Passages& passages,
                     std::uint32_t* scratch) const;
    void pass_any(int axis, const IndexRange& along_u, const IndexRange& along_v, Passages& passages,
                  std::uint32_t* scratch) const;
    void add_ring(std::uint32_t r, int axis, int row, std::int32_t* change) const;

    const Solid& solid_;
    const OctantGrid& grid_;
    std::uint32_t face_;
    std::uint32_t first_ring_;
    std::uint32_t ring_end_;
    const std::uint32_t* corners_;
    const std::uint32_t* end_;
    Point low_;  ///< the least coordinates of the face
    Point high_; ///< the greatest ones
};

} // namespace osem

#endif
