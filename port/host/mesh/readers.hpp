// The readers behind read_mesh: from a file's bytes to a mesh, one a format.
#ifndef OSEM_HOST_MESH_READERS_HPP
#define OSEM_HOST_MESH_READERS_HPP

#include <string_view>

#include "mesh/mesh.hpp"

namespace osem::host {

// Each throws BadInput that names the line or the byte offset, but not the file.
Mesh read_off(std::string_view bytes);
Mesh read_stl(std::string_view bytes);
Mesh read_obj(std::string_view bytes);
Mesh read_poly(std::string_view bytes);

} // namespace osem::host

#endif
