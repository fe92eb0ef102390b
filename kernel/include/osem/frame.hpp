// From the caller's fixed-point world to the lattice.
#ifndef OSEM_FRAME_HPP
#define OSEM_FRAME_HPP

#include <cstddef>
#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/status.hpp"

namespace osem {

/// Where the root octant lies in a world of signed 32-bit fixed-point coordinates. The binary point is the
/// caller's: the kernel sees raw integers, so the same frame serves Q16.16 metres and whole micrometres.
///
///     lattice = (world - origin) * 2^shift
///
/// The root covers world coordinates from origin to origin + 2^(20 - shift) raw units along each axis; where
/// rounding is needed, a point up to half a lattice unit outside still maps onto its border.
struct Frame {
    std::int32_t origin[3]; ///< world coordinates (raw units) of the root octant's minimum corner
    std::int8_t shift;      ///< power of two, in [-31, 20]; at 0 and above the mapping is exact
};

/// A world point, in raw units of the caller's Q-format.
struct WorldPoint {
    std::int32_t at[3];
};

/// Outcome of a mapping: status, and the index of the first point refused (meaningless when ok).
struct FrameOutcome {
    Status status;
    std::size_t index;
};

/// Maps `count` world points to the lattice. Rounding: none when shift >= 0; otherwise to the nearest
/// lattice point, halves towards plus infinity. The two arrays must not overlap.
/// Status: ok; shift_out_of_range; point_outside_frame when a rounded coordinate is below 0 or above 2^20
/// (index names the point; points before it have been written). Cost: O(count), no scratch.
FrameOutcome to_lattice(const Frame& frame, const WorldPoint* world, std::size_t count, Point* lattice);

/// Maps a lattice point back, exactly when shift <= 0, otherwise rounded down to a raw unit. Status: ok;
/// shift_out_of_range; point_outside_frame when the world coordinate does not fit in 32 bits.
Status to_world(const Frame& frame, const Point& lattice, WorldPoint& world);

} // namespace osem

#endif
