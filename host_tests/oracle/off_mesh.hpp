// Real meshes: OFF files read by CGAL and rounded to the lattice.
#ifndef OSEM_ORACLE_OFF_MESH_HPP
#define OSEM_ORACLE_OFF_MESH_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "osem/solid.hpp"

namespace oracle {

struct TriangleMesh {
    std::vector<osem::Point> vertices;
    std::vector<std::uint32_t> corners;

    osem::Solid view() const;
};

/// The box of the lattice that a mesh is fitted into, proportions kept.
struct Fit {
    osem::Point low;
    std::int32_t side;
};

/// Nearly the whole root.
constexpr Fit whole_root{{{777, 777, 777}}, osem::root_side - 2 * 777};

/// The folder that meshes are read from: the environment variable OSEM_CGAL_DATA, else the one known when
/// the tests were built; empty if there is none.
std::string mesh_folder();

/// Reads, fits, rounds to the nearest lattice point, makes equal points one vertex and cuts polygons into
/// fans. Nothing when there is no such file or it is not OFF.
std::optional<TriangleMesh> read_off(const std::string& name, const Fit& fit);

} // namespace oracle

#endif
