// Which reference points are behind the plane of a triangle that is small in a grid, on rays along x.
#ifndef OSEM_GRID_POINTS_BEHIND_HPP
#define OSEM_GRID_POINTS_BEHIND_HPP

#include <cstdint>

#include "grid/edge_functions.hpp"
#include "grid/four.hpp"
#include "grid/octant_grid.hpp"
#include "grid/small_triangle.hpp"
#include "grid/stair.hpp"

namespace osem {

/// On rays in four rows beside each other: first in those that the plane's value belongs to, then further
/// along z; then in the next four. Behind is where the normal points to, or away from if it points back along
/// x; what is on the plane is behind it. Where the triangle is seen its plane is where it is, so that numbers
/// modulo 2^32 are the numbers themselves; of other rays nothing is said. There are two ways to it.
///
/// By quotients, of which each tells the last point before the plane.
class PointsBehindByQuotients {
  public:
    /// The plane as seen from point `first` along x. Precondition: it is not seen as a line, and has 31 bits.
    PointsBehindByQuotients(const SmallPlane& plane, const OctantGrid& grid, int first)
        : PointsBehindByQuotients(plane, plane.sign(axis_x), grid, first) {}

    /// It goes by itself from ray to ray.
    static LinearFunction function() { return {0, 0, 0}; }
    void begin_four() { last_.begin_four(); }
    void next() { last_.next(); }

    /// Sets the sign of rays on which all points of the grid are behind, and of some on which none is.
    void leave_out(Four& rays, const Four& /*value*/) const {
        rays |= last_.values() | (most_ - 1 - last_.values());
    }
    /// A bit for each point behind; for none on rays of which all bits are set. There may be bits above those
    /// of the grid if its last point is behind.
    void see(Four& behind, const Four& left_out, const Four& /*value*/) const {
        set_bits_above(behind, left_out | last_.values());
    }

  private:
    PointsBehindByQuotients(const SmallPlane& plane, std::int64_t turn, const OctantGrid& grid, int first)
        : last_(turn * plane.normal[axis_x],
                ~((turn * plane.value) >> grid.shift) + first * turn * plane.normal[axis_x],
                -turn * plane.normal[axis_z], -turn * plane.normal[axis_y]),
          most_(static_cast<std::uint32_t>(grid.side() - 1)) {}

    FourStairs last_;
    std::uint32_t most_;
};

/// By the sign of the plane's value at some points, where it is known that the plane is nowhere else.
class PointsBehindBySigns {
  public:
    static constexpr int points = 4;

    /// Whether they are all of the points of a grid that the triangle is around, so many, and numbers fit,
    /// where it is around so many in the grid or beyond: from a crossing to a point asked it is less than
    /// `points` octants more than that. Precondition: it is not beside the grid along x.
    static bool suffice(const SmallPlane& plane, int in_grid, std::int64_t around) {
        const std::int64_t across = plane.normal[axis_x] < 0 ? -plane.normal[axis_x] : plane.normal[axis_x];
        return in_grid <= points && across * (around + points) <= INT32_MAX;
    }

    /// The plane as seen from point `first` along x. Preconditions: it is not seen as a line; the points
    /// asked are the grid's, all of it that it is around along x among them, and they suffice.
    PointsBehindBySigns(const SmallPlane& plane, const OctantGrid& grid, int first)
        : plane_(plane),
          by_x_(Four{} + static_cast<std::uint32_t>(plane.sign(axis_x) * plane.normal[axis_x])),
          first_of_grid_(Four{} + (first == 0 ? sign : 0)),
          beyond_grid_(Four{} + ~(~std::uint32_t{0} >> (32 - grid.side()))),
          down_(32 - static_cast<unsigned>(points + first)) {}

    /// Below 0 before the plane, if it is negated where the normal points along x.
    LinearFunction function() const {
        return {-plane_.value, -plane_.normal[axis_z], -plane_.normal[axis_y]};
    }
    void begin_four() const {}
    void next() const {}

    void leave_out(Four& rays, const Four& value) const { rays |= ~value & first_of_grid_; }
    void see(Four& behind, const Four& left_out, const Four& value) const {
        Four now = value;
        Four before = ~Four{}; // as the points below those asked are
        for (int point = 0; point < points; ++point) {
            before = before >> 1 | (now & sign);
            now += by_x_;
        }
        behind = ~(before >> down_ | beyond_grid_ | left_out);
    }

  private:
    static constexpr std::uint32_t sign = std::uint32_t{1} << 31;

    const SmallPlane& plane_;
    Four by_x_;
    Four first_of_grid_; ///< the sign, if the first point asked is the grid's
    Four beyond_grid_;   ///< the bits that stand for none of its points
    unsigned down_;
};

} // namespace osem

#endif
