// Faces of which it is known from the beginning in which of the last grids' octants they are.
#ifndef OSEM_GRID_PLACED_FACES_HPP
#define OSEM_GRID_PLACED_FACES_HPP

#include <cstddef>
#include <cstdint>

namespace osem {

/// Placed faces: two words each, an octant's number and a face that is in it.
struct PlacedFaces {
    /// Some of them, from `first` on.
    struct Range {
        std::uint32_t first;
        std::uint32_t end;
    };
    /// Which bits of octants' numbers say in which part of an octant above they lie.
    struct Digit {
        unsigned shift;
        std::uint32_t greatest; ///< 7 or 63

        std::uint32_t of(std::uint32_t octant) const { return octant >> shift & greatest; }
    };
    static constexpr std::uint32_t words = 2; ///< a face
    static constexpr std::uint32_t words_to_sort = 128;

    std::uint32_t* memory;

    std::uint32_t octant(std::uint32_t i) const { return at(i)[0]; }
    std::uint32_t face(std::uint32_t i) const { return at(i)[1]; }
    static void put(std::uint32_t* place, std::uint32_t octant, std::uint32_t face) {
        place[0] = octant;
        place[1] = face;
    }

    /// Sorts a range by a digit; the set of those that there are. Cost: O(range). Space: words_to_sort.
    std::uint64_t sort(Range range, Digit digit, std::uint32_t* space) const;

    /// The beginning of a sorted range, as far as the digit is that one; empty if the first face has another.
    Range front(const Range& range, const Digit& digit, std::uint32_t value) const {
        Range front = {range.first, range.first};
        while (front.end != range.end && digit.of(octant(front.end)) == value) ++front.end;
        return front;
    }

  private:
    std::uint32_t* at(std::uint32_t i) const { return &memory[std::size_t{words} * i]; }
};

} // namespace osem

#endif
