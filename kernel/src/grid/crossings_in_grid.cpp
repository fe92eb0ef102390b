// What a face adds to the winding numbers of a grid's reference points.
#include "grid/face_in_grid.hpp"
#include "grid/seen_edge.hpp"
#include "grid/stair.hpp"

namespace osem {

namespace {

// How many reference points of a row along u are on the left of an edge, row by row. Moved by (e, e^2) the
// points are to the right of an edge on which they would be.
class LeftOfEdge {
  public:
    LeftOfEdge(const SeenEdge& edge, const OctantGrid& grid, int u, int v, int row)
        : last_(stair(edge, grid, grid.reference().at[u], grid.reference().at[v], row)) {}

    int count() const { return last_.floor() + 1; }
    void next() { last_.next(); }

  private:
    static EdgeStair stair(const SeenEdge& edge, const OctantGrid& grid, std::int32_t u, std::int32_t v,
                           int row) {
        return {{edge.rise(), edge.run()},
                ~scaled(edge.at(u, v), grid.shift) + row * edge.run(),
                grid.side() - 1,
                clipped((edge.u - u) >> grid.shift, -1, grid.side() - 1)};
    }

    EdgeStair last_; // the last of them
};

} // namespace

// Where rays along an axis pass through the face, and what that adds to winding numbers. The rays' reference
// points lie before a face's plane, or behind it, as seen from where the normal, turned, points away from.
// Dividends are bounded as in PassedOctants.
class FaceInGrid::Passages {
  public:
    Passages(const Plane& plane, const OctantGrid& grid, int axis, int guess, RowWindings& windings)
        : Passages(plane, grid, axis, guess, plane.normal(axis).value() < 0 ? -1 : 1, windings) {}

    // Rays in a row along u, around which the face winds so often.
    void add(int v, const IndexRange& along_u, std::int32_t winding) {
        if (along_u.empty()) return;
        PlaneStair last = rows_.at(along_u.first, v);
        // Against the normal, into the solid. (x, z) is left-handed as seen along y.
        const std::int32_t number = axis_ == axis_y ? winding : -winding;
        if (axis_ == axis_x) {
            const auto row = static_cast<std::uint32_t>(grid_.row(along_u.first, v));
            return windings_.add_behind(row, row + along_u.count(), last, number);
        }
        for (int u = along_u.first; u <= along_u.last; ++u, last.next()) {
            if (!last.is_within()) continue;
            const int first = last.floor() + 1;
            windings_.change_first(axis_ == axis_y ? grid_.row(first, v) : grid_.row(v, first), number);
        }
    }

  private:
    Passages(const Plane& plane, const OctantGrid& grid, int axis, int guess, int turn, RowWindings& windings)
        : Passages(turn * plane.normal(axis).value(),
                   ~((turn * plane.at(grid.reference()).value() - nudge(plane, turn)) >> grid.shift),
                   -turn * plane.normal(u_of[axis]).value(), -turn * plane.normal(v_of[axis]).value(), grid,
                   axis, guess, windings) {}
    Passages(std::int64_t d, std::int64_t n, std::int64_t by_u, std::int64_t by_v, const OctantGrid& grid,
             int axis, int guess, RowWindings& windings)
        : rows_({d, by_u}, n, by_u, by_v, grid.side() - 1, guess), grid_(grid), axis_(axis),
          windings_(windings) {}

    // The first component of the normal that is not 0 decides about points on the plane.
    static int nudge(const Plane& plane, int turn) {
        int tie = axis_x;
        while (plane.normal(tie).value() == 0) ++tie;
        return turn * plane.normal(tie).sign() < 0 ? 1 : 0;
    }

