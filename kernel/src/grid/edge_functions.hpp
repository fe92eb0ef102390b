// A small triangle as seen along an axis of the lattice.
#ifndef OSEM_GRID_EDGE_FUNCTIONS_HPP
#define OSEM_GRID_EDGE_FUNCTIONS_HPP

#include <cstdint>

#include "grid/four.hpp"
#include "grid/seen_edge.hpp"
#include "grid/small_triangle.hpp"

namespace osem {

/// What a small triangle is seen to have of a grid's points, moved by e along the axis that comes first and
/// by e^2 along the other one, or to meet of its squares: those where the function of no edge is below 0. A
/// function is linear, so it goes from place to place by one addition; it is divided by the octants' side,
/// rounded down, which leaves its sign. Four rows go side by side.
class EdgeFunctions {
  public:
    enum class Of { points, squares };

    /// Rows of places along u from the one on that the triangle's corners are told from, which is a point or
    /// a square's lower corner. Turn: 1 if the corners are seen to turn to the left, -1 to the right; they
    /// must turn.
    EdgeFunctions(const SmallTriangle& triangle, int u, int v, int turn, int shift, Of of)
        : EdgeFunctions(Seen(triangle.corners[0], u, v),
                        Seen(triangle.corners[1], triangle.corners[2], turn > 0, u, v),
                        Seen(triangle.corners[2], triangle.corners[1], turn > 0, u, v), u < v, shift, of) {}

    /// Goes on to the next four rows, the first time to the first ones, and stands at their first places.
    void begin_four() {
        for (unsigned edge = 0; edge < 3; ++edge) {
            edges_[edge].now = edges_[edge].value;
            edges_[edge].value += edges_[edge].by_four_rows;
        }
    }
    /// Of the places at which it stands, in its highest bit: whether the triangle does not have it.
    void outside(Four& result) const { result = edges_[0].now | edges_[1].now | edges_[2].now; }
    void next() {
        for (unsigned edge = 0; edge < 3; ++edge) edges_[edge].now += edges_[edge].by_u;
    }

    /// Goes on to the next four rows as well. Of each row so many places, 1 to 32: a bit for each that the
    /// triangle has, the first one lowest.
    void see_four(std::uint32_t places, Four& seen) {
        begin_four();
        seen = Four{};
        for (std::uint32_t left = places; left != 0; --left, next()) { // the last one is the highest bit
            Four not_had = {};
            outside(not_had);
            seen = seen >> 1 | (~not_had & 0x80000000U);
        }
        seen >>= 32 - places;
    }

  private:
    // A corner as it is seen, or one of two.
    struct Seen {
        std::int32_t u;
        std::int32_t v;

        Seen(const std::int32_t (&corner)[3], int u_axis, int v_axis)
            : u(corner[u_axis]), v(corner[v_axis]) {}
        Seen(const std::int32_t (&a)[3], const std::int32_t (&b)[3], bool first, int u_axis, int v_axis)
            : u(chosen(first, a[u_axis], b[u_axis])), v(chosen(first, a[v_axis], b[v_axis])) {}
    };

    // How far a place is on the inner side of an edge, times its length. Of a square that is said of the
    // corner that is furthest; it is met if that is inside, not if it is on the edge. A point on an edge is
    // inside if the movement leads there.
    struct Edge {
        Four value; ///< two's complement; below 2^30, with steps over as many places
                    ///< and rows as a box has, 20 at most, as the side is 2^18 at most
        Four now;
        std::uint32_t by_u;
        std::uint32_t by_four_rows;

        Edge(const Seen& a, const Seen& b, bool u_first, int shift, Of of) {
            const std::int32_t step_v = b.u - a.u;
            const std::int32_t step_u = a.v - b.v;
            const std::int64_t inside =
                static_cast<std::int64_t>(a.u) * b.v - static_cast<std::int64_t>(a.v) * b.u;
            std::int64_t at = 0;
            if (of == Of::points) {
                // Where the step along the first axis is below 0, or it is 0 and the other one is: asked in
                // one.
                const std::int64_t first = u_first ? step_u : step_v;
                const bool leads_out = first * (std::int64_t{1} << 32) + (u_first ? step_v : step_u) < 0;
                at = (inside - (leads_out ? 1 : 0)) >> shift;
            } else {
                at = ((inside - 1) >> shift) + (step_u > 0 ? step_u : 0) + (step_v > 0 ? step_v : 0);
            }
            const auto by_v = static_cast<std::uint32_t>(step_v);
            by_u = static_cast<std::uint32_t>(step_u);
            by_four_rows = 4 * by_v;
            set_multiples(value, by_v);
            value += static_cast<std::uint32_t>(at);
            now = value;
        }
    };

    EdgeFunctions(const Seen& a, const Seen& b, const Seen& c, bool u_first, int shift, Of of)
        : edges_{Edge(a, b, u_first, shift, of), Edge(b, c, u_first, shift, of),
                 Edge(c, a, u_first, shift, of)} {}

    Edge edges_[3];
};

} // namespace osem

#endif
