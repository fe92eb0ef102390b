// A slanted plate with a square hole: rings with holes, and planes that the octants' sides are not parallel
// to.
#ifndef OSEM_CROSS_PLATE_HPP
#define OSEM_CROSS_PLATE_HPP

#include <cstdint>

#include "osem/solid.hpp"

namespace osem::cross {

constexpr Point at_foot(std::int32_t x, std::int32_t y) { return {{x, y, 200000 + x / 2}}; }
constexpr Point at_head(std::int32_t x, std::int32_t y) { return {{x, y, 400000 + x / 2}}; }
constexpr Point plate_vertices[] = {
    at_foot(100000, 100000), at_foot(900000, 100000), at_foot(900000, 900000), at_foot(100000, 900000),
    at_foot(300000, 300000), at_foot(700000, 300000), at_foot(700000, 700000), at_foot(300000, 700000),
    at_head(100000, 100000), at_head(900000, 100000), at_head(900000, 900000), at_head(100000, 900000),
    at_head(300000, 300000), at_head(700000, 300000), at_head(700000, 700000), at_head(300000, 700000)};
constexpr std::uint32_t plate_corners[] = {8, 9,  10, 11, 12, 15, 14, 13, // top and its hole
                                           0, 3,  2,  1,  4,  5,  6,  7,  // bottom and its hole
                                           0, 1,  9,  8,  1,  2,  10, 9,  2, 3,  11, 10, 3, 0,  8,  11,
                                           4, 12, 13, 5,  5,  13, 14, 6,  6, 14, 15, 7,  7, 15, 12, 4};
constexpr std::uint32_t plate_rings[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48};
constexpr std::uint32_t plate_faces[] = {0, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12};
constexpr Solid plate = {plate_vertices, 16, plate_corners, 48, plate_rings, plate_faces, 10};

} // namespace osem::cross

#endif
