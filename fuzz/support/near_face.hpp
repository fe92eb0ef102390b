// Octants, points and planar faces near them, out of choices: often at the places where predicates go wrong.
#ifndef OSEM_FUZZ_NEAR_FACE_HPP
#define OSEM_FUZZ_NEAR_FACE_HPP

#include "osem/lattice.hpp"
#include "support/choices.hpp"
#include "support/small_solids.hpp"

namespace osem::fuzz {

Octant any_octant(Choices& choices);

/// A point of the lattice: on the grid of half an octant's side, one off it, near the octant, at an end of
/// the root, or anywhere.
Point near_point(const Octant& octant, Choices& choices);

/// One planar face: a triangle, a polygon on a lattice plane, rings with holes, an axis-parallel polygon, a
/// ring that runs there and back.
tests::SmallSolid near_face(const Octant& octant, Choices& choices);

} // namespace osem::fuzz

#endif
