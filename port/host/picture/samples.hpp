// What the rays found, before it is shaded or drawn.
#ifndef OSEM_HOST_SAMPLES_HPP
#define OSEM_HOST_SAMPLES_HPP

#include <cstdint>
#include <limits>
#include <vector>

namespace osem::host {

/// Depth where a ray met nothing.
constexpr float no_depth = std::numeric_limits<float>::infinity();

/// A plane in picture space: depth grows by `across` a column and by `along` a row.
struct Slope {
    float across;
    float along;
};

/// A square grid of samples, in rows. Depth counts in samples, as columns and rows do.
struct Samples {
    int side;
    float leaf; ///< side of a leaf at full depth, in samples; 0 for a solid
    std::vector<float> depth;
    std::vector<Slope> slope;         ///< of the face that was met
    std::vector<std::uint64_t> face;  ///< which face was met, a leaf's or the solid's; 0 where none was
    std::vector<std::uint32_t> plane; ///< which plane a leaf's face lies in, or a solid's face
    std::vector<std::uint8_t> black;  ///< 1 where a black leaf or the solid was met, 0 at a boundary leaf

    Samples(int samples, float leaf_side)
        : side(samples), leaf(leaf_side), depth(cells(), no_depth), slope(cells()), face(cells()),
          plane(cells()), black(cells()) {}

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
