// An integer solid out as an OFF file.
#ifndef OSEM_HOST_MESH_WRITE_OFF_HPP
#define OSEM_HOST_MESH_WRITE_OFF_HPP

#include <ostream>

#include "mesh/quantize.hpp"

namespace osem::host {

/// Writes OFF in lattice units: integers. Faces of one ring stay polygons; OFF knows no holes, so faces with
/// hole rings are written as triangles.
void write_off(std::ostream& out, const IntegerSolid& solid);

} // namespace osem::host

#endif
