// Two-dimensional predicates on faces projected along an axis.
#ifndef OSEM_GEOMETRY_PROJECTION_HPP
#define OSEM_GEOMETRY_PROJECTION_HPP

#include "geometry/plane.hpp"
#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

/// The two axes that remain when one is projected away, in ascending order.
struct Projection {
    int u;
    int v;
    explicit constexpr Projection(int along) : u(along == 0 ? 1 : 0), v(along == 2 ? 1 : 2) {}
};

/// Which side of the projected line a -> b the point q lies on: positive to the left (u to the right, v up).
/// Antisymmetric in a and b. At most 2^41 + 2^21 in magnitude, as its type says.
inline auto orientation(const Point& a, const Point& b, const Point& q, const Projection& p) {
    return difference(b, a, p.u) * (QueryCoordinate::claim(q.at[p.v]) - VertexCoordinate::claim(a.at[p.v])) -
           difference(b, a, p.v) * (QueryCoordinate::claim(q.at[p.u]) - VertexCoordinate::claim(a.at[p.u]));
}

/// An infinitesimal move of a projected point: by the sign `u` along u and the sign `v` along v, one of them
/// infinitely longer than the other. A moved lattice point lies on no line through lattice points other than
/// those it moves along, so every predicate on it has an answer other than 0.
struct Nudge {
    int u;
    int v;
    bool u_leads;
};

/// The winding number of a ring around the nudged projection of q, counting edges to the right of it.
inline std::int32_t ring_winding(const Solid& solid, const Ring& ring, const Point& q, const Projection& p,
                                 Nudge nudge) {
    const std::int32_t height =
        q.at[p.v] + (nudge.v > 0 ? 1 : 0); // a vertex is below the nudged q when below this
    std::int32_t winding = 0;
    const Point* a = &solid.vertices[ring.corners[ring.count - 1]];
    bool a_below = a->at[p.v] < height;
    for (std::uint32_t i = 0; i < ring.count; ++i) {
        const Point* b = &solid.vertices[ring.corners[i]];
        const bool b_below = b->at[p.v] < height;
        if (a_below != b_below) {
            const int rise = a_below ? 1 : -1;
            int side = orientation(*a, *b, q, p).sign();
            if (side == 0 && !nudge.u_leads) side = difference(*b, *a, p.u).sign() * nudge.v;
            if (side == 0) side = -rise * nudge.u;
            if (side == rise) winding += rise;
        }
        a = b;
        a_below = b_below;
    }
    return winding;
}

} // namespace osem

#endif
