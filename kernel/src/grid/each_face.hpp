// Faces one after the other, for parts that would wait for what is read of them.
#ifndef OSEM_GRID_EACH_FACE_HPP
#define OSEM_GRID_EACH_FACE_HPP

#include <cstdint>

#include "osem/solid.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// Calls meet(face) for each of the faces face_of(first), face_of(first + 1) ... before face_of(end). Which
/// corners a face has is sent for two faces before, and where they are one face before: a mesh has them far
/// apart, and a part with caches would wait for both. (Not in a function of its own that is not in line: one
/// that only sends for memory has no effect, as a compiler sees it, so a call of it is dropped.)
template <class FaceOf, class Meet>
[[gnu::always_inline]] inline void each_face(const Solid& solid, std::uint32_t first, std::uint32_t end,
                                             FaceOf face_of, Meet meet) {
    const auto corners_of = [&](std::uint32_t i) {
        return solid.corners + solid.first_corner(solid.first_ring(face_of(i)));
    };
    for (std::uint32_t i = first; i != end; ++i) {
        if (guesses_cost_much && i + 2 < end) __builtin_prefetch(corners_of(i + 2));
        if (guesses_cost_much && i + 1 < end) {
            const std::uint32_t* const corners = corners_of(i + 1);
            for (unsigned k = 0; k < 3; ++k) __builtin_prefetch(&solid.vertices[corners[k]]);
        }
        meet(face_of(i));
    }
}

} // namespace osem

#endif
