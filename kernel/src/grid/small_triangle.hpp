// Triangles that are small in a grid.
#ifndef OSEM_GRID_SMALL_TRIANGLE_HPP
#define OSEM_GRID_SMALL_TRIANGLE_HPP

#include <cstdint>

namespace osem {

/// Where wrong guesses at branches cost much, triangles that are less than so many octants long along each
/// axis are dealt with apart: each place of a grid in their bounding box is looked at, so that no ends of
/// edges are to be found, which nobody foresees.
constexpr std::int32_t small_octants = 16;

/// The corners of such a triangle: how far they are from a place in or beside the box.
struct SmallTriangle {
    std::int32_t corners[3][3];
};

/// Its plane, as seen from the place that its corners are told from. Its numbers are those that a Plane has:
/// see there for their bounds.
struct SmallPlane {
    std::int64_t normal[3];
    std::int64_t value; ///< at that place

    explicit SmallPlane(const SmallTriangle& triangle) {
        const auto& [a, b, c] = triangle.corners;
        const std::int64_t ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
        const std::int64_t vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
        normal[0] = uy * vz - uz * vy;
        normal[1] = uz * vx - ux * vz;
        normal[2] = ux * vy - uy * vx;
        value = -(normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2]);
    }

    bool has_31_bits() const {
        const auto has = [](std::int64_t number) { return -INT32_MAX <= number && number <= INT32_MAX; };
        return has(normal[0]) && has(normal[1]) && has(normal[2]);
    }
    bool is_line_somewhere() const { return normal[0] == 0 || normal[1] == 0 || normal[2] == 0; }
    /// Without a branch: it is as often the one as the other. Normals are below 2^62.
    int sign(int axis) const { return static_cast<int>(normal[axis] >> 62) | 1; }
};

} // namespace osem

#endif
