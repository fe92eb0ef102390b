// The integer lattice: the root octant, its points, its octants and the order of children.
//
// Child k of an octant lies on the high side in x where bit 0 of k is set, in y where bit 1 is, in z where
// bit 2 is: Morton order, and the numbering of figure 1a of Trstenjak, Zalik and Guid, "An Algorithm for
// Boundary to Octree Conversion", Informatica 2/91.
#ifndef OSEM_LATTICE_HPP
#define OSEM_LATTICE_HPP

#include <cstdint>

#include "osem/bounded.hpp"

namespace osem {

/// Bits of a lattice coordinate; the widest for which every orientation predicate fits in signed 64 bits.
constexpr int lattice_bits = 20;

/// Side of the root octant in lattice units. Vertices have coordinates in [0, root_side], both included.
constexpr std::int32_t root_side = std::int32_t{1} << lattice_bits;

/// Greatest depth of a tree: leaves of side 1. With centre leaves the greatest is max_depth - 1, because
/// the centre of a leaf of side 1 is no lattice point.
constexpr int max_depth = lattice_bits;

/// Cells of side 1 in the root octant, the unit of volume: 2^60.
constexpr std::uint64_t root_volume = std::uint64_t{1} << (3 * lattice_bits);

enum Axis : std::uint8_t { axis_x = 0, axis_y = 1, axis_z = 2 };

/// A lattice point (x, y, z); 12 bytes, so that vertex tables may lie in flash.
struct Point {
    std::int32_t at[3];

    constexpr std::int32_t x() const { return at[0]; }
    constexpr std::int32_t y() const { return at[1]; }
    constexpr std::int32_t z() const { return at[2]; }
    friend constexpr bool operator==(const Point& a, const Point& b) {
        return a.at[0] == b.at[0] && a.at[1] == b.at[1] && a.at[2] == b.at[2];
    }
    friend constexpr bool operator!=(const Point& a, const Point& b) { return !(a == b); }
};
static_assert(sizeof(Point) == 12, "points are packed");

/// An octant: the cube with minimum corner `corner` and side root_side >> level. Corners are multiples of
/// the side. Which of its border belongs to it is said where it matters (open for classification).
struct Octant {
    Point corner;
    std::uint8_t level;

    constexpr std::int32_t side() const { return root_side >> level; }

    /// Child k in [0, 8), one level deeper. Precondition: level < max_depth.
    constexpr Octant child(unsigned k) const {
        const std::int32_t half = side() / 2;
        return Octant{
            Point{{corner.at[0] + ((k & 1U) != 0 ? half : 0), corner.at[1] + ((k & 2U) != 0 ? half : 0),
                   corner.at[2] + ((k & 4U) != 0 ? half : 0)}},
            static_cast<std::uint8_t>(level + 1)};
    }

    /// The octant one level higher that holds this one. Precondition: level > 0.
    constexpr Octant parent() const {
        const std::int32_t mask = -2 * side();
        return Octant{Point{{corner.at[0] & mask, corner.at[1] & mask, corner.at[2] & mask}},
                      static_cast<std::uint8_t>(level - 1)};
    }
};

/// Whether a value is an octant of the root: its level in [0, max_depth], its corner in the root and a
/// multiple of its side.
constexpr bool is_octant(const Octant& octant) {
    if (octant.level > max_depth) return false;
    for (const std::int32_t coordinate : octant.corner.at) {
        const bool on_grid = (coordinate & (octant.side() - 1)) == 0;
        if (coordinate < 0 || coordinate >= root_side || !on_grid) return false;
    }
    return true;
}

/// Number of lattice cells (side 1) in an octant of a level: 8^(lattice_bits - level).
constexpr std::uint64_t volume_at(int level) { return std::uint64_t{1} << (3 * (lattice_bits - level)); }

constexpr Octant root_octant{Point{{0, 0, 0}}, 0};

// The ranges on which the predicates are built. A reference point's step may start one unit below the root,
// so a query coordinate is in [-1, 2^20]; a vertex coordinate is in [0, 2^20].
using VertexCoordinate = Bounded<0, root_side>;
using QueryCoordinate = Bounded<-1, root_side>;
using VertexDifference = decltype(VertexCoordinate::claim(0) - VertexCoordinate::claim(0));
using NormalComponent = decltype(VertexDifference::claim(0) * VertexDifference::claim(0) -
                                 VertexDifference::claim(0) * VertexDifference::claim(0));
using QueryDifference = decltype(QueryCoordinate::claim(0) - VertexCoordinate::claim(0));
using PlaneValue = decltype(NormalComponent::claim(0) * QueryDifference::claim(0) +
                            NormalComponent::claim(0) * QueryDifference::claim(0) +
                            NormalComponent::claim(0) * QueryDifference::claim(0));

static_assert(sizeof(VertexDifference) == 4 && sizeof(QueryDifference) == 4, "differences stay in 32 bits");
static_assert(sizeof(PlaneValue) == 8, "plane values stay in 64 bits");

} // namespace osem

#endif
