// Triangles that are small in a grid, as seen along an axis of the lattice.
#ifndef OSEM_GRID_EDGE_FUNCTIONS_HPP
#define OSEM_GRID_EDGE_FUNCTIONS_HPP

#include <cstdint>

#include "grid/four.hpp"

namespace osem {

/// Where wrong guesses at branches cost much, triangles that are less than so many octants long along each
/// axis are dealt with apart: each place of a grid in their bounding box is looked at, so that no ends of
/// edges are to be found, which nobody foresees.
constexpr std::int32_t small_octants = 16;

/// The corners of such a triangle: how far they are from a place in or beside the box.
struct SmallTriangle {
    std::int32_t corners[3][3];
};

/// What a small triangle is seen to have of a grid's points, moved by (e, e^2), or to meet of its squares:
/// those where the function of no edge is below 0. A function is linear, so it goes from place to place by
/// one addition; it is divided by the octants' side, rounded down, which leaves its sign. Four rows go side
/// by side.
class EdgeFunctions {
  public:
    enum class Of { points, squares };

    /// Rows of 1 to 32 places along u from the one on that the triangle's corners are told from, which is a
    /// point or a square's lower corner. Turn: 1 if the corners are seen to turn to the left, -1 to the
    /// right; they must turn.
    EdgeFunctions(const SmallTriangle& triangle, int u, int v, int turn, int shift, Of of,
                  std::uint32_t places)
        : edges_{Edge(triangle.corners[2], triangle.corners[0], u, v, turn, shift, of),
                 Edge(triangle.corners[0], triangle.corners[1], u, v, turn, shift, of),
                 Edge(triangle.corners[1], triangle.corners[2], u, v, turn, shift, of)},
          places_(places) {}

    /// Goes on to the next four rows, the first time to the first ones.
    void see_four() {
        Four values[3];
        for (unsigned edge = 0; edge < 3; ++edge) {
            values[edge] = edges_[edge].value;
            edges_[edge].value += edges_[edge].by_four_rows;
        }
        seen_ = Four{};
        for (std::uint32_t left = places_; left != 0; --left) { // the last one is the highest bit
            seen_ = seen_ >> 1 | (~(values[0] | values[1] | values[2]) & 0x80000000U);
            for (unsigned edge = 0; edge < 3; ++edge) values[edge] += edges_[edge].by_u;
        }
        seen_ >>= 32 - places_;
    }
    /// Of each of these the places that it has, a bit for each, the first one lowest.
    const Four& seen() const { return seen_; }

  private:
    // How far a place is on the inner side of an edge, times its length. Of a square that is said of the
    // corner that is furthest; it is met if that is inside, not if it is on the edge. A point on an edge is
    // inside if the movement leads there.
    struct Edge {
        Four value; ///< two's complement; below 2^30, with steps over 32 places and 20 rows, as the
                    ///< side is 2^18 at most
        std::uint32_t by_u;
        std::uint32_t by_four_rows;

        Edge(const std::int32_t (&a)[3], const std::int32_t (&b)[3], int u, int v, int turn, int shift,
             Of of) {
            const std::int32_t step_v = turn * (b[u] - a[u]);
            const std::int32_t step_u = -turn * (b[v] - a[v]);
            const std::int64_t to_u = -a[u];
            const std::int64_t to_v = -a[v];
            const std::int64_t inside = to_u * step_u + to_v * step_v;
            std::int64_t at = 0;
            if (of == Of::points) {
                at = (inside - (step_u < 0 || (step_u == 0 && step_v < 0) ? 1 : 0)) >> shift;
            } else {
                at = ((inside - 1) >> shift) + (step_u > 0 ? step_u : 0) + (step_v > 0 ? step_v : 0);
            }
            const auto by_v = static_cast<std::uint32_t>(step_v);
            by_u = static_cast<std::uint32_t>(step_u);
            by_four_rows = 4 * by_v;
            value = static_cast<std::uint32_t>(at) + Four{0, by_v, 2 * by_v, 3 * by_v};
        }
    };

    Edge edges_[3];
    std::uint32_t places_;
    Four seen_ = {};
};

} // namespace osem

#endif
