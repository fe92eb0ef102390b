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
    /// a square's lower corner. Area: twice that of the triangle as it is seen, above 0 if its corners are
    /// seen to turn to the left, below if to the right; not 0. It is a component of its plane's normal, so
    /// below 2^62.
    [[gnu::always_inline]] EdgeFunctions(const SmallTriangle& triangle, int u, int v, std::int64_t area,
                                         int shift, Of of)
        : EdgeFunctions(triangle.corners[0], triangle.corners[1], triangle.corners[2],
                        (triangle.corners[1] ^ triangle.corners[2]) & static_cast<std::int32_t>(area >> 62),
                        (area ^ (area >> 62)) - (area >> 62), u, v, shift, of) {}

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
    // How far a place is on the inner side of an edge, times its length. Of a square that is said of the
    // corner that is furthest; it is met if that is inside, not if it is on the edge. A point on an edge is
    // inside if the movement leads there.
    struct Edge {
        Four value; ///< two's complement; below 2^30, with steps over as many places
                    ///< and rows as a box has, 20 at most, as the side is 2^18 at most
        Four now;
        Four by_u;
        Four by_four_rows;

        [[gnu::always_inline]] Edge(const FourSigned& a, const FourSigned& b, std::int64_t inside, int u_axis,
                                    int v_axis, int shift, Of of) {
            const unsigned u = place_of_axis(u_axis);
            const unsigned v = place_of_axis(v_axis);
            const FourSigned to_b = b - a;
            const std::int32_t step_v = to_b[u];
            const std::int32_t step_u = -to_b[v];
            std::int64_t at = 0;
            if (of == Of::points) {
                // Where the step along the first axis is below 0, or it is 0 and the other one is: asked in
                // one.
                const bool u_first = u_axis < v_axis;
                const std::int64_t first = u_first ? step_u : step_v;
                const bool leads_out = first * (std::int64_t{1} << 32) + (u_first ? step_v : step_u) < 0;
                at = (inside - (leads_out ? 1 : 0)) >> shift;
            } else {
                at = ((inside - 1) >> shift) + (step_u > 0 ? step_u : 0) + (step_v > 0 ? step_v : 0);
            }
            Four by_v = {};
            set_all(by_v, to_b, u);
            set_all(by_u, a - b, v);
            by_four_rows = 4 * by_v;
            set_multiples(value, by_v);
            value += static_cast<std::uint32_t>(at);
            now = value;
        }
    };

    // The second and the third corner change places where they differ. What a place is on the inner sides of
    // all edges is in sum the area.
    [[gnu::always_inline]] EdgeFunctions(const FourSigned& a, const FourSigned& b, const FourSigned& c,
                                         const FourSigned& differing, std::int64_t area, int u, int v,
                                         int shift, Of of)
        : EdgeFunctions(a, b ^ differing, c ^ differing, area, inside_of(a, b ^ differing, u, v),
                        inside_of(b ^ differing, c ^ differing, u, v), u, v, shift, of) {}
    [[gnu::always_inline]] EdgeFunctions(const FourSigned& a, const FourSigned& b, const FourSigned& c,
                                         std::int64_t area, std::int64_t of_ab, std::int64_t of_bc, int u,
                                         int v, int shift, Of of)
        : edges_{Edge(a, b, of_ab, u, v, shift, of), Edge(b, c, of_bc, u, v, shift, of),
                 Edge(c, a, area - of_ab - of_bc, u, v, shift, of)} {}
    [[gnu::always_inline]] static std::int64_t inside_of(const FourSigned& a, const FourSigned& b, int u,
                                                         int v) {
        return std::int64_t{a[place_of_axis(u)]} * b[place_of_axis(v)] -
               std::int64_t{a[place_of_axis(v)]} * b[place_of_axis(u)];
    }

    Edge edges_[3];
};

} // namespace osem

#endif
