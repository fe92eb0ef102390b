// What a small triangle adds to the winding numbers of a grid's reference points.
#include "grid/edge_functions.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/stair.hpp"

namespace osem {

namespace {

// The last points before the plane on rays along an axis, along which it is not seen as a line; as Passages
// has them, for a normal of 31 bits.
[[gnu::always_inline]] inline FourStairs last_before(const SmallPlane& plane, int axis, int u, int v,
                                                     int shift) {
    const std::int64_t turn = plane.sign(axis);
    int tie = axis_x; // the first component that is not 0 decides about points on the plane
    while (plane.normal[tie] == 0) ++tie;
    const std::int64_t nudge = turn * plane.normal[tie] < 0 ? 1 : 0;
    return {turn * plane.normal[axis], ~((turn * plane.value - nudge) >> shift), -turn * plane.normal[u],
            -turn * plane.normal[v]};
}

// Rays along x: of four rows beside each other in each layer of a range, then of the next four. All of them
// are in the grid, so that those that the triangle does not have need not be left out. Where it is seen its
// plane is where it is, so quotients modulo 2^32 are the numbers themselves; elsewhere they do not matter.
void add_along_x(const SmallTriangle& triangle, const SmallPlane& plane, const OctantGrid& grid, int y,
                 int fours, const IndexRange& z, RowWindings& windings) {
    const int turn = plane.sign(axis_x);
    EdgeFunctions edges(triangle, axis_z, axis_y, -turn, grid.shift, EdgeFunctions::Of::points);
    FourStairs last = last_before(plane, axis_x, axis_z, axis_y, grid.shift);
    const auto most = static_cast<std::uint32_t>(grid.side() - 1);
    for (; fours > 0; --fours, y += 4) {
        RowWindings::FourRows rows(windings, grid.row(y, z.first), -turn);
        edges.begin_four();
        last.begin_four();
        for (std::uint32_t left = z.count(); left != 0; --left) {
            Four outside = {}; // if its sign is set
            edges.outside(outside);
            outside |= last.values() | (most - 1 - last.values());
            Four not_there = {};
            set_where_negative(not_there, outside);
            rows.add_behind(not_there | last.values());
            rows.next_layer();
            edges.next();
            last.next();
        }
    }
}

// Rays along z, of the first points along x: of a range along y, four beside each other.
void add_along_z(const SmallTriangle& triangle, const SmallPlane& plane, const OctantGrid& grid,
                 const IndexRange& y, RowWindings& windings) {
    const int turn = plane.sign(axis_z);
    EdgeFunctions edges(triangle, axis_x, axis_y, turn, grid.shift, EdgeFunctions::Of::points);
    FourStairs last = last_before(plane, axis_z, axis_x, axis_y, grid.shift);
    for (int j = y.first; j <= y.last; j += 4) {
        Four seen = {};
        edges.see_four(1, seen);
        last.begin_four();
        for (int ray = 0; ray < 4 && j + ray <= y.last; ++ray) {
            const std::uint32_t before = last.values()[ray];
            const bool is_within = before < static_cast<std::uint32_t>(grid.side() - 1);
            if (seen[ray] == 0 || !is_within) continue;
            windings.change_first(grid.row(j + ray, static_cast<int>(before) + 1), -turn);
        }
    }
}

} // namespace

// As pass_all; the last reference points before its ends are known. False, and nothing added, if its plane's
// numbers are too large.
bool FaceInGrid::pass_small(const Index& low, const Index& high, RowWindings& windings,
                            std::uint32_t* scratch) {
    if (!guesses_cost_much) return false; // so that parts without need have no code of it
    const int last = grid_.side() - 1;
    const auto in_grid = [&](int axis) {
        return IndexRange{greatest(low.at[axis] + 1, 0), least(high.at[axis], last)};
    };
    const auto is_crossed = [&](int axis) { return high.at[axis] >= 0 && low.at[axis] < last; };
    const IndexRange y = in_grid(axis_y);
    const IndexRange z = in_grid(axis_z);
    const int fours = fours_of(y);
    const int first_y = first_of_fours(y, grid_.side());
    const SmallTriangle triangle = small_triangle(grid_.point(0, first_y, z.first));
    const SmallPlane plane(triangle);
    if (!plane.has_31_bits()) return false;
    if (fours > 0 && !z.empty() && is_crossed(axis_x) && plane.normal[axis_x] != 0) {
        add_along_x(triangle, plane, grid_, first_y, fours, z, windings);
    }
    if (low.at[axis_x] >= 0 || high.at[axis_x] < 0) return true;
    if (!y.empty() && is_crossed(axis_z) && plane.normal[axis_z] != 0) {
        const SmallTriangle from_first = small_triangle(grid_.point(0, y.first, 0));
        add_along_z(from_first, SmallPlane(from_first), grid_, y, windings);
    }
    pass(axis_y, {0, 0}, common(z, {0, 0}), windings, scratch);
    return true;
}

} // namespace osem
