// The simplest scanline that is exact.
#ifndef OSEM_BENCH_SIMPLE_SCANLINE_HPP
#define OSEM_BENCH_SIMPLE_SCANLINE_HPP

#include <cstdint>
#include <vector>

#include "bench/scanline.hpp"

namespace osem::bench {

/// Converts triangles to the runs that Scanline makes of them, but plainly: each row in a triangle's bounding
/// box is compared with its three edges, each crossing is a division, each row is sorted. What it has
/// allocated is used again by the next conversion.
class SimpleScanline {
  public:
    /// Depth 6 to 14; inside is where the winding number is not 0.
    void convert(const std::vector<Point>& vertices, const std::vector<host::Triangle>& triangles, int depth,
                 RunGrid& result);

    /// Bytes allocated, the result not included.
    std::uint64_t bytes() const;

  private:
    void cross(const Point& a, const Point& b, const Point& c, std::int64_t x, unsigned leaves,
               std::uint32_t* counts);
    void sort_into_rows(RunGrid& result);

    std::int64_t first_at(std::int64_t coordinate) const { return (coordinate + half_ - 1) >> shift_; }
    std::int64_t centre(std::int64_t cell) const { return (cell << shift_) + half_; }

    int shift_ = 0;                        ///< a cell's side is 2^shift
    std::int64_t half_ = 0;                ///< of a side
    std::vector<std::uint64_t> crossings_; ///< row << 32 | 2 * cell + (1 where the row leaves the solid)
    std::vector<std::uint16_t> sorted_;    ///< without the rows, row after row
};

} // namespace osem::bench

#endif
