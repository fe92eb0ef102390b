// What a face adds to the winding numbers of a grid's reference points.
#include "grid/count_below.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/seen_edge.hpp"

namespace osem {

namespace {

// The squares on the left of an edge that are seen in a row along u: how many reference points lie there, row
// by row. Moved by (e, e^2) the points are to the right of an edge on which they would be.
class LeftOfEdge {
  public:
    LeftOfEdge(const SeenEdge& edge, const OctantGrid& grid, int u, int v)
        : run_(edge.run()), rise_(edge.rise()), side_(grid.side()) {
        const Point first = grid.reference();
        value_ = scaled(edge.at(first.at[u], first.at[v]), grid.shift);
        guess_ = clipped((edge.u - first.at[u]) >> grid.shift, 0, side_);
    }
    CountBelow<std::int32_t> row(int row) const { return {value_ - row * run_, rise_, side_, guess_}; }
    std::int32_t change() const { return -run_; }

  private:
    std::int32_t run_;
    std::int32_t rise_;
    int side_;
    std::int32_t value_;
    int guess_;
};

// The reference points on rays along an axis that lie before a face's plane, as seen from where the normal,
// turned, points away from. Values are bounded as in PassedOctants.
PlaneOfRows points_before(const Plane& plane, const OctantGrid& grid, int axis) {
    const int turn = plane.normal(axis).value() < 0 ? -1 : 1;
    int tie = axis_x; // the first component of the normal that is not 0: it decides on the plane
    while (plane.normal(tie).value() == 0) ++tie;
    const int nudge = turn * plane.normal(tie).sign() < 0 ? 1 : 0;
    return {(turn * plane.at(grid.reference()).value() - nudge) >> grid.shift,
            turn * plane.normal(axis).value(), turn * plane.normal(u_of[axis]).value(),
            turn * plane.normal(v_of[axis]).value()};
}

} // namespace

// Where rays along an axis pass through the face, and what that adds to winding numbers.
class FaceInGrid::Passages {
  public:
    Passages(const Plane& plane, const OctantGrid& grid, int axis, const IndexRange (&range)[3],
             RowWindings& windings)
        : before_(points_before(plane, grid, axis), grid.side(), range[0].first, range[1].first,
                  range[2].first),
          grid_(grid), axis_(axis), windings_(windings) {}

    // Rays in a row along u, around which the face winds so often.
    void add(int v, const IndexRange& along_u, std::int32_t winding) {
        if (along_u.empty()) return;
        auto before = before_.at(along_u.first, v);
        // Against the normal, into the solid. (x, z) is left-handed as seen along y.
        const std::int32_t number = axis_ == axis_y ? winding : -winding;
        const std::int64_t step = before_.step_u();
        const int side = grid_.side();
        for (int u = along_u.first; u <= along_u.last; ++u) {
            const int count = before.count();
            if (count > 0 && count < side) add_behind(u, v, count, number);
            before.raise(step);
        }
    }

  private:
    void add_behind(int u, int v, int first, std::int32_t number) {
        if (axis_ == axis_x) {
            windings_.add(static_cast<std::uint32_t>(grid_.row(u, v)), first, number);
        } else {
            windings_.change_first(axis_ == axis_y ? grid_.row(first, v) : grid_.row(0, first), number);
        }
    }

    CountOverPlane before_;
    const OctantGrid& grid_;
    int axis_;
    RowWindings& windings_;
};

// Along y and z only from the first points along x, and along z only from the first along y.
void FaceInGrid::add_crossings(RowWindings& windings, std::uint32_t* scratch) const {
    const IndexRange z = between(axis_z);
    if (!z.empty()) pass(axis_x, between(axis_y), z, windings, scratch);
    const IndexRange first_x = common(between(axis_x), {0, 0});
    if (first_x.empty()) return;
    pass(axis_y, first_x, z, windings, scratch);
    pass(axis_z, first_x, common(between(axis_y), {0, 0}), windings, scratch);
}

void FaceInGrid::pass(int axis, const IndexRange& along_u, const IndexRange& along_v, RowWindings& windings,
                      std::uint32_t* scratch) const {
    const IndexRange own = between(axis); // no point, or every one, comes before the face
    if (along_u.empty() || along_v.empty() || own.last < 0 || own.first == grid_.side()) return;
    const Plane plane(solid_, corners_, end_);
    if (plane.normal(axis).value() == 0) return; // seen as a line
    Passages passages(plane, grid_, axis, {own, along_u, along_v}, windings);
    is_convex(plane) ? pass_convex(axis, along_u, along_v, passages, scratch)
                     : pass_any(axis, along_u, along_v, passages, scratch);
}

// A row crosses one edge that rises and one that falls.
void FaceInGrid::pass_convex(int axis, const IndexRange& along_u, const IndexRange& along_v,
                             Passages& passages, std::uint32_t* scratch) const {
    // In each row, how many points are left of the edge that falls, and, from 32 on, of the one that rises.
    auto* const left = reinterpret_cast<std::uint8_t*>(scratch);
    for (int row = 0; row < 64; ++row) left[row] = 0;
    const int u = u_of[axis];
    const int v = v_of[axis];
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        const SeenEdge edge(*a, *b, u, v);
        a = b;
        const IndexRange rows = common(grid_.points_between(v, edge.v, edge.end_v), along_v);
        if (rows.empty()) continue;
        const LeftOfEdge left_of(edge, grid_, u, v);
        CountBelow<std::int32_t> count = left_of.row(rows.first);
        for (int row = rows.first; row <= rows.last; ++row) {
            left[edge.rises ? 32 + row : row] = static_cast<std::uint8_t>(count.count());
            count.raise(left_of.change());
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
        change[LeftOfEdge(edge, grid_, u, v).row(row).count()] -= by;
    }
}

} // namespace osem
