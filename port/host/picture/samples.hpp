// What the rays found, before it is shaded.
#ifndef OSEM_HOST_SAMPLES_HPP
#define OSEM_HOST_SAMPLES_HPP

#include <cstdint>
#include <limits>
#include <vector>

namespace osem::host {

/// Depth where a ray met nothing.
constexpr float no_depth = std::numeric_limits<float>::infinity();

/// A square grid of samples, in rows. Depth counts in samples, as columns and rows do.
struct Samples {
    int side;
    float leaf; ///< side of a leaf at full depth, in samples
    std::vector<float> depth;
    std::vector<std::uint8_t> axis;  ///< of the leaf's face that was met
    std::vector<std::uint8_t> black; ///< 1 where the leaf is black, 0 where it is boundary

    explicit Samples(int samples, float leaf_side)
        : side(samples), leaf(leaf_side), depth(cells(), no_depth), axis(cells()), black(cells()) {}

    std::size_t cells() const { return static_cast<std::size_t>(side) * static_cast<std::size_t>(side); }
    bool holds(int column, int row) const { return column >= 0 && row >= 0 && column < side && row < side; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
               static_cast<std::size_t>(column);
    }
    /// no_depth outside the grid.
    float depth_at(int column, int row) const {
        return holds(column, row) ? depth[index(column, row)] : no_depth;
    }
};

} // namespace osem::host

#endif
