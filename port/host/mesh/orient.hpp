// Facets without orientation given one.
#ifndef OSEM_HOST_MESH_ORIENT_HPP
#define OSEM_HOST_MESH_ORIENT_HPP

#include "mesh/quantize.hpp"

namespace osem::host {

/// Turns faces over so that the surface bounds what the even-odd rule calls inside: an outermost shell faces
/// outwards, one inside it (a cavity) inwards, one inside that outwards again. Counts the faces turned in
/// solid.reoriented_faces. Throws BadInput for a surface that is open or one-sided, for facets whose grouping
/// into shells cannot be told, and for shells whose nesting cannot.
void orient_even_odd(IntegerSolid& solid);

} // namespace osem::host

#endif
