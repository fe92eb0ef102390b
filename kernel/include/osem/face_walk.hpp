// Follows one solid down the octants: which of its faces meet an octant, and how often it winds around
// points. What Conversion and CsgConversion have in common.
#ifndef OSEM_FACE_WALK_HPP
#define OSEM_FACE_WALK_HPP

#include <cstdint>

#include "osem/classify.hpp"
#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

/// What is kept of a solid for an open octant.
struct FaceFrame {
    std::uint32_t faces;     ///< length of the prefix of the face list that meets the octant
    std::int32_t winding[8]; ///< of the reference points of the children, where known
    std::uint8_t known;      ///< mask of the children whose winding is known

    /// An octant is opened: child 0 has its reference point.
    void open(std::uint32_t faces_met, std::int32_t winding_of_reference) {
        faces = faces_met;
        winding[0] = winding_of_reference;
        known = 1;
    }
};

/// A solid, the list of its faces, and what the stages decided. An octant's faces are a prefix of the list;
/// the walk below may permute the prefix, but not change its set.
class FaceWalk {
  public:
    /// Starts with all faces in the list. Precondition: `list` has convert_scratch(solid.view()) entries.
    void begin(const CheckedSolid& solid, std::uint32_t* list);

    std::uint32_t face_count() const { return solid_.view().face_count; }

    /// Brings the faces of a prefix that meet an octant to its front and says how many they are. Cost: a
    /// classification a face.
    std::uint32_t select(const Octant& octant, std::uint32_t faces);

    /// The winding number of the root's reference point: reached from one unit to the left of the root, where
    /// it is 0. Cost: a crossing test a face.
    std::int32_t winding_of_root() const;

    /// The winding number of the reference point of a child of the open octant `octant`. Reached from child 0
    /// along z, y, x by steps inside the open octant, so only its own faces can be crossed; each step is
    /// taken at most once an octant. Cost: up to three crossing tests a face of the frame.
    std::int32_t winding_of_child(FaceFrame& frame, const Octant& octant, unsigned child) const;

    /// The winding number of a leaf's centre, moved by (e, e^2, e^3): the reference point of the leaf's last
    /// child, three steps inside the leaf. Precondition: the leaf's side is 2 or more.
    std::int32_t winding_at_centre(const Octant& leaf, std::uint32_t faces, std::int32_t winding) const;

    /// What each stage rejected and accepted so far.
    const StageCounts& stages() const { return stages_; }

  private:
    std::int32_t crossings(const Point& from, Axis axis, std::int32_t length, std::uint32_t faces) const;

    CheckedSolid solid_ = CheckedSolid::vouched(Solid{});
    std::uint32_t* list_ = nullptr;
    StageCounts stages_ = {};
};

} // namespace osem

#endif
