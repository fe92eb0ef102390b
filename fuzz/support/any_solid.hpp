// Solids out of choices: sums of closed shapes in a window of the root, whole or broken on purpose.
#ifndef OSEM_FUZZ_ANY_SOLID_HPP
#define OSEM_FUZZ_ANY_SOLID_HPP

#include <cstdint>
#include <vector>

#include "osem/solid.hpp"
#include "support/choices.hpp"
#include "support/small_solids.hpp"

namespace osem::fuzz {

/// The arrays of a solid, exactly as long as it states them.
struct SolidArrays {
    std::vector<Point> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> ring_starts;
    std::vector<std::uint32_t> face_rings;
    std::uint32_t face_count = 0;
    bool has_starts = true; ///< else the table is left out
    bool has_rings = true;

    Solid view() const;
};

/// Arrays with vertices of each face's own, or with one for each point.
SolidArrays arrays_of(const tests::SmallSolid& solid, bool welded);
/// Without tables. Precondition: triangles only.
SolidArrays as_mesh(const SolidArrays& arrays);

/// An octant in which a solid is, of level 16 at most.
Octant any_window(Choices& choices);

/// A sum of one to four closed shapes: boxes, prisms on any rings, double cones, tetrahedra, sheets.
tests::SmallSolid any_solid(const Octant& window, Choices& choices);

/// Changes a few faces, indices, coordinates and table entries; the arrays stay as long as stated.
void damage(SolidArrays& arrays, Choices& choices);

} // namespace osem::fuzz

#endif
