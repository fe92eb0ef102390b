// What is checked of every box that a caller hands in.
#ifndef OSEM_QUERY_CELL_BOX_HPP
#define OSEM_QUERY_CELL_BOX_HPP

#include "osem/query.hpp"

namespace osem {

/// Status: ok; point_off_root; box_empty.
inline Status fault_of(const CellBox& box) {
    Status status = Status::ok;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t low = box.low.at[axis];
        const std::int32_t high = box.high.at[axis];
        if (low < 0 || low > root_side || high < 0 || high > root_side) return Status::point_off_root;
        if (low >= high) status = Status::box_empty;
    }
    return status;
}

} // namespace osem

#endif
