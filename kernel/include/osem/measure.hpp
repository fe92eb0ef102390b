// Exact measures of the two solids that a tree certifies, in integers: moments, surface, Euler
// characteristic. The inner solid is the black leaves, the outer one the black and the boundary leaves.
//
// What is inside is counted by `measure` of octree.hpp; pieces that hang together are in components.hpp.
#ifndef OSEM_MEASURE_HPP
#define OSEM_MEASURE_HPP

#include <cstdint>

#include "osem/cluster_walk.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"

namespace osem {

/// An unsigned integer of 128 bits: high * 2^64 + low.
struct Wide {
    std::uint64_t high;
    std::uint64_t low;

    friend constexpr bool operator==(const Wide& a, const Wide& b) {
        return a.high == b.high && a.low == b.low;
    }
    friend constexpr bool operator!=(const Wide& a, const Wide& b) { return !(a == b); }
};

/// Which product of coordinates an entry of Moments::second belongs to.
enum Product : std::uint8_t {
    product_xx = 0,
    product_yy = 1,
    product_zz = 2,
    product_xy = 3,
    product_yz = 4,
    product_zx = 5
};

/// Moments of a solid of unit density, about the lattice's origin and in lattice units, scaled so that every
/// one is an integer. With V = volume, F = first, S = second:
///
///     centroid along axis a         F[a] / (2 V)
///     product of inertia J(a, b)    S[ab] / 12 - F[a] F[b] / (4 V)     (integral of the product of the
///                                                                      distances from the centroid)
///     inertia about the centroid    I(x, x) = J(y, y) + J(z, z),   I(x, y) = -J(x, y),   and so on
struct Moments {
    std::uint64_t volume; ///< cells; at most 2^60
    Wide first[3];        ///< 2 * integral of x, y, z over the solid; at most 2^80
    Wide second[6];       ///< 12 * integral of xx, yy, zz, xy, yz, zx over the solid; at most 2^102
};

/// Moments of the inner and of the outer solid.
struct SolidMoments {
    Moments inner;
    Moments outer;
};

/// The moments of a tree's solids. Cost: O(nodes), no scratch.
SolidMoments moments(const Octree& tree);

/// Surface and shape of one of the two solids, the union of its closed leaves.
struct SurfaceMeasures {
    /// Area of the solid's boundary that is perpendicular to x, y, z, in unit squares, both directions
    /// together; at most 2^60 + 2^40. What is outside the root is not solid, so where the solid reaches the
    /// root's border, the border counts.
    std::uint64_t area[3];
    /// Euler characteristic of the closed solid, V - E + F - C of its cells, their faces, edges and corners:
    /// pieces that hang together (by a corner at least: 26-connectivity), minus tunnels, plus cavities.
    std::int64_t euler_closed;
    /// Euler characteristic of the solid's interior: the same for pieces that share a face (6-connectivity).
    std::int64_t euler_open;
};

/// Outcome of a surface measurement.
struct SurfaceOutcome {
    Status status;
    SurfaceMeasures inner;
    SurfaceMeasures outer;
};

/// Measures surface and Euler characteristic of both solids: begin, step until nothing is left, finish; holds
/// all of its state, O(depth). The tree must stay as it is meanwhile.
///
/// Source: the leaves cut space into open cubes, squares, segments and points; see cluster_walk.hpp. A square
/// between a solid and another leaf is boundary. The Euler characteristic with compact support is additive
/// over such pieces, each of which counts (-1)^dimension; on the closed solid it is the usual one, on the
/// open one the usual one negated, as the dimension is odd (Poincare duality). In the plane: Samet and
/// Tamminen, "Computing Geometric Properties of Images Represented by Linear Quadtrees", PAMI 7(2), 1985.
class OSEM_OF_INDEX_WIDTH SurfaceMeasurement {
  public:
    /// A measurement that was not finished is given up first.
    void begin(const Octree& tree);

    /// Visits up to `clusters` clusters; false when none is left. Clusters in all: at most 27 * (8 * nodes +
    /// 1).
    bool step(std::uint32_t clusters);

    /// Clusters visited so far.
    std::uint64_t clusters_visited() const { return walk_.visited(); }

    /// Status: ok; unfinished when clusters are left or nothing was begun; the measures are then incomplete.
    SurfaceOutcome finish() const;

  private:
    ClusterWalk walk_;
    SurfaceMeasures inner_ = {};
    SurfaceMeasures outer_ = {};
    bool done_ = false;
};

/// Measures in one call: begin, step to the end, finish. `job` is the working memory.
SurfaceOutcome measure_surface(SurfaceMeasurement& job, const Octree& tree);

} // namespace osem

#endif
