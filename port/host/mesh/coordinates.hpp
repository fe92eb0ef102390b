// Coordinates as messages show them.
#ifndef OSEM_HOST_MESH_COORDINATES_HPP
#define OSEM_HOST_MESH_COORDINATES_HPP

#include <array>
#include <string>

namespace osem::host {

/// "(x y z)", each number in the shortest form that reads back as the same.
std::string to_text(const std::array<double, 3>& point);

} // namespace osem::host

#endif
