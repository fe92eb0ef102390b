// From a file's coordinates to an integer solid that the kernel can check.
#ifndef OSEM_HOST_MESH_QUANTIZE_HPP
#define OSEM_HOST_MESH_QUANTIZE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/bad_input.hpp"
#include "mesh/mesh.hpp"
#include "osem/solid.hpp"

namespace osem::host {

/// The world cube that the root octant covers.
struct WorldCube {
    std::array<double, 3> origin;
    double side;

    /// Side of a lattice cell.
    double unit() const { return side / root_side; }
};

/// The cube for a mesh by default_cube_rule. Throws BadInput for a mesh without faces or without extent.
WorldCube default_cube(const Mesh& mesh);

/// The rule of default_cube in one sentence.
extern const char* const default_cube_rule;

/// A solid on the lattice: owns the arrays behind an osem::Solid. Equal points are one vertex.
struct IntegerSolid : FaceTable {
    WorldCube cube{};
    std::vector<Point> vertices;
    std::vector<std::array<double, 3>> file_coordinates; ///< of the first file vertex at each lattice vertex
    bool triangles_only = true;                          ///< every face is one ring of three corners

    bool oriented = true; ///< as the mesh: its file says which way every face looks

    std::uint32_t input_faces = 0;
    std::uint32_t input_vertices = 0;
    std::uint32_t welded_vertices = 0; ///< file vertices merged into an earlier one on the same point
    std::uint32_t dropped_faces = 0;   ///< faces that rounding left without three distinct corners in a row
    std::uint32_t triangulated_faces = 0; ///< polygons that are not planar on the lattice, cut into triangles
    std::uint32_t reoriented_faces = 0;   ///< faces turned over, where the file gives no orientation

    /// The kernel's view, valid while this object stays where it is and unchanged; without ring tables where
    /// every face is a triangle.
    Solid view() const;
};

/// Puts a mesh on the lattice of a cube: lattice = floor((x - origin) * (2^20 / side) + 0.5). Vertices on
/// the same lattice point are welded, faces that collapse are dropped, polygons that rounding bent are
/// triangulated, and where the file gives no orientation faces are oriented by the even-odd rule: sheets that
/// touch along an edge are told apart by their vertices where these are different in the file. None of this
/// opens a closed surface. Vertices that no face uses are ignored. Throws BadInput for a cube without
/// extent, for a vertex that is not finite or outside the cube, and for facets that cannot be oriented.
IntegerSolid quantize(const Mesh& mesh, const WorldCube& cube);

/// osem::check, its refusal told in the file's own coordinates: throws BadInput. The result views `solid`,
/// which must outlive it.
CheckedSolid check_or_throw(const IntegerSolid& solid);

} // namespace osem::host

#endif
