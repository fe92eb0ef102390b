// Which polygons of a facet are outlines and which are holes.
#ifndef OSEM_HOST_MESH_RING_NESTING_HPP
#define OSEM_HOST_MESH_RING_NESTING_HPP

#include <vector>

#include "mesh/mesh.hpp"
#include "osem/lattice.hpp"

namespace osem::host {

/// Faces with an outer ring and its holes from facets whose rings have no roles and run either way. A ring
/// inside an even number of the facet's other rings is the outline of a face, one inside an odd number is a
/// hole in the innermost of them; holes run opposite to outlines. The rings may touch but not cross. Throws
/// BadInput when two rings of a facet coincide.
FaceTable nest_rings(const FaceTable& facets, const std::vector<Point>& vertices);

} // namespace osem::host

#endif
