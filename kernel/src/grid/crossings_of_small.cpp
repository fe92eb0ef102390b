// What a small triangle adds to the winding numbers of a grid's reference points.
#include "grid/edge_functions.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/points_behind.hpp"

namespace osem {

namespace {

// Rays along x: of four rows beside each other in each layer of a range, then of the next four. All of them
// are in the grid, so that those that the triangle does not have need not be left out.
template <class PointsBehind>
[[gnu::always_inline]] inline void add_along_x(const SmallTriangle& triangle, const SmallPlane& plane,
                                               const OctantGrid& grid, int y, int fours, const IndexRange& z,
                                               PointsBehind& behind, RowWindings& windings) {
    EdgeFunctions edges(triangle, axis_z, axis_y, -plane.normal[axis_x], grid.shift,
                        EdgeFunctions::Of::points);
    for (; fours > 0; --fours, y += 4) {
        RowWindings::FourRows rows(windings, grid.row(y, z.first), -plane.sign(axis_x));
        edges.begin_four();
        behind.begin_four();
        for (std::uint32_t left = z.count(); left != 0; --left) {
            Four outside = {}; // if its sign is set
            edges.outside(outside);
            behind.leave_out(outside);
            Four left_out = {};
            set_where_negative(left_out, outside);
            Four points = {};
            behind.see(points, left_out);
            rows.add(points);
            rows.next_layer();
            edges.next();
            behind.next();
        }
    }
}

// Rays along z, of the first points along x: of a range along y, four beside each other.
void add_along_z(const SmallTriangle& triangle, const SmallPlane& plane, const OctantGrid& grid,
                 const IndexRange& y, RowWindings& windings) {
    const std::int64_t turn = plane.sign(axis_z);
    EdgeFunctions edges(triangle, axis_x, axis_y, plane.normal[axis_z], grid.shift,
                        EdgeFunctions::Of::points);
    const std::int64_t along_x = turn * plane.normal[axis_x];
    const std::int64_t along_y = turn * plane.normal[axis_y];
    const std::int64_t along_z = turn * plane.normal[axis_z];
    const int nudge = moves_against(along_x, along_y, along_z) ? 1 : 0;
    FourStairs last(along_z, ~((turn * plane.value - nudge) >> grid.shift), -along_x, -along_y);
    for (int j = y.first; j <= y.last; j += 4) {
        Four seen = {};
        edges.see_four(1, seen);
        last.begin_four();
        for (int ray = 0; ray < 4 && j + ray <= y.last; ++ray) {
            const std::uint32_t before = last.values()[ray];
            const bool is_within = before < static_cast<std::uint32_t>(grid.side() - 1);
            if (seen[ray] == 0 || !is_within) continue;
            windings.change_first(grid.row(j + ray, static_cast<int>(before) + 1),
                                  -static_cast<std::int32_t>(turn));
        }
    }
}

// The last reference points before a triangle's ends along each axis, in the grid or beyond.
class LastPoints {
  public:
    // The corners are told from the first reference point.
    LastPoints(const SmallTriangle& triangle, const OctantGrid& grid)
        : low_(triangle.corners[0]), high_(triangle.corners[0]), most_(grid.side() - 1) {
        const FourSigned& b = triangle.corners[1];
        const FourSigned& c = triangle.corners[2];
        choose(low_, b < low_, b);
        choose(high_, b > high_, b);
        choose(low_, c < low_, c);
        choose(high_, c > high_, c);
        lengths_ = reinterpret_cast<Four>((high_ - low_) >> grid.shift);
        low_ = (low_ - 1) >> grid.shift;
        high_ = (high_ - 1) >> grid.shift;
    }

    // Whether it is small.
    bool are_near() const { return !any(lengths_ & ~(std::uint32_t{small_octants} - 1)); }
    // Whether it is between two points of the grid along an axis, or around the first one.
    bool are_in_grid(int axis) const { return high(axis) >= 0 && low(axis) < most_; }
    bool are_around_first(int axis) const { return low(axis) < 0 && high(axis) >= 0; }
    // How many points it is around.
    int around(int axis) const { return high(axis) - low(axis); }
    // The points of the grid between them.
    IndexRange between(int axis) const { return {greatest(low(axis) + 1, 0), least(high(axis), most_)}; }

  private:
    std::int32_t low(int axis) const { return low_[place_of_axis(axis)]; }
    std::int32_t high(int axis) const { return high_[place_of_axis(axis)]; }

    FourSigned low_;
    FourSigned high_;
    Four lengths_;
    int most_;
};

} // namespace

// Of a normal that is too large nothing is added.
bool FaceInGrid::pass_small(const Solid& solid, std::uint32_t face, const OctantGrid& grid,
                            RowWindings& windings, std::uint32_t* scratch) {
    if (!guesses_cost_much) return false; // so that parts without need have no code of it
    const std::uint32_t* const corners = solid.corners + solid.first_corner(solid.first_ring(face));
    const std::uint32_t* const end = solid.corners + solid.first_corner(solid.end_ring(face));
    if (end - corners != 3 || grid.levels < 2) return false;
    const SmallTriangle triangle = small_triangle(solid, corners, grid, FourSigned{}, grid.offset);
    const LastPoints last(triangle, grid);
    if (!last.are_near()) return false;
    const IndexRange y = last.between(axis_y);
    const IndexRange z = last.between(axis_z);
    if (!y.empty() && !z.empty() && last.are_in_grid(axis_x)) {
        const int fours = fours_of(y);
        const int first_y = first_of_fours(y, grid.side());
        const IndexRange x = last.between(axis_x);
        const int first_x = PointsBehindBySigns::first_of(x);
        const auto& [a, b, c] = triangle.corners;
        const FourSigned to_first = FourSigned{first_x, first_y, first_y, z.first} << grid.shift;
        const SmallTriangle from_first = {{a - to_first, b - to_first, c - to_first}};
        const SmallPlane plane(from_first);
        if (!plane.has_31_bits()) return false;
        const bool is_seen = plane.normal[axis_x] != 0;
        const bool by_signs = PointsBehindBySigns::suffice(plane, x, last.around(axis_x));
        const auto add = [&](auto&& behind) {
            add_along_x(from_first, plane, grid, first_y, fours, z, behind, windings);
        };
        if (is_seen && by_signs) add(PointsBehindBySigns(plane, grid, first_x));
        if (is_seen && !by_signs) add(PointsBehindByQuotients(plane, grid, first_x));
    }
    if (!last.are_around_first(axis_x)) return true;
    if (!y.empty() && last.are_in_grid(axis_z)) {
        const FourSigned first = {0, y.first, y.first, 0};
        const SmallTriangle from_first = small_triangle(solid, corners, grid, first, grid.offset);
        const SmallPlane plane(from_first);
        if (!plane.has_31_bits()) return false;
        if (plane.normal[axis_z] != 0) add_along_z(from_first, plane, grid, y, windings);
    }
    if (!last.are_around_first(axis_z)) return true;
    FaceInGrid(solid, face, grid).pass(axis_y, {0, 0}, {0, 0}, windings, scratch);
    return true;
}

} // namespace osem
