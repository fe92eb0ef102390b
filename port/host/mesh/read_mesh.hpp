// Mesh files in.
#ifndef OSEM_HOST_MESH_READ_MESH_HPP
#define OSEM_HOST_MESH_READ_MESH_HPP

#include <string>

#include "mesh/mesh.hpp"

namespace osem::host {

/// Reads a mesh file by its extension, in upper or lower case: .off, .stl (binary or ASCII, by content),
/// .obj, .poly (TetGen). Every corner of the result names a vertex, every coordinate is finite. Throws
/// BadInput, which names the file and the line or the byte at fault.
Mesh read_mesh(const std::string& path);

} // namespace osem::host

#endif
