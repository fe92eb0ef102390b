// An octant of a grid as a box, for those that classify it.
#ifndef OSEM_SUPPORT_OCTANT_BOX_HPP
#define OSEM_SUPPORT_OCTANT_BOX_HPP

#include "classify/box.hpp"
#include "grid/octant_grid.hpp"

namespace osem::tests {

inline osem::Box octant_box(const OctantGrid& grid, int i, int j, int k) {
    return {grid.at(i, j, k), grid.at(i + 1, j + 1, k + 1)};
}

} // namespace osem::tests

#endif
