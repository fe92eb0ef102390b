// Faces one after the other, for parts that would wait for what is read of them.
#ifndef OSEM_GRID_EACH_FACE_HPP
#define OSEM_GRID_EACH_FACE_HPP

#include <cstdint>

#include "osem/solid.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// Before face_of(i), of the faces up to face_of(end), is met: which corners a face has is sent for two faces
/// before, and where they are one face before, as a mesh has them far apart and a part with caches would wait
/// for both. (In line: a function that only sends for memory has no effect, as a compiler sees it, so a call
/// of it is dropped.)
template <class FaceOf>
[[gnu::always_inline]] inline void send_for_next(const Solid& solid, std::uint32_t i, std::uint32_t end,
                                                 FaceOf face_of) {
    if constexpr (guesses_cost_much) {
        const auto corners_of = [&](std::uint32_t face) {
            return solid.corners + solid.first_corner(solid.first_ring(face));
        };
        if (i + 2 < end) __builtin_prefetch(corners_of(face_of(i + 2)));
        if (i + 1 < end) {
            const std::uint32_t* const corners = corners_of(face_of(i + 1));
            for (unsigned k = 0; k < 3; ++k) __builtin_prefetch(&solid.vertices[corners[k]]);
        }
    }
}

/// Calls meet(face) for each of the faces face_of(first), face_of(first + 1) ... before face_of(end).
template <class FaceOf, class Meet>
[[gnu::always_inline]] inline void each_face(const Solid& solid, std::uint32_t first, std::uint32_t end,
                                             FaceOf face_of, Meet meet) {
    for (std::uint32_t i = first; i != end; ++i) {
        send_for_next(solid, i, end, face_of);
        meet(face_of(i));
    }
}

} // namespace osem

#endif
