#include "solids.hpp"

#include <cstddef>

namespace osem::cross {

namespace {

// One solid at a time is built here.
Point built_vertices[most_vertices];
std::uint32_t built_corners[most_corners * 2];

constexpr std::uint32_t octahedron_corners[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                                  2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

void place_octahedron(const Point& centre, std::int32_t radius, Point* vertices) {
    for (unsigned v = 0; v < 6; ++v) {
        vertices[v] = centre;
        vertices[v].at[v / 2] += v % 2 == 0 ? radius : -radius;
    }
}

// The sign of the volume that four points span.
int orientation_of(const Point* p) {
    std::int64_t d[3][3];
    for (int row = 0; row < 3; ++row) {
        for (int axis = 0; axis < 3; ++axis) d[row][axis] = p[row + 1].at[axis] - p[0].at[axis];
    }
    // Differences are at most 2^20: six products of three of them stay below 2^63.
    const std::int64_t volume = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                                d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                                d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    return volume < 0 ? -1 : volume > 0 ? 1 : 0;
}

// The profile of the plate: an L, and a square hole in its thick part, swept along a slanted way.
constexpr std::int32_t profile[10][2] = {{0, 0}, {8, 0}, {8, 3}, {4, 3}, {4, 8},
                                         {0, 8}, {1, 1}, {1, 2}, {3, 2}, {3, 1}};
constexpr std::uint32_t plate_rings[] = {0, 6, 10, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60};
constexpr std::uint32_t plate_faces[] = {0, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};

} // namespace

Solid plate() {
    for (unsigned v = 0; v < 20; ++v) {
        const std::int32_t u = profile[v % 10][0];
        const std::int32_t w = profile[v % 10][1];
        const std::int32_t h = v / 10 == 0 ? 0 : 5;
        built_vertices[v] = Point{{120011 + 61007 * u + 10009 * w + 20011 * h,
                                   100003 + 5003 * u + 70001 * w + 9001 * h, 90001 + 15013 * u + 90017 * h}};
    }
    std::uint32_t* corner = built_corners;
    // The bottom, seen from below, and the top.
    for (std::uint32_t i = 0; i < 6; ++i) *corner++ = 5 - i;
    for (std::uint32_t i = 0; i < 4; ++i) *corner++ = 9 - i;
    for (std::uint32_t i = 0; i < 10; ++i) *corner++ = 10 + i;
    // A side for each edge of the profile, around each of its rings.
    for (std::uint32_t i = 0; i < 10; ++i) {
        const std::uint32_t next = i == 5 ? 0 : i == 9 ? 6 : i + 1;
        *corner++ = i;
        *corner++ = next;
        *corner++ = next + 10;
        *corner++ = i + 10;
    }
    return Solid{built_vertices, 20, built_corners, 60, plate_rings, plate_faces, 12};
}

Solid octahedron() {
    place_octahedron(Point{{500009, 520021, 480013}}, 400009, built_vertices);
    return triangle_mesh(built_vertices, 6, octahedron_corners, 8);
}

Solid nested_shells() {
    place_octahedron(Point{{524287, 500001, 510007}}, 450001, built_vertices);
    place_octahedron(Point{{510001, 510007, 500003}}, 260003, built_vertices + 6);
    for (unsigned i = 0; i < 24; ++i) {
        built_corners[i] = octahedron_corners[i];
        built_corners[24 + i] = octahedron_corners[i] + 6;
    }
    built_vertices[12] = Point{{450001, 450001, 450001}};
    built_vertices[13] = Point{{560003, 460007, 470003}};
    built_vertices[14] = Point{{470003, 570001, 460001}};
    built_vertices[15] = Point{{480001, 470011, 580001}};
    constexpr std::uint32_t inner[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    for (unsigned i = 0; i < 12; ++i) built_corners[48 + i] = 12 + inner[i];
    return triangle_mesh(built_vertices, 16, built_corners, 20);
}

Solid tetrahedra(std::uint32_t seed, const Point& low, std::int32_t side) {
    Random random(seed);
    constexpr std::uint32_t faces_of[2][12] = {{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                                               {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}};
    constexpr std::uint32_t count = most_corners / 12;
    for (std::uint32_t t = 0; t < count; ++t) {
        Point* p = &built_vertices[std::size_t{4} * t];
        for (int v = 0; v < 4; ++v) {
            for (int axis = 0; axis < 3; ++axis) p[v].at[axis] = low.at[axis] + random.below(side + 1);
        }
        // Every third one is turned inside out; a flat one may face either way.
        const bool flip = (orientation_of(p) < 0) != (t % 3 == 2);
        for (unsigned i = 0; i < 12; ++i) built_corners[12 * t + i] = 4 * t + faces_of[flip ? 1 : 0][i];
    }
    return triangle_mesh(built_vertices, 4 * count, built_corners, 4 * count);
}

void add(Digest& digest, const TreeOutcome& outcome) {
    digest.add(outcome.status);
    digest.add(outcome.nodes_needed);
    digest.add(outcome.nodes_missing);
    if (outcome.status != Status::ok) return;
    digest.add(outcome.tree.depth);
    digest.add(osem::digest(outcome.tree));
}

} // namespace osem::cross
