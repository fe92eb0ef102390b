// What a small triangle adds to the winding numbers of a grid's reference points.
#include "grid/edge_functions.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/points_behind.hpp"

namespace osem {

namespace {

// The last reference points before a triangle's ends along each axis, in the grid or beyond; and those of the
// grid that are looked at for rays along x, which are all between its ends and some beside them.
class PointsAround {
  public:
    // The triangle is told from the first reference point.
    PointsAround(const SmallTriangle& triangle, const OctantGrid& grid)
        : low_(FourSigned{}), high_(FourSigned{}), most_(grid.side() - 1) {
        lower(low_, triangle.to_second);
        raise(high_, triangle.to_second);
        lower(low_, triangle.to_third);
        raise(high_, triangle.to_third);
        lengths_ = reinterpret_cast<Four>((high_ - low_) >> grid.shift);
        low_ = (triangle.corner + low_ - 1) >> grid.shift;
        high_ = (triangle.corner + high_ - 1) >> grid.shift;
        find_first();
    }

    // Whether it is small.
    bool are_near() const { return !any(lengths_ & ~(std::uint32_t{small_octants} - 1)); }
    // Whether rays along x of the grid are between its ends, and not all of it is beside the grid's points.
    bool have_rays_along_x() const { return !any_negative(reaches_); }
    // If so: the first point that is looked at along each axis; how many there are between its ends, and how
    // many fours of rows.
    const FourSigned& first() const { return first_; }
    int first(int axis) const { return first_[place_of_axis(axis)]; }
    int count(int axis) const { return behind_first_[place_of_axis(axis)] + 1; }
    int fours_along_y() const { return (behind_first_[place_of_axis(axis_y)] >> 2) + 1; }

    // Whether it is between two points of the grid along an axis, or around the first one.
    bool are_in_grid(int axis) const { return high(axis) >= 0 && low(axis) < most_; }
    bool are_around_first(int axis) const { return low(axis) < 0 && high(axis) >= 0; }
    // How many points it is around.
    int around(int axis) const { return high(axis) - low(axis); }
    // The points of the grid between its ends.
    IndexRange between(int axis) const { return {greatest(low(axis) + 1, 0), least(high(axis), most_)}; }

  private:
    std::int32_t low(int axis) const { return low_[place_of_axis(axis)]; }
    std::int32_t high(int axis) const { return high_[place_of_axis(axis)]; }

    // Along all axes at once, as what is done next waits for it.
    [[gnu::always_inline]] void find_first() {
        const FourSigned all = FourSigned{} + most_;
        first_ = low_ + 1;
        first_ &= ~(first_ >> 31);
        FourSigned last = high_;
        lower(last, all);
        behind_first_ = last - first_;
        const FourSigned rows = behind_first_ & FourSigned{0, -1, -1, -1};
        reaches_ = rows | high_ | (all - 1 - low_);
        // Along x as many as signs are asked of, and along y full fours of rows, as first_of_fours has them:
        // so some may begin before.
        lower(first_, all - (rows | FourSigned{PointsBehindBySigns::points - 1, 3, 3, 0}));
    }

