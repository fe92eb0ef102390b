// Exact signed volumes.
#ifndef OSEM_HOST_MESH_VOLUME_HPP
#define OSEM_HOST_MESH_VOLUME_HPP

#include <cstdint>

#include "osem/solid.hpp"

namespace osem::host {

/// A signed sum of 64-bit terms in two words; up to 2^64 terms.
class WideSum {
  public:
    void add(std::int64_t term);
    friend bool operator<(const WideSum& a, const WideSum& b) {
        return a.high_ != b.high_ ? a.high_ < b.high_ : a.low_ < b.low_;
    }
    /// Rounded.
    double value() const;

  private:
    std::int64_t high_ = 0;
    std::uint64_t low_ = 0;
};

/// Adds six times the volume between a face and the lattice's origin, positive where the face's front looks
/// away from the origin. The sum over a closed surface is six times its volume.
void add_volume6(WideSum& sum, const Solid& solid, std::uint32_t face);

} // namespace osem::host

#endif
