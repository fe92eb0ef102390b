// The surface of an octree out as a mesh file, in world coordinates.
#ifndef OSEM_HOST_MESH_WRITE_SURFACE_HPP
#define OSEM_HOST_MESH_WRITE_SURFACE_HPP

#include <optional>
#include <ostream>
#include <string>

#include "mesh/quantize.hpp"
#include "mesh/tree_surface.hpp"

namespace osem::host {

enum class SurfaceFormat { off, obj, stl, poly };

/// By the end of a file's name, whatever its case; none when it is no format that can be written.
std::optional<SurfaceFormat> surface_format(const std::string& name);

/// Writes a surface. `surface` has simple faces for OFF and OBJ, triangles for STL (binary, coordinates
/// rounded to binary32) and any for TetGen's .poly, which holds faces with holes. Coordinates are the
/// shortest decimals that read back as the binary64 numbers origin + lattice * unit.
void write_surface(std::ostream& out, const TreeSurface& surface, const WorldCube& cube,
                   SurfaceFormat format);

} // namespace osem::host

#endif