    FourSigned low_;
    FourSigned high_;
    FourSigned first_;
    FourSigned behind_first_; // how many more there are
    FourSigned reaches_;      // below 0 where it does not; what is beside the grid is too far for signs
    Four lengths_;
    int most_;
};

// Rays along x: of four rows beside each other in each layer of a range, then of the next four. All of them
// are in the grid, so those beside the triangle may be added to as well: of each nothing is. It is told from
// the first point looked at, and its plane as well.
template <class PointsBehind>
[[gnu::always_inline]] inline void add_along_x(const SmallTriangle& triangle, const SmallPlane& plane,
                                               const OctantGrid& grid, const PointsAround& points,
                                               PointsBehind&& behind, RowWindings& windings) {
    // (y, z) is right-handed.
    EdgeFunctions<axis_z, axis_y> edges(triangle, -plane.normal[axis_x], grid.shift, SeenPlaces::points,
                                        behind.function());
    int row = grid.row(points.first(axis_y), points.first(axis_z));
    for (int fours = points.fours_along_y();; row += 4, edges.next_four()) {
        RowWindings::FourRows rows(windings, row, -plane.sign(axis_x));
        behind.begin_four();
        for (int layers = points.count(axis_z); layers != 0; --layers) {
            Four outside = {}; // if its sign is set
            edges.outside(outside);
            behind.leave_out(outside, edges.fourth());
            Four left_out = {};
            set_where_negative(left_out, outside);
            Four are_behind = {};
            behind.see(are_behind, left_out, edges.fourth());
            rows.add(are_behind);
            rows.next_layer();
            edges.next();
            behind.next();
        }
        if (--fours == 0) return;
    }
}

// Rays along z, of the first points along x: of a range along y, four beside each other.
void add_along_z(const SmallTriangle& triangle, const SmallPlane& plane, const OctantGrid& grid,
                 const IndexRange& y, RowWindings& windings) {
    const std::int64_t turn = plane.sign(axis_z);
    EdgeFunctions<axis_x, axis_y> edges(triangle, plane.normal[axis_z], grid.shift, SeenPlaces::points);
    const std::int64_t along_x = turn * plane.normal[axis_x];
    const std::int64_t along_y = turn * plane.normal[axis_y];
    const std::int64_t along_z = turn * plane.normal[axis_z];
    const int nudge = moves_against(along_x, along_y, along_z) ? 1 : 0;
    FourStairs last(along_z, ~((turn * plane.value - nudge) >> grid.shift), -along_x, -along_y);
    for (int j = y.first; j <= y.last; j += 4, edges.next_four()) {
        Four seen = {};
        edges.see(1, seen);
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

} // namespace

// Of a normal that is too large nothing is added.
bool FaceInGrid::pass_small(const Solid& solid, std::uint32_t face, const OctantGrid& grid,
                            RowWindings& windings, std::uint32_t* scratch) {
    if (!guesses_cost_much) return false; // so that parts without need have no code of it
    const std::uint32_t* const corners = solid.corners + solid.first_corner(solid.first_ring(face));
    const std::uint32_t* const end = solid.corners + solid.first_corner(solid.end_ring(face));
    if (end - corners != 3 || grid.levels < 2) return false;
    const SmallTriangle triangle = small_triangle(solid, corners, grid, FourSigned{}, grid.offset);
    const PointsAround points(triangle, grid);
    if (!points.are_near()) return false;
    if (points.have_rays_along_x()) {
        SmallTriangle from_first = triangle;
        from_first.corner -= points.first() << grid.shift;
        const SmallPlane plane(from_first);
        if (!plane.has_31_bits(grid.shift)) return false;
        const auto add = [&](auto&& behind) {
            add_along_x(from_first, plane, grid, points, behind, windings);
        };
        const int first_x = points.first(axis_x);
        const bool is_seen = plane.normal[axis_x] != 0;
        const bool by_signs =
            PointsBehindBySigns::suffice(plane, points.count(axis_x), points.around(axis_x));
        if (is_seen && by_signs) add(PointsBehindBySigns(plane, grid, first_x));
        if (is_seen && !by_signs) add(PointsBehindByQuotients(plane, grid, first_x));
    }
    if (!points.are_around_first(axis_x)) return true;
    const IndexRange y = points.between(axis_y);
    if (!y.empty() && points.are_in_grid(axis_z)) {
        SmallTriangle from_first = triangle;
        from_first.corner -= FourSigned{0, y.first, y.first, 0} << grid.shift;
        const SmallPlane plane(from_first);
        if (!plane.has_31_bits(grid.shift)) return false;
        if (plane.normal[axis_z] != 0) add_along_z(from_first, plane, grid, y, windings);
    }
    if (!points.are_around_first(axis_z)) return true;
    FaceInGrid(solid, face, grid).pass(axis_y, {0, 0}, {0, 0}, windings, scratch);
    return true;
}

} // namespace osem
