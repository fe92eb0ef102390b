// How far a face reaches along each axis.
#ifndef OSEM_GRID_EXTENT_HPP
#define OSEM_GRID_EXTENT_HPP

#include <cstdint>

#include "osem/solid.hpp"

namespace osem {

/// The least and the greatest coordinates of the corners [corner, end), of which there is one at least.
struct Extent {
    Point low;
    Point high;

    Extent(const Solid& solid, const std::uint32_t* corner, const std::uint32_t* end)
        : low(solid.vertices[*corner]), high(low) {
        for (++corner; corner != end; ++corner) {
            const Point& p = solid.vertices[*corner];
            for (int axis = 0; axis < 3; ++axis) {
                low.at[axis] = low.at[axis] < p.at[axis] ? low.at[axis] : p.at[axis];
                high.at[axis] = high.at[axis] > p.at[axis] ? high.at[axis] : p.at[axis];
            }
        }
    }

    std::int32_t length(int axis) const { return high.at[axis] - low.at[axis]; }
};

} // namespace osem

#endif
