// Points against closed shells, exactly.
#ifndef OSEM_HOST_MESH_SHELL_TEST_HPP
#define OSEM_HOST_MESH_SHELL_TEST_HPP

#include "osem/solid.hpp"

namespace osem::host {

/// Whether a lattice point belongs to a face, its border included.
bool lies_on(const Solid& solid, std::uint32_t face, const Point& p);

/// Whether the ray along +x from p moved by (e, e^2, e^3), for an infinitesimal e > 0, crosses a face. It
/// never touches an edge, so the parity of its crossings says whether it starts inside a closed shell.
bool ray_crosses(const Solid& solid, std::uint32_t face, const Point& p);

} // namespace osem::host

#endif
