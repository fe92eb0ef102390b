// One face against the octants of a grid.
#ifndef OSEM_GRID_FACE_IN_GRID_HPP
#define OSEM_GRID_FACE_IN_GRID_HPP

#include "geometry/plane.hpp"
#include "grid/extent.hpp"
#include "grid/octant_grid.hpp"
#include "grid/row_windings.hpp"
#include "grid/small_triangle.hpp"
#include "osem/grid_convert.hpp"
#include "osem/solid.hpp"
#include "tree/guesses.hpp"

namespace osem {

struct SeenEdge;

/// A face and a grid, which must both outlive it. Precondition: its extent overlaps the octant that the grid
/// makes up. Cost of making it: O(corners of the face).
class FaceInGrid {
  public:
    FaceInGrid(const Solid& solid, std::uint32_t face, const OctantGrid& grid)
        : solid_(solid), grid_(grid), face_(face), first_ring_(solid.first_ring(face)),
          ring_end_(solid.end_ring(face)), corners_(solid.corners + solid.first_corner(first_ring_)),
          end_(solid.corners + solid.first_corner(ring_end_)), extent_(solid, corners_, end_),
          plane_(extent_.low) {}

    /// The octants of a grid of up to 64 that it meets: as mark. Scratch: 16 + last_grid_space(levels).
    std::uint64_t octants_met(std::uint32_t* scratch) {
        Index index = {};
        if (is_in_one(index)) return std::uint64_t{1} << (index.at[0] + 4 * index.at[1] + 16 * index.at[2]);
        return octants_of_many(scratch);
    }

    /// Adds the octants that it meets to a set in rows: as classify of each. Cost for triangles and convex
    /// quadrangles: a few steps for each row of octants that it is seen to meet along x, and for each row of
    /// squares that it is seen to meet along y and z. For other faces: a classification of each octant in the
    /// face's bounding box through which its plane passes; or, with a word for each row of the grid in
    /// `near_rings`, which may be null, of those near a ring and of one for each range of a row between them.
    /// Scratch: last_grid_space(levels).
    void mark(std::uint32_t* rows, std::uint32_t* scratch, std::uint32_t* near_rings) {
        Index index = {};
        if (is_in_one(index)) {
            rows[grid_.row(index.at[1], index.at[2])] |= std::uint32_t{1} << index.at[0];
        } else {
            mark_many(rows, scratch, near_rings);
        }
    }

    /// Adds what it adds to the winding number on the way from the reference point of the grid's corner
    /// octant to every other one: along y first, then z, then x, as crossing of each step. Cost: a few steps
    /// for each row that it crosses; for other faces than above also each edge for each row of rows. Scratch:
    /// last_grid_space(levels).
    void add_crossings(RowWindings& windings, std::uint32_t* scratch) {
        // A ray is between the face's ends along both other axes: as those of few small faces are.
        if (int{has_between(axis_x)} + int{has_between(axis_y)} + int{has_between(axis_z)} < 2) return;
        const bool is_passed =
            guesses_cost_much && is_small() && pass_small(solid_, face_, grid_, windings, scratch);
        if (!is_passed) pass_all(windings, scratch);
    }

    /// The same of a face that need not be made one in the grid for that, as small triangles need not. False,
    /// and nothing added, of others. Precondition: as of making it.
    static bool has_added_crossings(const Solid& solid, std::uint32_t face, const OctantGrid& grid,
                                    RowWindings& windings, std::uint32_t* scratch) {
        return guesses_cost_much && pass_small(solid, face, grid, windings, scratch);
    }

  private:
    class Slabs;
    struct RaysThroughPlane;
    class Passages;
    class FixedPassages;
    class RowOfRings;
    struct Index {
        std::int32_t at[3];
    };
    // The octants that its bounding box overlaps; and the axes along which it lies between the ends of the
    // only interval.
    struct Ranges {
        IndexRange along[3];
        unsigned within; // a bit for each of these axes

