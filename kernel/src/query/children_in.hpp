// Which children of an octant reach a box, eight at once.
#ifndef OSEM_QUERY_CHILDREN_IN_HPP
#define OSEM_QUERY_CHILDREN_IN_HPP

#include <cstdint>

#include "osem/query.hpp"
#include "tree/masks.hpp"

namespace osem {

/// The children of an octant that have a cell in the box, or within `margin` cells of it. Preconditions: the
/// octant is divided; the box's coordinates are in [-2^29, 2^29].
inline std::uint8_t children_in(const Octant& octant, const CellBox& box, std::int32_t margin) {
    const std::int32_t half = octant.side() / 2;
    unsigned children = 0xff;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t middle = octant.corner.at[axis] + half;
        const std::int32_t low = box.low.at[axis] - margin - middle; // from the octant's middle
        const std::int32_t high = box.high.at[axis] + margin - middle;
        if (low >= 0 || high <= -half) children &= ~unsigned{low_children[axis]};
        if (low >= half || high <= 0) children &= low_children[axis];
    }
    return static_cast<std::uint8_t>(children);
}

} // namespace osem

#endif
