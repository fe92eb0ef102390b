// Random numbers, the same in every run, drawn to the ends of the lattice.
#ifndef OSEM_VECTORS_RANDOM_HPP
#define OSEM_VECTORS_RANDOM_HPP

#include <cstdint>
#include <random>

#include "osem/lattice.hpp"

namespace vectors {

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    /// From 0 to n - 1.
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(n)); }
    std::int32_t between(std::int32_t low, std::int32_t high) { return low + below(high - low + 1); }
    std::int32_t any_i32() { return static_cast<std::int32_t>(static_cast<std::uint32_t>(engine_())); }

    /// Of a vertex: half of them 0, 2^20 or near there, near the middle, or small.
    std::int32_t coordinate();
    osem::Point vertex();

    /// Every coordinate 0 or 2^20.
    osem::Point root_corner();

    /// Of a query: like a vertex, or a corner of the root moved out to -1.
    osem::Point query();

  private:
    std::mt19937 engine_;
};

/// Whether a point is where vertices and query points may be.
bool is_vertex(const osem::Point& p);
bool is_query(const osem::Point& p);

/// Whether a coordinate is at an end of the lattice or beside it.
bool is_extreme(const osem::Point& p);

} // namespace vectors

#endif
