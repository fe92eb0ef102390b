#include "osem/measure.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// Adds value * 2^shift. Precondition: value < 2^44, shift <= 60, so the addend is below 2^104.
void add(Wide& sum, std::uint64_t value, unsigned shift) {
    const std::uint64_t low = value << shift;
    const std::uint64_t high = shift == 0 ? 0 : value >> (64 - shift);
    sum.low += low;
    sum.high += high + (sum.low < low ? 1U : 0U);
}

// A cube with minimum corner c and side s, of volume s^3 = 2^shift; d = 2 c + s is twice its centre, at most
// 2^21. Integrals over [c, c + s] are the whole cube's when the other two axes give s each:
//
//     2 * integral of x    = (c + s)^2 - c^2        = s (2 c + s)             = s d
//     12 * integral of xx  = 4 ((c + s)^3 - c^3)    = s (12 cc + 12 cs + 4 ss) = s (3 dd + ss)
//     12 * integral of xy  = 3 (s d_x) (s d_y)
//
// So per cube: 2 Mx = s^3 d_x, 12 Mxx = s^3 (3 d_x d_x + s s), 12 Mxy = s^3 * 3 d_x d_y. The factors of s^3
// are below 3 * 2^42 + 2^40 < 2^44. Summed over the whole root they are 2^80 and at most 4 * 2^100, which
// bounds every solid, as no addend is negative.
void add_cube(Moments& m, const Octant& octant) {
    const auto side = static_cast<std::uint64_t>(octant.side());
    const auto shift = static_cast<unsigned>(3 * (lattice_bits - octant.level));
    m.volume += volume_at(octant.level);
    std::uint64_t d[3];
    for (unsigned a = 0; a < 3; ++a) d[a] = 2 * static_cast<std::uint64_t>(octant.corner.at[a]) + side;
    for (unsigned a = 0; a < 3; ++a) {
        add(m.first[a], d[a], shift);
        add(m.second[product_xx + a], 3 * d[a] * d[a] + side * side, shift);
        add(m.second[product_xy + a], 3 * d[a] * d[a == 2 ? 0 : a + 1], shift);
    }
}

void add_leaf(SolidMoments& m, const Octant& octant, Colour colour) {
    if (colour == Colour::black) add_cube(m.inner, octant);
    add_cube(m.outer, octant);
}

} // namespace

SolidMoments moments(const Octree& tree) {
    SolidMoments m = {};
    if (tree.top.is_uniform()) {
        if (tree.top.may != 0) add_leaf(m, root_octant, tree.top.colour(0));
        return m;
    }
    for (NodeWalk walk(tree); !walk.done(); walk.next()) {
        const Node& node = walk.node();
        for (std::uint8_t left = node.may; left != 0; left = without_lowest(left)) {
            const unsigned child = lowest(left);
            add_leaf(m, walk.octant().child(child), node.colour(child));
        }
    }
    return m;
}

} // namespace osem
