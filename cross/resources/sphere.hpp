// A sphere of 768 triangles on the lattice, made by the compiler, so that its tables lie in flash: a cube's
// six sides of 8 x 8 squares, blown up. A vertex is computed from its place on the cube alone, so the sides
// agree where they meet and the surface is closed; each square is two triangles, so every face is planar.
#ifndef OSEM_CROSS_SPHERE_HPP
#define OSEM_CROSS_SPHERE_HPP

#include <cstdint>

#include "osem/solid.hpp"

namespace osem::cross {

constexpr std::int64_t square_root(std::int64_t value) {
    std::int64_t root = 0;
    for (std::int64_t bit = std::int64_t{1} << 31; bit != 0; bit /= 2) {
        if ((root + bit) * (root + bit) <= value) root += bit;
    }
    return root;
}

class Sphere {
  public:
    static constexpr std::uint32_t triangle_count = 768;
    static constexpr std::uint32_t corner_count = 3 * triangle_count;

    constexpr Sphere(const Point& centre, std::int32_t radius) {
        for (unsigned side = 0; side < 6; ++side) {
            add_vertices(side, centre, radius);
            add_triangles(side);
        }
    }

    constexpr Solid solid() const { return triangle_mesh(vertices_, vertex_count, corners_, triangle_count); }

  private:
    static constexpr std::int32_t squares = 8; // along an edge of the cube
    static constexpr std::uint32_t side_vertices = (squares + 1) * (squares + 1);
    static constexpr std::uint32_t vertex_count = 6 * side_vertices;

    static constexpr Point blown_up(const Point& on_cube, const Point& centre, std::int32_t radius) {
        std::int64_t square = 0;
        for (const std::int32_t c : on_cube.at) square += std::int64_t{c} * c;
        const std::int64_t length = square_root(square << 20); // with 10 bits after the point
        Point p = centre;
        for (unsigned axis = 0; axis < 3; ++axis) {
            p.at[axis] += static_cast<std::int32_t>(std::int64_t{on_cube.at[axis]} * radius * 1024 / length);
        }
        return p;
    }

    constexpr void add_vertices(unsigned side, const Point& centre, std::int32_t radius) {
        const unsigned axis = side / 2;
        for (std::int32_t u = 0; u <= squares; ++u) {
            for (std::int32_t v = 0; v <= squares; ++v) {
                Point on_cube = {};
                on_cube.at[axis] = side % 2 == 0 ? squares / 2 : -squares / 2;
                on_cube.at[(axis + 1) % 3] = u - squares / 2;
                on_cube.at[(axis + 2) % 3] = v - squares / 2;
                vertices_[vertices_made_++] = blown_up(on_cube, centre, radius);
            }
        }
    }

    constexpr void add_triangles(unsigned side) {
        const std::uint32_t first = side * side_vertices;
        constexpr std::uint32_t row = squares + 1;
        for (std::uint32_t u = 0; u < squares; ++u) {
            for (std::uint32_t v = 0; v < squares; ++v) {
                const std::uint32_t a = first + u * row + v;
                const bool outwards = side % 2 == 0; // on the far sides u, v turn the other way round
                add_triangle(a, a + row + (outwards ? 0 : 1), a + (outwards ? row + 1 : row));
                add_triangle(a, outwards ? a + row + 1 : a + 1, outwards ? a + 1 : a + row + 1);
            }
        }
    }

    constexpr void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        corners_[corners_made_++] = a;
        corners_[corners_made_++] = b;
        corners_[corners_made_++] = c;
    }

    Point vertices_[vertex_count] = {};
    std::uint32_t corners_[corner_count] = {};
    std::uint32_t vertices_made_ = 0;
    std::uint32_t corners_made_ = 0;
};

} // namespace osem::cross

#endif
