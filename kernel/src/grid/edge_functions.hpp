// Triangles that are small in a grid, as seen along an axis of the lattice.
#ifndef OSEM_GRID_EDGE_FUNCTIONS_HPP
#define OSEM_GRID_EDGE_FUNCTIONS_HPP

#include <cstdint>

#include "grid/seen_edge.hpp"
#include "osem/solid.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// Where wrong guesses at branches cost much, triangles whose bounding box has few places in a grid are dealt
/// with apart: each of these is looked at, so that no ends of edges are to be found, which nobody foresees.
constexpr std::uint32_t most_small_rays = 160;   ///< in the box
constexpr std::uint32_t most_small_octants = 16; ///< along each of its sides

/// What a triangle is seen to have of a grid's points, moved by (e, e^2), or to meet of its squares: those
/// where the function of no edge is below 0. A function is linear, so it goes from place to place by one
/// addition; it is divided by the octants' side, rounded down, which leaves its sign. Two of them stand side
/// by side in a word, the lower one borrowing from the upper one while it is below 0.
class EdgeFunctions {
  public:
    enum class Of { points, squares };

    /// From a place on, a point or a square's lower corner. Turn: 1 if the corners are seen to turn to the
    /// left, -1 to the right; they must turn.
    EdgeFunctions(const Solid& solid, const std::uint32_t* corners, int u, int v, int turn, const Point& from,
                  int shift, Of of)
        : EdgeFunctions(Function(solid, corners[2], corners[0], u, v, turn, from, shift, of),
                        Function(solid, corners[0], corners[1], u, v, turn, from, shift, of),
                        Function(solid, corners[1], corners[2], u, v, turn, from, shift, of)) {}

    bool has() const { return (static_cast<std::uint64_t>(pair_ | third_) & signs) == 0; }

    /// Goes on along u by one; back to where it began, and along v by one.
    void next() {
        pair_ += pair_by_u_;
        third_ += third_by_u_;
    }
    void next_row() {
        pair_ = row_pair_ += pair_by_v_;
        third_ = row_third_ += third_by_v_;
    }

  private:
    // How far a place is on the inner side of an edge, times its length. Of a square that is said of the
    // corner that is furthest; it is met if that is inside, not if it is on the edge. A point on an edge is
    // inside if the movement leads there.
    struct Function {
        std::int32_t value;
        std::int32_t by_u;
        std::int32_t by_v;

        Function(const Solid& solid, std::uint32_t first, std::uint32_t second, int u, int v, int turn,
                 const Point& from, int shift, Of of) {
            const Point& a = solid.vertices[first];
            const Point& b = solid.vertices[second];
            by_v = turn * (b.at[u] - a.at[u]);
            by_u = -turn * (b.at[v] - a.at[v]);
            const std::int64_t to_u = from.at[u] - a.at[u];
            const std::int64_t to_v = from.at[v] - a.at[v];
            const std::int64_t inside = to_u * by_u + to_v * by_v; // below 2^42
            if (of == Of::points) {
                value = scaled(inside - (by_u < 0 || (by_u == 0 && by_v < 0) ? 1 : 0), shift);
            } else {
                value = scaled(inside - 1, shift) + (by_u > 0 ? by_u : 0) + (by_v > 0 ? by_v : 0);
            }
        }
    };

    static constexpr std::uint64_t signs = 0x8000000080000000;
    static std::int64_t side_by_side(std::int32_t low, std::int32_t high) {
        return low + high * (std::int64_t{1} << 32); // either is below 2^28, with all steps
    }

    EdgeFunctions(const Function& a, const Function& b, const Function& c)
        : pair_(side_by_side(a.value, b.value)), third_(side_by_side(c.value, 0)), row_pair_(pair_),
          row_third_(third_), pair_by_u_(side_by_side(a.by_u, b.by_u)), third_by_u_(side_by_side(c.by_u, 0)),
          pair_by_v_(side_by_side(a.by_v, b.by_v)), third_by_v_(side_by_side(c.by_v, 0)) {}

    std::int64_t pair_;
    std::int64_t third_;
    std::int64_t row_pair_;
    std::int64_t row_third_;
    std::int64_t pair_by_u_;
    std::int64_t third_by_u_;
    std::int64_t pair_by_v_;
    std::int64_t third_by_v_;
};

} // namespace osem

#endif
