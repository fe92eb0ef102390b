// The floor to beat: an exact scanline over the same integer triangles, which knows no tree.
//
// Rows of cells run along x. A row's line passes through its cells' centres, which are lattice points up to
// depth 19. Ties are broken as LeafRule::centre breaks them: the point sampled is the centre moved by
// (e, e^2, e^3), e > 0 infinitesimal, so the line of a row is moved by e^2 along y and by e^3 along z, and a
// crossing at x itself counts for the cell whose centre is x. In the plane of y and z that is the half-open
// rule, y before z; along x it is a quotient rounded up.
#ifndef OSEM_BENCH_SCANLINE_HPP
#define OSEM_BENCH_SCANLINE_HPP

#include <cstdint>
#include <vector>

#include "bench/solids.hpp"

namespace osem::bench {

/// The cells whose centres are inside, as runs [begin, end): row z * side + y has the boundaries
/// [starts[row], starts[row + 1]), begin and end of each run in turn, strictly ascending.
struct RunGrid {
    std::uint32_t side = 0; ///< cells along an axis
    std::vector<std::uint32_t> starts;
    std::vector<std::uint16_t> boundaries;

    std::uint64_t cells() const;
    std::uint64_t bytes() const {
        return starts.size() * sizeof starts[0] + boundaries.size() * sizeof boundaries[0];
    }
};

/// A bit a cell, x lowest: cell (x, y, z) is bit x % 64 of word ((z * side + y) * side + x) / 64.
struct BitGrid {
    std::uint32_t side = 0;
    std::vector<std::uint64_t> words;

    std::uint64_t cells() const;
    std::uint64_t bytes() const { return words.size() * sizeof words[0]; }
};

/// Converts triangles to runs: crossings of all rows as triangles come, a counting sort into rows, then row
/// by row the cells between them. What it has allocated is used again by the next conversion.
class Scanline {
  public:
    /// Depth 6 to 14; inside is where the winding number is not 0.
    void convert(const std::vector<Point>& vertices, const std::vector<host::Triangle>& triangles, int depth,
                 RunGrid& result);

    /// Bytes allocated, the result not included.
    std::uint64_t bytes() const;

  private:
    std::size_t cross(const std::vector<Point>& vertices, const std::vector<host::Triangle>& triangles,
                      int depth, std::uint32_t* counts);
    void sort_into_rows(std::size_t count, std::vector<std::uint32_t>& counts);
    void join(std::size_t count, RunGrid& result);

    std::vector<std::uint64_t> crossings_; ///< row << 32 | crossing, as triangles come
    std::vector<std::uint16_t> sorted_;    ///< crossings, row after row
};

/// Sets bits [begin, end) of a row of words; begin < end.
void set_bits(std::uint64_t* words, unsigned begin, unsigned end);

/// Writes runs out as bits, each word once.
void fill_bits(const RunGrid& runs, BitGrid& result);

} // namespace osem::bench

#endif
