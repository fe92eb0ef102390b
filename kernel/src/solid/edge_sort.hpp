// Edges, ordered by the place they lie at.
#ifndef OSEM_SOLID_EDGE_SORT_HPP
#define OSEM_SOLID_EDGE_SORT_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

/// An order of edges in which those of one place stand together, whichever way they run. A place is a pair of
/// vertex indices, or, given the vertices, a pair of points.
class EdgeOrder {
  public:
    explicit EdgeOrder(const Point* vertices) : vertices_(vertices) {}

    /// 1 when the edge runs from its lower to its higher end, -1 the other way, 0 when it has no length.
    int direction(const Edge& e) const { return -compare_ends(e.from, e.to); }

    int operator()(const Edge& a, const Edge& b) const {
        const bool a_up = direction(a) >= 0;
        const bool b_up = direction(b) >= 0;
        const int low = compare_ends(a_up ? a.from : a.to, b_up ? b.from : b.to);
        if (low != 0) return low;
        return compare_ends(a_up ? a.to : a.from, b_up ? b.to : b.from);
    }

  private:
    int compare_ends(std::uint32_t a, std::uint32_t b) const {
        if (vertices_ == nullptr) return a == b ? 0 : a < b ? -1 : 1;
        const Point& p = vertices_[a];
        const Point& q = vertices_[b];
        for (int axis = 0; axis < 3; ++axis) {
            if (p.at[axis] != q.at[axis]) return p.at[axis] < q.at[axis] ? -1 : 1;
        }
        return 0;
    }

    const Point* vertices_;
};

/// Sorts in place: O(count log count) at worst, no recursion, a stack of 32 ranges.
void sort_edges(Edge* edges, std::uint32_t count, const EdgeOrder& order);

} // namespace osem

#endif