        const IndexRange& operator[](int axis) const { return along[axis]; }
        bool is_within(int axis) const { return (within >> axis & 1U) != 0; }
        bool is_within_two() const { return within == 3 || within >= 5; }
    };
    Ranges ranges() const;
    // The octants into which its ends reach along an axis, in the grid or beyond.
    [[gnu::always_inline]] std::int32_t first_octant(int axis) const {
        return (extent_.low.at[axis] - grid_.corner.at[axis]) >> grid_.shift;
    }
    [[gnu::always_inline]] std::int32_t last_octant(int axis) const {
        return (extent_.high.at[axis] - 1 - grid_.corner.at[axis]) >> grid_.shift;
    }
    // Whether it meets one octant and lies between its sides. A triangle has its inner points there; longer
    // rings may have none.
    bool is_in_one(Index& index) const {
        std::int32_t differing = is_triangle() ? 0 : 1;
        for (int axis = 0; axis < 3; ++axis) {
            index.at[axis] = first_octant(axis);
            differing |= index.at[axis] ^ last_octant(axis);
        }
        OSEM_ASSERT(differing != 0 || (index.at[0] | index.at[1] | index.at[2]) >> grid_.levels == 0);
        return differing == 0;
    }
    bool is_triangle() const { return end_ - corners_ == 3; }
    std::uint64_t octants_of_many(std::uint32_t* scratch);
    // Its plane is made when it is asked for first: most faces do without.
    const Plane& plane() {
        if (!has_plane_) plane_ = Plane(solid_, corners_, end_);
        has_plane_ = true;
        return plane_;
    }
    bool is_convex();
    // Whether there are reference points between its ends along an axis, in the grid or beyond.
    [[gnu::always_inline]] bool has_between(int axis) const {
        const std::int32_t first = grid_.corner.at[axis] + grid_.offset;
        return (extent_.low.at[axis] - 1 - first) >> grid_.shift !=
               (extent_.high.at[axis] - 1 - first) >> grid_.shift;
    }
    IndexRange between(int axis) const {
        return grid_.points_between(axis, extent_.low.at[axis], extent_.high.at[axis]);
    }
    // How corners of a convex face are seen to turn along an axis: 1 for to the left; 0 if it is seen as a
    // line.
    [[gnu::always_inline]] static int turn_of(const Plane& plane, int axis) {
        const int sign = plane.normal(axis).sign();
        return axis == axis_y ? -sign : sign; // (x, z) is left-handed
    }
    void mark_many(std::uint32_t* rows, std::uint32_t* scratch, std::uint32_t* near_rings);
    void mark_convex(const Plane& plane, const Ranges& range, std::uint32_t* rows,
                     std::uint32_t* scratch) const;
    // Whether it is a small triangle, in a grid that has four rows beside each other.
    bool is_small() const {
        const std::int32_t lengths = extent_.length(axis_x) | extent_.length(axis_y) | extent_.length(axis_z);
        return is_triangle() && grid_.levels >= 2 && lengths >> grid_.shift < small_octants;
    }
    bool mark_small(const Ranges& range, std::uint32_t* rows, std::uint32_t* scratch) const;
    void mark_all(const Ranges& range, std::uint32_t* rows) const;
    void see(int u, int v, const Plane& plane, const Ranges& range, Slabs& slabs) const;
    void add_edges(int u, int v, bool rising_right, Slabs& slabs) const;
    inline void add_edge(int u, int v, const SeenEdge& edge, bool right, Slabs& slabs) const;
    // Octants of a row that are away from rings, and those of them that are met.
    struct Settled {
        std::uint32_t away;
        std::uint32_t met;
    };
    void mark_any(const Plane& plane, const Ranges& range, std::uint32_t* rows, std::uint32_t* scratch,
                  std::uint32_t* near_rings) const;
    Settled settled(std::uint32_t away, const Settled& before, const Settled& below, int j, int k) const;
    void classify_each(std::uint32_t octants, int j, int k, std::uint32_t* rows) const;
    bool meets(int i, int j, int k) const;
    void find_near_rings(std::uint32_t* near_rings) const;
    void find_near_edge(const Point& a, const Point& b, std::uint32_t* near_rings) const;
    void pass_all(RowWindings& windings, std::uint32_t* scratch);
    static bool pass_small(const Solid& solid, std::uint32_t face, const OctantGrid& grid,
                           RowWindings& windings, std::uint32_t* scratch);
    void pass(int axis, const IndexRange& along_u, const IndexRange& along_v, RowWindings& windings,
              std::uint32_t* scratch);
    template <class AnyPassages>
    void pass_convex(int axis, const IndexRange& along_u, const IndexRange& along_v, AnyPassages& passages,
                     std::uint32_t* scratch) const;
    template <class AnyPassages>
    void pass_any(int axis, const IndexRange& along_u, const IndexRange& along_v, AnyPassages& passages,
                  std::uint32_t* scratch) const;
    std::uint32_t rings_not_crossed(int axis, const IndexRange& along_v) const;
    void cross_ring(std::uint32_t r, int axis, int row, RowOfRings& rings) const;

    const Solid& solid_;
    const OctantGrid& grid_;
    std::uint32_t face_;
    std::uint32_t first_ring_;
    std::uint32_t ring_end_;
    const std::uint32_t* corners_;
    const std::uint32_t* end_;
    Extent extent_;
    Plane plane_;
    bool has_plane_ = false;
};

} // namespace osem

#endif
