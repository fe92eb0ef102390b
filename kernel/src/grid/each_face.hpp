// Faces one after the other, for parts that would wait for what is read of them.
#ifndef OSEM_GRID_EACH_FACE_HPP
#define OSEM_GRID_EACH_FACE_HPP

#include <cstdint>
#include <type_traits>

#include "osem/solid.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// Sends for what is read of the faces face_of(first) ... before face_of(end): which corners a face has two
/// faces before it is met, and where they are one face before, as a mesh has them far apart and a part with
/// caches would wait for both. (In line: a function that only sends for memory has no effect, as a compiler
/// sees it, so a call of it is dropped.)
template <class FaceOf>
class FacesAhead {
  public:
    FacesAhead(const Solid& solid, std::uint32_t first, std::uint32_t end, FaceOf face_of)
        : solid_(solid), end_(end), face_of_(face_of) {
        if (first + 1 < end) next_ = corners_of(first + 1);
    }

    /// Before the i-th one is met, of all in turn.
    [[gnu::always_inline]] void send(std::uint32_t i) {
        if (i + 1 >= end_) return;
        for (unsigned k = 0; k < 3; ++k) __builtin_prefetch(&solid_.vertices[next_[k]]);
        if (i + 2 >= end_) return;
        next_ = corners_of(i + 2);
        __builtin_prefetch(next_);
    }

  private:
    [[gnu::always_inline]] const std::uint32_t* corners_of(std::uint32_t i) const {
        return solid_.corners + solid_.first_corner(solid_.first_ring(face_of_(i)));
    }

    const Solid& solid_;
    std::uint32_t end_;
    FaceOf face_of_;
    const std::uint32_t* next_ = nullptr; ///< the corners of the face behind the one that is met
};

/// Parts without caches have nothing to send for, and no room to spare for that.
template <class FaceOf>
class NothingAhead {
  public:
    NothingAhead(const Solid& /*solid*/, std::uint32_t /*first*/, std::uint32_t /*end*/,
                 const FaceOf& /*face_of*/) {}
    void send(std::uint32_t /*i*/) const {}
};

/// What sends for the faces ahead on this part. (Two classes: cppcheck takes two forms of one for the same.)
template <class FaceOf>
[[gnu::always_inline]] inline auto faces_ahead(const Solid& solid, std::uint32_t first, std::uint32_t end,
                                               FaceOf face_of) {
    return std::conditional_t<guesses_cost_much, FacesAhead<FaceOf>, NothingAhead<FaceOf>>(solid, first, end,
                                                                                           face_of);
}

/// Calls meet(face) for each of the faces face_of(first), face_of(first + 1) ... before face_of(end).
template <class FaceOf, class Meet>
[[gnu::always_inline]] inline void each_face(const Solid& solid, std::uint32_t first, std::uint32_t end,
                                             FaceOf face_of, Meet meet) {
    auto ahead = faces_ahead(solid, first, end, face_of);
    for (std::uint32_t i = first; i != end; ++i) {
        ahead.send(i);
        meet(face_of(i));
    }
}

} // namespace osem

#endif
