// The faces around a lattice point, sheet by sheet.
#ifndef OSEM_BOUNDARY_LINK_CYCLE_HPP
#define OSEM_BOUNDARY_LINK_CYCLE_HPP

#include <cstdint>

namespace osem {

/// A square of the surface at a point: the side across axis `normal` of the solid cell `cell`, one of the
/// eight cells around the point (bit a: it lies on the positive side of axis a). The cell behind is empty.
struct Quad {
    std::uint8_t cell;
    std::uint8_t normal;

    constexpr unsigned bit(unsigned axis) const { return (cell >> axis) & 1U; }
    constexpr std::uint8_t facing() const {
        return static_cast<std::uint8_t>(2U * normal + 1U - bit(normal));
    }
    /// A name below 24.
    constexpr unsigned number() const { return 8U * normal + cell; }
    /// The way along its first edge, counter-clockwise around the point as seen from outside, in quarter
    /// turns from the plane's first axis; its last edge is one more.
    unsigned first_way() const;
    unsigned last_way() const { return (first_way() + 1U) & 3U; }
};

/// The next axis in cyclic order.
constexpr unsigned axis_after(unsigned axis) { return axis == 2U ? 0U : axis + 1U; }

/// The axis that the ways 0 and 2 (0) or 1 and 3 (1) run along in a plane. Seen from outside, the second one
/// is a quarter turn counter-clockwise from the first.
constexpr unsigned plane_axis(unsigned facing, unsigned way) {
    const unsigned turned = (way & 1U) ^ ((facing & 1U) ^ 1U);
    const unsigned first = axis_after(facing / 2U);
    return turned == 0 ? first : axis_after(first);
}

/// The squares of one sheet around a point, counter-clockwise as seen from outside.
struct LinkCycle {
    Quad quads[12];
    std::uint8_t count;
    std::uint16_t creases; ///< bit i: the surface turns between quad i and its successor

    bool has_crease(unsigned i) const { return ((creases >> i) & 1U) != 0; }
    unsigned after(unsigned i) const { return i + 1U == count ? 0U : i + 1U; }
    unsigned next_crease(unsigned i) const;
    unsigned crease_count() const;
    /// The way from the point along the crease behind quad i: 2 * axis + 1 if it is the positive one.
    unsigned direction(unsigned i) const;
};

/// The cycle of a square among the cells in the mask `solid`. The two squares of one cube belong together
/// where an edge has four.
LinkCycle link_cycle(std::uint8_t solid, Quad first);

} // namespace osem

#endif
