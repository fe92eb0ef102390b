// Faces cut into triangles, exactly.
#ifndef OSEM_HOST_MESH_TRIANGULATE_HPP
#define OSEM_HOST_MESH_TRIANGULATE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "osem/solid.hpp"

namespace osem::host {

using Triangle = std::array<std::uint32_t, 3>;

/// Triangles of a face, as vertex indices, in the face's orientation. Whatever the face, the triangles have
/// the boundary of its rings, edge for edge with opposite edges cancelling, so that a closed surface stays
/// closed. If the face is planar with rings that touch at most, none of them is turned over and together
/// they cover the face once; those of zero area stand where a corner lies on another edge of the face.
///
/// Precondition: equal points of the face are one vertex. Cost: O(n^2) for n corners.
std::vector<Triangle> triangulate_face(const Solid& solid, std::uint32_t face);

} // namespace osem::host

#endif
