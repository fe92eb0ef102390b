// The leaves of a grid as nodes of a tree.
#ifndef OSEM_GRID_LEAVES_HPP
#define OSEM_GRID_LEAVES_HPP

#include <cstdint>

#include "osem/grid_convert.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

/// The leaves of a grid, as sets in rows; see octant_grid.hpp.
struct GridLeaves {
    int levels;
    const std::uint32_t* inside; ///< black, if not also met
    const std::uint32_t* met;    ///< boundary; or null: none
    std::uint32_t* scratch;      ///< a word for each 64 rows

    /// Sets what is below the open octant, which the grid makes up. Cost: O(rows), and for each cube of
    /// 8 x 8 x 8 leaves that are not all alike its 64 rows (128 where some are boundary) and up to 73 nodes.
    void set(TreeBuilder& builder) const;

  private:
    void note_states() const;
    std::uint32_t states_of_cubes(std::uint32_t first_row) const;
    void set_eight_cubes(unsigned octant, TreeBuilder& builder) const;
    using Parts = std::uint64_t[8];
    struct Cube {
        Parts may; ///< without boundary nothing: it is `must` then
        Parts must;
    };
    const Parts& may_of(const Cube& cube) const { return met == nullptr ? cube.must : cube.may; }
    void read(Cube& cube, std::uint32_t row, unsigned x) const;
    void set_small(TreeBuilder& builder) const;
};

} // namespace osem

#endif
