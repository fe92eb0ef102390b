// Faces and boxes: octants, and the halves and quarters of octants that a bintree has between them.
#ifndef OSEM_CLASSIFY_BOX_HPP
#define OSEM_CLASSIFY_BOX_HPP

#include "osem/classify.hpp"

namespace osem {

/// An open box of the lattice. Its sides along x and y are each as long as the one along z, or twice as long.
struct Box {
    Point lo;
    Point hi;
};

inline Box box_of(const Octant& octant) {
    Box box = {octant.corner, octant.corner};
    for (std::int32_t& coordinate : box.hi.at) coordinate += octant.side();
    return box;
}

/// As classify, for a box within the root.
Decision classify_box(const Solid& solid, std::uint32_t face, const Box& box);

/// Brings the faces of the list's first `count` that meet a box to its front and says how many they are. Adds
/// up what each stage decided. Cost: a classification a face.
inline std::uint32_t select_faces(const Solid& solid, const Box& box, std::uint32_t* list,
                                  std::uint32_t count, StageCounts& stages) {
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t face = list[i];
        const Decision decision = classify_box(solid, face, box);
        const int stage = static_cast<int>(decision.stage);
        ++(decision.meets ? stages.accepted : stages.rejected)[stage];
        if (decision.meets) {
            list[i] = list[met];
            list[met++] = face;
        }
    }
    return met;
}

} // namespace osem

#endif
