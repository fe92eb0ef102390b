// How the winding number changes from one reference point to the next.
#ifndef OSEM_CLASSIFY_CROSSING_HPP
#define OSEM_CLASSIFY_CROSSING_HPP

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

/// What face `face` adds to the winding number on the way from `from` to `from` + `length` along an axis,
/// both ends moved by (e, e^2, e^3) for an infinitesimal e > 0. Coordinates of `from` are in [-1, 2^20] and
/// length > 0. Cost: O(corners of the face), 64-bit integers.
std::int32_t crossing(const Solid& solid, std::uint32_t face, const Point& from, Axis axis,
                      std::int32_t length);

} // namespace osem

#endif
