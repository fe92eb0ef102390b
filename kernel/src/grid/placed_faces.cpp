#include "grid/placed_faces.hpp"

namespace osem {

// Counts, and then puts each face where those with its digit belong; the one that was there comes to its
// place and is left for the next time. Each time half of those that are left find their places at least, and
// no step waits for another, as it would if the one that was there were always the next one.
std::uint64_t PlacedFaces::sort(Range range, Digit digit, std::uint32_t* space) const {
    std::uint32_t* const next = space;     // the first place of each digit's that is not taken
    std::uint32_t* const end = space + 64; // behind its places
    for (std::uint32_t value = 0; value <= digit.greatest; ++value) end[value] = 0;
    for (std::uint32_t i = range.first; i != range.end; ++i) ++end[digit.of(octant(i))];
    std::uint64_t present = 0;
    std::uint32_t places = range.first;
    for (std::uint32_t value = 0; value <= digit.greatest; ++value) {
        if (end[value] != 0) present |= std::uint64_t{1} << value;
        next[value] = places;
        places += end[value];
        end[value] = places;
    }
    for (bool are_left = true; are_left;) {
        are_left = false;
        for (std::uint32_t value = 0; value <= digit.greatest; ++value) {
            const std::uint32_t last = end[value];
            for (std::uint32_t i = next[value]; i != last; ++i) {
                const std::uint32_t moved_octant = octant(i);
                const std::uint32_t moved_face = face(i);
                std::uint32_t* const there = at(next[digit.of(moved_octant)]++);
                put(at(i), there[0], there[1]);
                put(there, moved_octant, moved_face);
            }
            are_left = are_left || next[value] != last;
        }
    }
    return present;
}

} // namespace osem
