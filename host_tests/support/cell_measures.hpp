// Measures of a dense grid by brute force on its cells: sums, sets of pieces, flood fill. Nothing of it knows
// of nodes or leaves.
#ifndef OSEM_SUPPORT_CELL_MEASURES_HPP
#define OSEM_SUPPORT_CELL_MEASURES_HPP

#include <cstdint>
#include <vector>

#include "osem/components.hpp"
#include "osem/measure.hpp"
#include "support/dense_grid.hpp"

namespace osem::tests {

/// Which cells of a grid are of some colours, addressed by coordinates; those outside are white.
class CellSet {
  public:
    CellSet(const DenseGrid& grid, std::uint8_t colours);
    int side() const { return side_; } ///< cells along an edge of the root
    std::int32_t cell_side() const { return root_side / side_; }
    /// Coordinates may be one cell outside the root.
    bool has(int x, int y, int z) const;

  private:
    int side_;
    bool outside_;
    std::vector<char> cells_; ///< x varies fastest
};

/// value * 2^shift.
Wide shifted(std::uint64_t value, unsigned shift);

Moments cell_moments(const CellSet& set);
SurfaceMeasures cell_surface(const CellSet& set);

/// Components by flood fill, numbered in Morton order of their first cells; the leaves are not counted. Where
/// white counts the outside is a ring of cells around the root.
struct CellComponents {
    std::vector<Component> components;
    std::vector<std::uint32_t> labels; ///< of the grid's cells, in its order; no_component
};
CellComponents cell_components(const DenseGrid& grid, std::uint8_t colours, Connectivity connectivity);

} // namespace osem::tests

#endif
