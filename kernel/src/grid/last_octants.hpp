// Which of the last grids' octants faces are in, as far as that is known from the beginning.
#ifndef OSEM_GRID_LAST_OCTANTS_HPP
#define OSEM_GRID_LAST_OCTANTS_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

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
    FacePlaces places_of(const Solid& solid, std::uint32_t face) const;

  private:
    struct Found;
    void find(Found& found, const Solid& solid, const std::uint32_t* corner, const std::uint32_t* end) const;
    template <class Number>
    void find_along(Number& first, Number& bits, const Number& low, const Number& high,
                    const Number& start) const;

    Point start_; ///< the first point, 1 more along each axis
    int levels_;
    int points_shift_;
    int octants_shift_; ///< from points' numbers along an axis to octants'
};

} // namespace osem

#endif
