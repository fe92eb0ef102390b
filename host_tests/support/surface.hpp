// Surfaces of octrees with arrays of their own, and what a brute-force look at the cells says of them.
#ifndef OSEM_SUPPORT_SURFACE_HPP
#define OSEM_SUPPORT_SURFACE_HPP

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "osem/boundary.hpp"
#include "support/dense_grid.hpp"

namespace osem::tests {

/// The arrays have exactly the sizes stated, so that the address sanitizer sees a write behind them.
class Surface {
  public:
    Surface(Boundary& job, const Octree& tree, SolidPart part);

    const Solid& view() const { return solid_; }
    const BoundaryOutcome& counted() const { return counted_; }
    const BoundaryOutcome& built() const { return built_; }

  private:
    BoundaryOutcome counted_;
    BoundaryOutcome built_;
    std::vector<Point> vertices_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> ring_starts_;
    std::vector<std::uint32_t> face_rings_;
    Solid solid_;
};

/// A square of the surface: the side of a solid cell, given by the cell's coordinates in cells, the axis of
/// the outward normal and whether it points to the positive side.
using UnitFace = std::tuple<int, int, int, int, bool>;
using UnitFaces = std::set<UnitFace>;

/// The solid cells of a grid as a set of their own: black, or black and boundary.
DenseGrid solid_cells(const DenseGrid& grid, SolidPart part);

/// The squares of a grid of white and black cells, those of one face together: connected along edges where
/// the surface is flat.
std::set<UnitFaces> expected_faces(const DenseGrid& solid);

/// The squares that each face covers by the parity of its rings, seen from the middle of each square.
std::set<UnitFaces> covered_faces(const Solid& surface, int depth);

/// Whether, by vertex indices, every edge is used once each way, the faces around each vertex are one cycle,
/// and the two faces of an edge belong to one solid cell or to cells that the solid joins.
::testing::AssertionResult is_manifold(const Solid& surface, const DenseGrid& solid);

/// Six times the volume that the surface encloses, exactly. Precondition: planar rings along the axes.
std::int64_t six_volumes(const Solid& surface, std::int32_t unit);

} // namespace osem::tests

#endif
