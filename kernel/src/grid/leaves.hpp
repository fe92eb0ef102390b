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
    std::uint32_t* scratch;      ///< a word for each 16 rows, for each 64 of them, and so on down to 4 words

    /// Sets what is below the open octant, which the grid makes up. Cost: O(rows), and for each part of
    /// 4 x 4 x 4 leaves that are not all alike its 16 rows (32 where some are boundary) and up to 8 nodes.
    void set(TreeBuilder& builder) const;

  private:
    void sum_up() const;
    std::uint32_t states_of_parts(std::uint32_t first_row) const;
    std::uint32_t leaf_at(unsigned child) const;
    std::uint8_t set_uniform(std::uint32_t leaf, int height, TreeBuilder& builder) const;
    struct Leaves {
        std::uint64_t may;
        std::uint64_t must;
    };
    Leaves leaves_of(std::uint32_t leaf) const;
    void set_small(TreeBuilder& builder) const;
};

} // namespace osem

#endif
