// Does a face meet the open octant? Five stages, each more precise than the one before, as in Trstenjak,
// Zalik and Guid (Informatica 2/91), section 3; every answer is exact.
#ifndef OSEM_CLASSIFY_HPP
#define OSEM_CLASSIFY_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

/// The stage that decided.
enum class Stage : std::uint8_t {
    minimax,  ///< 1: bounding boxes; rejects what does not overlap the octant (touching is not overlapping)
    plane,    ///< 2: rejects a face whose plane misses the open octant
    vertices, ///< 3: accepts a corner strictly inside, or a triangle wholly inside or on the octant
    section,  ///< 4: accepts an edge that meets the open octant; else the section of plane and octant lies
              ///<    wholly inside or outside the outer ring
    holes,    ///< 5: inside the outer ring, rejects what holes cover wholly
};
constexpr int stage_count = 5;

/// The answer and the stage that gave it.
struct Decision {
    Stage stage;
    bool meets;
};

/// How many face-octant pairs each stage decided.
struct StageCounts {
    std::uint64_t rejected[stage_count];
    std::uint64_t accepted[stage_count];
};

/// Decides whether face `face` of a checked solid shares a point with the open octant. A face is the closed
/// set of its rings and of the points its rings wind around (a winding number of the rings other than 0).
/// Integers: 64 bits throughout. Cost: O(corners of the face); no scratch.
/// Preconditions: face < checked.view().face_count; the octant lies in the root.
Decision classify(const CheckedSolid& checked, std::uint32_t face, const Octant& octant);

} // namespace osem

#endif
