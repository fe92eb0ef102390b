// The solids of the scenarios.
#ifndef OSEM_SCENARIOS_SOLIDS_HPP
#define OSEM_SCENARIOS_SOLIDS_HPP

#include "digest.hpp"
#include "memory.hpp"

namespace osem::cross {

/// A concave plate, sheared so that nothing is parallel to the axes but their ends,
/// with a square tunnel: faces with hole rings.
Solid plate();

/// An octahedron with odd coordinates: all faces oblique, no vertex on a plane of octants.
Solid octahedron();

/// A tetrahedron in an octahedron in an octahedron, all oriented outwards: winding numbers 1, 2, 3.
Solid nested_shells();

/// Five random tetrahedra of either orientation that overlap, within `side` units from `low`.
Solid tetrahedra(std::uint32_t seed, const Point& low, std::int32_t side);

/// What a conversion says and the tree that it gave, if it did.
void add(Digest& digest, const TreeOutcome& outcome);

} // namespace osem::cross

#endif
