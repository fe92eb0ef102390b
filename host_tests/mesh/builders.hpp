// Meshes for the tests, and what can be asked of any triangulation or surface.
#ifndef OSEM_HOST_TESTS_MESH_BUILDERS_HPP
#define OSEM_HOST_TESTS_MESH_BUILDERS_HPP

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/quantize.hpp"
#include "osem/solid.hpp"

namespace osem::host {

/// The cube in which a file coordinate is a lattice coordinate.
inline WorldCube lattice_cube() { return {{0, 0, 0}, static_cast<double>(root_side)}; }

/// How often each directed edge is used, less how often its opposite is; edges in balance are left out.
using Chain = std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t>;

inline void add_edge(Chain& chain, std::uint32_t from, std::uint32_t to) {
    const bool up = from < to;
    const auto place = up ? std::make_pair(from, to) : std::make_pair(to, from);
    if ((chain[place] += up ? 1 : -1) == 0) chain.erase(place);
}

inline void add_ring_edges(Chain& chain, const std::uint32_t* corners, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add_edge(chain, corners[i], corners[(i + 1) % count]);
}

inline Chain boundary(const Solid& solid) {
    Chain chain;
    for (std::uint32_t r = 0; r < solid.ring_count(); ++r) {
        add_ring_edges(chain, solid.ring(r).corners, solid.ring(r).count);
    }
    return chain;
}

inline void add_face(Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& rings) {
    for (const auto& ring : rings) {
        mesh.corners.insert(mesh.corners.end(), ring.begin(), ring.end());
        mesh.end_ring();
    }
    mesh.end_face();
}

/// An axis-parallel box of six quadrangles facing outwards.
inline void add_box(Mesh& mesh, std::array<double, 3> low, std::array<double, 3> high) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned k = 0; k < 8; ++k) {
        mesh.vertices.push_back(
            {k & 1U ? high[0] : low[0], k & 2U ? high[1] : low[1], k & 4U ? high[2] : low[2]});
    }
    const std::uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces) add_face(mesh, {{base + f[0], base + f[1], base + f[2], base + f[3]}});
}

/// A plate of thickness 10 with `holes` square holes through it in a row, top and bottom being one face each.
inline Mesh plate_with_holes(std::uint32_t holes) {
    Mesh mesh;
    // Corners base .. base + 3 below, base + 4 .. base + 7 above, counter-clockwise seen from above.
    const auto add_rectangle = [&](double x, double y, double width, double length) {
        const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const double z : {100.0, 110.0}) {
            mesh.vertices.push_back({x, y, z});
            mesh.vertices.push_back({x + width, y, z});
            mesh.vertices.push_back({x + width, y + length, z});
            mesh.vertices.push_back({x, y + length, z});
        }
        return base;
    };
    const std::uint32_t outline = add_rectangle(90, 90, 30.0 * holes + 20, 40);
    std::vector<std::vector<std::uint32_t>> top{{outline + 4, outline + 5, outline + 6, outline + 7}};
    std::vector<std::vector<std::uint32_t>> bottom{{outline + 3, outline + 2, outline + 1, outline}};
    std::vector<std::pair<std::uint32_t, bool>> walls{{outline, true}};
    for (std::uint32_t i = 0; i < holes; ++i) {
        const std::uint32_t hole = add_rectangle(100 + 30.0 * i, 100, 20, 20);
        top.push_back({hole + 7, hole + 6, hole + 5, hole + 4});
        bottom.push_back({hole, hole + 1, hole + 2, hole + 3});
        walls.emplace_back(hole, false);
    }
    add_face(mesh, top);
    add_face(mesh, bottom);
    for (const auto& [base, outer] : walls) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = base + (outer ? i : (i + 1) % 4);
            const std::uint32_t b = base + (outer ? (i + 1) % 4 : i);
            add_face(mesh, {{a, b, b + 4, a + 4}});
        }
    }
    return mesh;
}

} // namespace osem::host

#endif