    OverPlane<PlaneStair> rows_; // the last points before the plane
    const OctantGrid& grid_;
    int axis_;
    RowWindings& windings_;
};

// Along z and y only from the first points along x, and along y only from the first along z.
void FaceInGrid::pass_all(RowWindings& windings, std::uint32_t* scratch) {
    const IndexRange z = between(axis_z);
    if (!z.empty()) pass(axis_x, between(axis_y), z, windings, scratch);
    const IndexRange first_x = common(between(axis_x), {0, 0});
    if (first_x.empty()) return;
    pass(axis_z, first_x, between(axis_y), windings, scratch);
    pass(axis_y, first_x, common(z, {0, 0}), windings, scratch);
}

void FaceInGrid::pass(int axis, const IndexRange& along_u, const IndexRange& along_v, RowWindings& windings,
                      std::uint32_t* scratch) {
    const IndexRange own = between(axis); // no point, or every one, comes before the face
    if (along_u.empty() || along_v.empty() || own.last < 0 || own.first == grid_.side()) return;
    if (plane().normal(axis).value() == 0) return; // seen as a line
    Passages passages(plane(), grid_, axis, clipped(own.first, 0, grid_.side() - 1), windings);
    is_convex() ? pass_convex(axis, along_u, along_v, passages, scratch)
                : pass_any(axis, along_u, along_v, passages, scratch);
}

// A row crosses one edge that rises and one that falls.
void FaceInGrid::pass_convex(int axis, const IndexRange& along_u, const IndexRange& along_v,
                             Passages& passages, std::uint32_t* scratch) const {
    // In each row, how many points are left of the edge that falls, and, from 32 on, of the one that rises;
    // each row that the face has crosses one of either.
    auto* const left = reinterpret_cast<std::uint8_t*>(scratch);
    const int u = u_of[axis];
    const int v = v_of[axis];
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        const SeenEdge edge(*a, *b, u, v);
        a = b;
        const IndexRange rows = common(grid_.points_between(v, edge.v, edge.end_v), along_v);
        if (rows.empty()) continue;
        LeftOfEdge left_of(edge, grid_, u, v, rows.first);
        std::uint8_t* const count = edge.rises ? left + 32 : left;
        for (int row = rows.first; row <= rows.last; ++row, left_of.next()) {
            count[row] = static_cast<std::uint8_t>(left_of.count());
        }
    }
    for (int row = along_v.first; row <= along_v.last; ++row) {
        const int falling = left[row];
        const int rising = left[32 + row];
        const IndexRange seen =
            falling < rising ? IndexRange{falling, rising - 1} : IndexRange{rising, falling - 1};
        passages.add(row, common(seen, along_u), falling < rising ? 1 : -1);
    }
}

// The same for a face of any rings, row by row.
void FaceInGrid::pass_any(int axis, const IndexRange& along_u, const IndexRange& along_v, Passages& passages,
                          std::uint32_t* scratch) const {
    // How often the rings wind around a point, less how often around the one before it.
    auto* const change = reinterpret_cast<std::int32_t*>(scratch);
    for (int row = along_v.first; row <= along_v.last; ++row) {
        for (int u = 0; u <= grid_.side(); ++u) change[u] = 0;
        for (std::uint32_t ring = first_ring_; ring != ring_end_; ++ring) add_ring(ring, axis, row, change);
        std::int32_t winding = 0;
        for (int u = 0; u <= along_u.last; ++u) {
            winding += change[u];
            if (winding != 0) passages.add(row, {u, u}, winding);
        }
    }
}

void FaceInGrid::add_ring(std::uint32_t r, int axis, int row, std::int32_t* change) const {
    const Ring ring = solid_.ring(r);
    const int u = u_of[axis];
    const int v = v_of[axis];
    const Point* a = &solid_.vertices[ring.corners[ring.count - 1]];
    for (std::uint32_t corner = 0; corner < ring.count; ++corner) {
        const Point* b = &solid_.vertices[ring.corners[corner]];
        const SeenEdge edge(*a, *b, u, v);
        a = b;
        const IndexRange rows = grid_.points_between(v, edge.v, edge.end_v);
        if (row < rows.first || row > rows.last) continue;
        const std::int32_t by = edge.rises ? 1 : -1;
        change[0] += by;
        change[LeftOfEdge(edge, grid_, u, v, row).count()] -= by;
    }
}

} // namespace osem
