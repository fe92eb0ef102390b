// Edges of faces as seen along an axis of the lattice.
#ifndef OSEM_GRID_SEEN_EDGE_HPP
#define OSEM_GRID_SEEN_EDGE_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// What is seen along an axis: the other two, in ascending order.
constexpr int u_of[3] = {1, 0, 0};
constexpr int v_of[3] = {2, 2, 1};

/// One of two numbers. What is as often true as not is no branch to be guessed where wrong guesses cost much.
constexpr std::int32_t chosen(bool first, std::int32_t a, std::int32_t b) {
    if constexpr (guesses_cost_much) {
        return b ^ ((a ^ b) & -std::int32_t{first});
    } else {
        return first ? a : b;
    }
}

/// An edge as seen in the plane of two axes, from its low end along v to its high one.
struct SeenEdge {
    std::int32_t u;
    std::int32_t v;
    std::int32_t end_u;
    std::int32_t end_v;
    bool rises; ///< it runs to its high end

    SeenEdge(const Point& a, const Point& b, int u_axis, int v_axis) {
        rises = a.at[v_axis] < b.at[v_axis];
        u = chosen(rises, a.at[u_axis], b.at[u_axis]);
        v = chosen(rises, a.at[v_axis], b.at[v_axis]);
        end_u = chosen(rises, b.at[u_axis], a.at[u_axis]);
        end_v = chosen(rises, b.at[v_axis], a.at[v_axis]);
    }

    std::int32_t run() const { return end_u - u; }
    std::int32_t rise() const { return end_v - v; }
    /// Below 0 to the left of the edge's line, that is where u is less. Below 2^42, as coordinates are 2^20
    /// at most and those asked for are in the root.
    std::int64_t at(std::int32_t to_u, std::int32_t to_v) const {
        return std::int64_t{to_u - u} * rise() - std::int64_t{to_v - v} * run();
    }
};

/// Such a value divided by the octants' side. What is further from 0 than all steps along and across a grid
/// lead, 66 of 2^20 at most, keeps its sign and may be clipped: so the rest has 32 bits.
inline std::int32_t scaled(std::int64_t value, int shift) {
    constexpr std::int64_t most = std::int64_t{1} << 27;
    value >>= shift;
    return static_cast<std::int32_t>(value > most ? most : value < -most ? -most : value);
}

} // namespace osem

#endif
