#include "grid/placed_faces.hpp"

namespace osem {

namespace {

// The bits of a number of 10 bits, two others between each and the next.
constexpr std::uint32_t spread(std::int32_t number) {
    std::uint32_t bits = static_cast<std::uint32_t>(number) & 0x3ffU;
    bits = (bits | bits << 16) & 0x030000ffU;
    bits = (bits | bits << 8) & 0x0300f00fU;
    bits = (bits | bits << 4) & 0x030c30c3U;
    return (bits | bits << 2) & 0x09249249U;
}

} // namespace

FacePlaces places_of(const Solid& solid, std::uint32_t face, const Extent& extent,
                     const LastOctants& octants) {
    const std::uint32_t first_ring = solid.first_ring(face);
    const std::uint32_t corners = solid.first_corner(solid.end_ring(face)) - solid.first_corner(first_ring);
    if (corners != 3 || octants.levels < 1 || octants.levels > 10) return FacePlaces{0, {0, 0}};
    const int shift = lattice_bits - octants.octant.level - octants.levels;
    FacePlaces places = {0, {0, 0}};
    std::int32_t outside = 0; // bits of numbers beyond the octants'
    std::int32_t apart = 0;   // of its ends' octants, along each axis: bits but the lowest one
    std::int32_t borders = 0; // between its ends
    int past = 0;             // axes along which there are reference points between its ends
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t low = extent.low.at[axis] - octants.octant.corner.at[axis];
        const std::int32_t last = extent.high.at[axis] - octants.octant.corner.at[axis] - 1;
        const std::int32_t ends[2] = {low >> shift, last >> shift};
        outside |= ends[0] >> octants.levels | ends[1] >> octants.levels;
        apart |= (ends[1] - ends[0]) >> 1;
        borders += ends[1] - ends[0];
        for (int end = 0; end < 2; ++end) places.octants[end] |= spread(ends[end]) << axis;
        past += (low - 1 - octants.offset) >> shift != (last - octants.offset) >> shift ? 1 : 0;
    }
    if (outside == 0 && apart == 0 && borders <= 1 && past <= 1) places.count = borders == 0 ? 1 : 2;
    return places;
}

// Counts, and then puts each face where those with its digit belong; the one that was there comes to its
// place and is left for the next time. Each time half of those that are left find their places at least, and
// no step waits for another, as it would if the one that was there were always the next one.
std::uint64_t PlacedFaces::sort(const Range& range, const Digit& sorted_by, std::uint32_t* space) const {
    const Digit digit = sorted_by;         // a compiler cannot know that no word below is part of it
    std::uint32_t* const next = space;     // the first place of each digit's that is not taken
    std::uint32_t* const end = space + 64; // behind its places
    for (std::uint32_t value = 0; value <= digit.greatest; ++value) end[value] = 0;
    for (std::uint32_t i = range.first, behind = range.end; i != behind; ++i) ++end[digit.of(octant(i))];
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
