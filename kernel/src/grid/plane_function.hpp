// Octants of a grid through which the plane of a triangle passes that is small in it.
#ifndef OSEM_GRID_PLANE_FUNCTION_HPP
#define OSEM_GRID_PLANE_FUNCTION_HPP

#include <cstdint>

#include "grid/four.hpp"
#include "grid/small_triangle.hpp"

namespace osem {

/// A plane's value is linear as well, so from octant to octant of a row, from row to row and from layer to
/// layer it goes by additions; it is divided by the octants' side, rounded down. From an octant's lower
/// corner it rises and falls by the same numbers to where it is greatest and least: so the plane passes
/// through the octant if the greatest one is above 0 and no more than that rise and fall. Four rows go side
/// by side, modulo 2^32: numbers fit where the triangle could be met, and elsewhere do not matter.
class PlaneFunction {
  public:
    /// For rows of 1 to 32 octants, from the one on to whose lower corner the plane's value belongs.
    PlaneFunction(const SmallPlane& plane, int shift, std::uint32_t octants)
        : PlaneFunction(plane.value, plane.normal[0], plane.normal[1], plane.normal[2], shift, octants) {}

    /// Whether numbers do fit for the octants of rows that hold a point of the plane to which each octant's
    /// lower corner is nearer than so many octants along x. The greatest value is then at most so many times
    /// the change along x, and once more the rise and the fall, from 0; for an octant that the plane is
    /// above it stays below 0 by less than 2^32 less what it is compared with, which is the rise and the
    /// fall.
    bool fits(std::int64_t octants) const { return octants * across_ + 2 * rise_and_fall_ < UINT32_MAX; }

    /// Through which octants of four rows it passes, from a row on of a layer: a bit for each, the first one
    /// lowest.
    void see_four(std::uint32_t row, std::uint32_t layer, Four& passed) const {
        Four values = at_last_ + (row * by_row_ + layer * by_layer_);
        const Four end = Four{} + end_;
        passed = Four{};
        for (std::uint32_t left = octants_; left != 0; --left) {
            Four is_passed = {};
            set_where_below(is_passed, values, end);
            passed += passed - is_passed; // one bit more, as all bits are -1
            values -= by_x_;
        }
    }

  private:
    // Added to numbers, so that comparing them with a sign is comparing without one: none below 0 is below
    // the end.
    static constexpr std::uint32_t least = std::uint32_t{1} << 31;

    PlaneFunction(std::int64_t at_corner, std::int64_t by_x, std::int64_t by_y, std::int64_t by_z, int shift,
                  std::uint32_t octants)
        : across_(by_x < 0 ? -by_x : by_x), by_x_(static_cast<std::uint32_t>(by_x)),
          by_row_(static_cast<std::uint32_t>(by_y)), by_layer_(static_cast<std::uint32_t>(by_z)),
          octants_(octants) {
        const std::int64_t rise = up(by_x) + up(by_y) + up(by_z);
        rise_and_fall_ = rise + up(-by_x) + up(-by_y) + up(-by_z);
        // A number is above 0 where it is not below 0 when 1 is taken away.
        const std::int64_t greatest = ((at_corner - 1) >> shift) + rise;
        const std::int64_t end = rise_and_fall_ + ((at_corner - 1) >> shift) - (at_corner >> shift);
        end_ = static_cast<std::uint32_t>(end) + least;
        set_multiples(at_last_, Four{} + by_row_);
        at_last_ += static_cast<std::uint32_t>(greatest) + (octants - 1) * by_x_ + least;
    }

    static std::int64_t up(std::int64_t step) { return step > 0 ? step : 0; }

    Four at_last_; ///< of the last octants of the first four rows
    std::int64_t across_;
    std::int64_t rise_and_fall_;
    std::uint32_t by_x_;
    std::uint32_t by_row_;
    std::uint32_t by_layer_;
    std::uint32_t octants_;
    std::uint32_t end_;
};

} // namespace osem

#endif
