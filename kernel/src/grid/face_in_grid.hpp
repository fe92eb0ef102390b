// One face against the 64 octants of a grid at once.
#ifndef OSEM_GRID_FACE_IN_GRID_HPP
#define OSEM_GRID_FACE_IN_GRID_HPP

#include "geometry/plane.hpp"
#include "grid/linear.hpp"
#include "grid/octant_grid.hpp"
#include "grid/winding_lanes.hpp"
#include "osem/solid.hpp"

namespace osem {

/// Rays along an axis from the grid's first reference points along it: those that may pass through a face.
struct GridRays {
    Squares seen[3]; ///< as squares seen along each axis

    bool none() const { return seen[0].empty() && seen[1].empty() && seen[2].empty(); }
};

/// A face and a grid, which must both outlive it. Costs: O(corners of the face).
class FaceInGrid {
  public:
    FaceInGrid(const Solid& solid, std::uint32_t face, const OctantGrid& grid);

    /// Whether it lies in a plane between octants of the grid. If no face that meets a grid's octant does,
    /// two octants side by side that no face meets are on the same side of the surface.
    bool is_between_octants() const;

    /// The octants of the grid that it meets: as classify of each. Cost unless it is a triangle or a convex
    /// quadrangle: a classification of each octant that the face's bounding box overlaps.
    std::uint64_t octants_met() const;

    /// Adds what it adds to the winding number on the way from the reference point of the grid's corner
    /// octant to every other one: along z first, then y, then x, as crossing of each step.
    void add_crossings(WindingLanes& windings) const;

  private:
    int corner_count() const { return static_cast<int>(end_ - corners_); }
    bool is_convex(const Plane& plane) const;
    IndexRange overlapped(int axis) const;
    bool is_within(int axis, const IndexRange& range) const;
    IndexRange between(int axis) const;
    GridRays rays() const;
    std::uint64_t classified(const IndexRange (&range)[3]) const;
    void cut_squares(const Plane& plane, const IndexRange (&range)[3], int first_axis, int end_axis,
                     unsigned (&met)[3]) const;
    void add_along(int axis, const Plane& plane, const Squares& squares, WindingLanes& windings) const;
    void add_ray_by_ray(const GridRays& rays, WindingLanes& windings) const;

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
