// Nothing is timed before all methods have given the same cells.
#ifndef OSEM_BENCH_AGREEMENT_HPP
#define OSEM_BENCH_AGREEMENT_HPP

#include <cstdint>
#include <string>

#include "bench/solids.hpp"
#include "osem/octree.hpp"

namespace osem::bench {

/// Ends the program with a message unless `holds`.
void require(bool holds, const std::string& message);

/// What the methods make of a solid at a depth. Cells are leaves at full depth.
struct Agreement {
    std::uint64_t cells;          ///< whose centre is inside: octree, both scanlines and bits agree
    std::uint64_t inner_cells;    ///< inside throughout
    std::uint64_t boundary_cells; ///< which a face meets
};

struct BitGrid;

/// The cells of a tree's black leaves at a depth, found leaf by leaf.
BitGrid bits_of(const Octree& tree, int depth);

/// Converts by every exact method, once for each solid and depth; ends the program where they differ: the
/// centre tree, both scanlines' runs and the bits must be the same cells, one by one, and their number must
/// lie between those of the inner and the outer solid of the conservative tree.
const Agreement& agreement_on(const std::string& solid, int depth);

} // namespace osem::bench

#endif
