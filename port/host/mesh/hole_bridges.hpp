// Holes joined to the outlines around them.
#ifndef OSEM_HOST_MESH_HOLE_BRIDGES_HPP
#define OSEM_HOST_MESH_HOLE_BRIDGES_HPP

#include "mesh/face_cycles.hpp"

namespace osem::host {

/// Joins each cycle that turns clockwise to the cycle around it by a bridge, an edge passed once each way,
/// from the hole's rightmost corner to a corner it sees (D. Eberly, "Triangulation by Ear Clipping"). A hole
/// with nothing around it, which a bent face can have, stays a cycle of its own. Cost: O(holes * corners).
void bridge_holes(FaceCycles& cycles);

} // namespace osem::host

#endif
