// Which of the last grids' octants faces are in, as far as that is known from the beginning.
#ifndef OSEM_GRID_LAST_OCTANTS_HPP
#define OSEM_GRID_LAST_OCTANTS_HPP

#include <cstdint>

#include "grid/extent.hpp"
#include "grid/four.hpp"
#include "osem/lattice.hpp"
#include "osem/solid.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// What is known of a face.
struct FacePlaces {
    std::uint32_t count;      ///< of octants that it is placed in, two at most; if 0 it is not placed
    std::uint32_t octants[2]; ///< their numbers in Morton order; the first one twice, if it is the only one
    bool has_effect;          ///< if not, it need not even be listed
    bool is_on_way;           ///< whether a line along x through the first reference point may cross it
};

/// The octants that the last grids divide, and points that tell in which of them a face has an effect. With
/// centre leaves all that it does is to lie on ways from one leaf's reference point to the next in an octant:
/// so these are the points. Otherwise it may be met as well, where it reaches: so all lattice points are.
/// (Here, so that of many faces what is said of the octants may stay in registers.)
class LastOctants {
  public:
    /// Those so many levels below an octant. The points are 2^points_shift apart, the first one by `offset`
    /// from the octant's minimum corner along each axis.
    LastOctants(const Octant& octant, int levels, int points_shift, std::int32_t offset)
        : start_(octant.corner), levels_(levels), points_shift_(points_shift),
          octants_shift_(lattice_bits - octant.level - levels - points_shift) {
        for (std::int32_t& at : start_.at) at += offset + 1;
    }

    /// Places a triangle if the points between its ends are in one octant, or along one axis in two, and
    /// octants' reference points are between them along one axis at most, so that it lies on no way from one
    /// of these to another. All that FaceInGrid would find out in the grids above is in that. None is placed
    /// in octants that are 11 levels below or more: their numbers would be longer than a word.
    FacePlaces places_of(const Solid& solid, std::uint32_t face) const {
        const std::uint32_t* const corner = solid.corners + solid.first_corner(solid.first_ring(face));
        const std::uint32_t* const end = solid.corners + solid.first_corner(solid.end_ring(face));
        Found found = {};
        find(found, solid, corner, end);
        const std::uint32_t beside = found.axes(is_beside);
        // Across a border between octants there are reference points as well: so there is one border at most.
        const std::uint32_t against = found.axes(is_unfit) | beyond_one(found.axes(has_references));
        const bool has_effect = points_shift_ == 0 || beyond_one(found.axes(has_points)) != 0;
        const bool is_placed = against == 0 && end - corner == 3 && levels_ >= 1 && levels_ <= 10;
        // The next octant along an axis: 1 is added to those bits of the number that belong to it.
        const std::uint32_t along = beside * bits_of_x;
        const std::uint32_t next = (((found.octant | ~along) + beside) & along) | (found.octant & ~along);
        const std::uint32_t count = beside == 0 ? 1 : 2;
        return {is_placed ? count : 0,
                {found.octant, next},
                has_effect && found.axes(is_beyond) == 0,
                found.axes(is_around_first) >= 6};
    }

  private:
    // What is found out along an axis is a bit each: for x; those for y and z are the next two.
    static constexpr std::int32_t is_beside = 1 << 0;        // the last octant is beside the first one
    static constexpr std::int32_t is_unfit = 1 << 3;         // they are further apart, or outside
    static constexpr std::int32_t has_points = 1 << 6;       // there are points between its ends
    static constexpr std::int32_t has_references = 1 << 9;   // also octants' reference points
    static constexpr std::int32_t is_around_first = 1 << 12; // the first point is between its ends
    static constexpr std::int32_t is_beyond = 1 << 15;       // it ends before that, or begins behind all

    static constexpr std::uint32_t bits_of_x = 0x09249249; // of numbers in Morton order

    struct Found {
        std::uint32_t octant; // number of the first one
        std::uint32_t bits;

        std::uint32_t axes(std::int32_t bit) const { return bits / static_cast<std::uint32_t>(bit) & 7U; }
    };

    // Not 0 if there is more than one axis.
    static constexpr std::uint32_t beyond_one(std::uint32_t axes) { return axes & (axes - 1); }

    // Two bits come between each of a number's 10 bits and the next.
    template <class Bits>
    [[gnu::always_inline]] static void spread(Bits& bits) {
        bits &= 0x3ffU;
        bits = (bits | bits << 16) & 0x030000ffU;
        bits = (bits | bits << 8) & 0x0300f00fU;
        bits = (bits | bits << 4) & 0x030c30c3U;
        bits = (bits | bits << 2) & bits_of_x;
    }

    [[gnu::always_inline]] void find(Found& found, const Solid& solid, const std::uint32_t* corner,
                                     const std::uint32_t* end) const {
        if constexpr (guesses_cost_much) { // along all axes side by side
            FourSigned low;
            FourSigned start;
            load(low, solid.vertices[*corner]);
            load(start, start_);
            FourSigned high = low;
            while (++corner != end) {
                FourSigned next;
                load(next, solid.vertices[*corner]);
                lower(low, next);
                raise(high, next);
            }
            FourSigned first;
            FourSigned bits;
            find_along(first, bits, low, high, start);
            Four octant = reinterpret_cast<Four>(first);
            spread(octant);
            found.octant = octant[0] | octant[1] << 1 | octant[3] << 2;
            found.bits = static_cast<std::uint32_t>(bits[0] | bits[1] << 1 | bits[3] << 2);
        } else {
            const Extent extent(solid, corner, end);
            for (unsigned axis = 0; axis < 3; ++axis) {
                std::int32_t first = 0;
                std::int32_t bits = 0;
                find_along(first, bits, extent.low.at[axis], extent.high.at[axis], start_.at[axis]);
                auto octant = static_cast<std::uint32_t>(first);
                spread(octant);
                found.octant |= octant << axis;
                found.bits |= static_cast<std::uint32_t>(bits) << axis;
            }
        }
    }

    // The first octant, and what is found out.
    template <class Number>
    [[gnu::always_inline]] void find_along(Number& first, Number& bits, const Number& low, const Number& high,
                                           const Number& start) const {
        // The points between its ends are those behind one, up to another.
        const Number behind = (low - start) >> points_shift_;
        const Number last_point = (high - start) >> points_shift_;
        first = (behind + 1) >> octants_shift_;
        const Number last = last_point >> octants_shift_;
        const Number apart = last - first;
        const Number unfit = (first | last) >> levels_ | apart >> 1; // not 0
        const std::int32_t last_of_all = (1 << levels_) - 1;
        bits = (apart & is_beside) | ((unfit | -unfit) >> 31 & is_unfit) |
               ((behind - last_point) >> 31 & has_points) |
               (((behind >> octants_shift_) - last) >> 31 & has_references) |
               ((behind & ~last_point) >> 31 & is_around_first) |
               ((last | (last_of_all - first)) >> 31 & is_beyond);
    }

    Point start_; ///< the first point, 1 more along each axis
    int levels_;
    int points_shift_;
    int octants_shift_; ///< from points' numbers along an axis to octants'
};

} // namespace osem

#endif
