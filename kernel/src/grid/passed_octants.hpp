// The octants of a grid through which a plane passes.
#ifndef OSEM_GRID_PASSED_OCTANTS_HPP
#define OSEM_GRID_PASSED_OCTANTS_HPP

#include <cstdint>

#include "geometry/plane.hpp"
#include "grid/octant_grid.hpp"
#include "grid/stair.hpp"

namespace osem {

/// The octants of the rows along x through which a plane passes, row by row. The normal is turned so that it
/// does not point down: then the first of a row's octants that reaches above the plane and the last one that
/// reaches below it bound them. Across x it counts as 1: then a row has all of its octants between the two,
/// or none. Dividends are at most 3 * (2^61 + 2^41), divided by the octants' side or not; their changes are
/// 2^41 at most, and fewer than 100 are added.
class PassedOctants {
  public:
    PassedOctants(const Plane& plane, const OctantGrid& grid, int guess)
        : PassedOctants(plane, grid, guess, plane.normal(0).value() < 0 ? -1 : 1) {}

    /// First and last of the rows from (j, k) on.
    PlaneBand at(int j, int k) { return rows_.at(j, k); }

  private:
    PassedOctants(const Plane& plane, const OctantGrid& grid, int guess, int turn)
        : PassedOctants(turn * plane.at(grid.corner).value(), turn * plane.normal(0).value(),
                        turn * plane.normal(1).value(), turn * plane.normal(2).value(), grid, guess) {}

    // From the value at the grid's corner. The first octant reaches above the plane where all steps lead that
    // rise, the last one below it where those lead that fall.
    PassedOctants(std::int64_t at_corner, std::int64_t step_x, std::int64_t step_y, std::int64_t step_z,
                  const OctantGrid& grid, int guess)
        : PassedOctants((-at_corner >> grid.shift) - rise(step_y) - rise(step_z),
                        ~(at_corner >> grid.shift) + rise(-step_y) + rise(-step_z), step_x > 0 ? step_x : 1,
                        -step_y, -step_z, grid.side(), guess) {}

    PassedOctants(std::int64_t first, std::int64_t last, std::int64_t d, std::int64_t by_y, std::int64_t by_z,
                  int side, int guess)
        : rows_({d, by_y, last - first}, first, by_y, by_z, side, guess) {}

    static std::int64_t rise(std::int64_t step) { return step > 0 ? step : 0; }

    OverPlane<PlaneBand> rows_;
};

/// Those of one row: of a range along x, which is not empty.
inline std::uint32_t passed_in_row(const Plane& plane, const IndexRange& x, const PlaneBand& row) {
    if (plane.normal(0).value() != 0) return row.bits(x);
    return row.floor() < 0 && row.bits({0, 0}) != 0 ? x.bits() : 0;
}

/// Rows one after the other along y, in layers one after the other along z: from each row to the next by
/// additions.
class PassedRows {
  public:
    PassedRows(const Plane& plane, const OctantGrid& grid, const IndexRange& x)
        : passed_(plane, grid, x.first), row_(passed_.at(0, 0)) {}

    void begin_layer(int j, int k) { row_ = passed_.at(j, k); }
    /// Those of row (j, k), which is the layer's next one. All but that is as before.
    std::uint32_t next(const Plane& plane, const OctantGrid& /*grid*/, const IndexRange& x, int /*j*/,
                       int /*k*/) {
        const std::uint32_t octants = passed_in_row(plane, x, row_);
        row_.next();
        return octants;
    }

  private:
    PassedOctants passed_;
    PlaneBand row_;
};

/// The same, each row anew: it holds nothing, and what it needs is on the stack for as long as a row takes.
class PassedRowsAnew {
  public:
    PassedRowsAnew(const Plane& /*plane*/, const OctantGrid& /*grid*/, const IndexRange& /*x*/) {}

    void begin_layer(int /*j*/, int /*k*/) const {}
    static std::uint32_t next(const Plane& plane, const OctantGrid& grid, const IndexRange& x, int j, int k);
};

} // namespace osem

#endif
