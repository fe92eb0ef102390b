// Triangles that are small in a grid.
#ifndef OSEM_GRID_SMALL_TRIANGLE_HPP
#define OSEM_GRID_SMALL_TRIANGLE_HPP

#include <cstdint>

#include "grid/four.hpp"
#include "grid/octant_grid.hpp"
#include "osem/solid.hpp"

namespace osem {

/// Where wrong guesses at branches cost much, triangles that are less than so many octants long along each
/// axis are dealt with apart: each place of a grid in their bounding box is looked at, so that no ends of
/// edges are to be found, which nobody foresees.
constexpr std::int32_t small_octants = 16;

/// Such a triangle: how far a corner of it is from a place in or beside the box, and how far the next two are
/// from that corner, along x, y, again y, and z.
struct SmallTriangle {
    FourSigned corner;
    FourSigned to_second;
    FourSigned to_third;
};

/// Tells a triangle from the minimum corner of an octant, which is given by its indices along x, y, again y,
/// and z, moved by `further` along each axis.
[[gnu::always_inline]] inline SmallTriangle small_triangle(const Solid& solid, const std::uint32_t* corners,
                                                           const OctantGrid& grid, const FourSigned& octant,
                                                           std::int32_t further) {
    FourSigned place;
    load(place, grid.corner);
    place += (octant << grid.shift) + further;
    SmallTriangle triangle;
    load(triangle.corner, solid.vertices[corners[0]]);
    load(triangle.to_second, solid.vertices[corners[1]]);
    load(triangle.to_third, solid.vertices[corners[2]]);
    triangle.to_second -= triangle.corner;
    triangle.to_third -= triangle.corner;
    triangle.corner -= place;
    return triangle;
}

/// How far it is along an axis from each of its corners to the next one; the last number is any.
template <int axis>
[[gnu::always_inline]] inline void set_sides(FourSigned& sides, const SmallTriangle& triangle) {
    constexpr auto place = static_cast<int>(place_of_axis(axis));
    const FourSigned second_to_third = triangle.to_third - triangle.to_second;
    const FourSigned to_first = -triangle.to_third;
    FourSigned two = {};
    pick<place, place, place + 4, place + 4>(two, triangle.to_second, second_to_third);
    pick<0, 2, place + 4, place + 4>(sides, two, to_first);
}

/// Its plane, as seen from the place that its corners are told from. Its numbers are those that a Plane has:
/// see there for their bounds.
struct SmallPlane {
    std::int64_t normal[3];
    std::int64_t value; ///< at that place

    [[gnu::always_inline]] explicit SmallPlane(const SmallTriangle& triangle) {
        const auto along = [](const FourSigned& numbers, int axis) -> std::int64_t {
            return numbers[place_of_axis(axis)];
        };
        const auto across = [&](int i, int j) {
            return along(triangle.to_second, i) * along(triangle.to_third, j) -
                   along(triangle.to_second, j) * along(triangle.to_third, i);
        };
        normal[axis_x] = across(axis_y, axis_z);
        normal[axis_y] = across(axis_z, axis_x);
        normal[axis_z] = across(axis_x, axis_y);
        value = -(normal[axis_x] * along(triangle.corner, axis_x) +
                  normal[axis_y] * along(triangle.corner, axis_y) +
                  normal[axis_z] * along(triangle.corner, axis_z));
    }

    /// Whether its normal's numbers have no more, of a triangle that is small among octants whose side is
    /// 2^shift: they are less than twice the square of its length, so mostly one need not look.
    bool has_31_bits(int shift) const {
        constexpr int none_has_more = 11;
        static_assert(2 * (std::int64_t{small_octants} << none_has_more) * (small_octants << none_has_more) ==
                          std::int64_t{INT32_MAX} + 1,
                      "twice the square of the length");
        if (shift <= none_has_more) return true;
        const auto has = [](std::int64_t number) { return -INT32_MAX <= number && number <= INT32_MAX; };
        return has(normal[0]) && has(normal[1]) && has(normal[2]);
    }
    bool is_line_somewhere() const { return normal[0] == 0 || normal[1] == 0 || normal[2] == 0; }
    /// Without a branch: it is as often the one as the other. Normals are below 2^62.
    int sign(int axis) const { return static_cast<int>(normal[axis] >> 62) | 1; }
};

} // namespace osem

#endif
