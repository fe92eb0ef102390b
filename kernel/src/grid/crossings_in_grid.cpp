// What a face adds to the winding numbers of a grid's reference points.
#include <type_traits>

#include "grid/face_in_grid.hpp"
#include "grid/fixed_quotients.hpp"
#include "grid/seen_edge.hpp"
#include "grid/stair.hpp"

namespace osem {

namespace {

// Rays in a row go through points along u, and those of the next row through points further along v. Rays
// along x there are from all points; rays along z only from the first ones along x, which so are one row.
constexpr int ray_u_of[3] = {axis_y, axis_x, axis_y};
constexpr int ray_v_of[3] = {axis_z, axis_z, axis_x};

// Whether u, v and the axis are, in that order; else they are left-handed.
constexpr bool is_right_handed(int axis) { return axis == axis_x; }

// Whether points are moved further along v than along u: along the lower axis they are moved furthest.
constexpr bool is_moved_up(int u, int v) { return u > v; }

// How many reference points of a row along u are on the left of an edge, row by row. Of points on the edge
// that is said as they are moved: by (e, e^2) to the right of it; by (e^2, e) up, which is to the left of an
// edge that runs to the right.
class LeftOfEdge {
  public:
    LeftOfEdge(const SeenEdge& edge, const OctantGrid& grid, int u, int v, int row)
        : last_(stair(edge, grid, grid.reference().at[u], grid.reference().at[v], row,
                      is_moved_up(u, v) && edge.run() > 0 ? 1 : 0)) {}

    int count() const { return last_.floor() + 1; } ///< clipped to the grid
    /// The same to be written down: small parts do that in bytes, for which it must be clipped.
    using Noted = std::conditional_t<guesses_cost_much, std::int32_t, std::uint8_t>;
    Noted noted_count() const { return static_cast<Noted>(last_.value() + 1); }
    void next() { last_.next(); }

  private:
    static EdgeStair stair(const SeenEdge& edge, const OctantGrid& grid, std::int32_t u, std::int32_t v,
                           int row, int nudge) {
        return {{edge.rise(), edge.run()},
                ~scaled(edge.at(u, v) - nudge, grid.shift) + row * edge.run(),
                grid.side() - 1,
                clipped((edge.u - u) >> grid.shift, -1, grid.side() - 1)};
    }

    EdgeStair last_; // the last of them
};

} // namespace

// Where a plane crosses rays along an axis: the last points before it are quotients. Points are before it, or
// behind it, as seen from where the normal, turned, points away from. Dividends are bounded as in
// PassedOctants.
struct FaceInGrid::RaysThroughPlane {
    std::int64_t d;
    std::int64_t n;
    std::int64_t by_u;
    std::int64_t by_v;

    RaysThroughPlane(const Plane& plane, const OctantGrid& grid, int axis)
        : RaysThroughPlane(plane, grid, axis, plane.normal(axis).value() < 0 ? -1 : 1) {}

  private:
    RaysThroughPlane(const Plane& plane, const OctantGrid& grid, int axis, int turn)
        : d(turn * plane.normal(axis).value()),
          n(~((turn * plane.at(grid.reference()).value() - nudge(plane, turn)) >> grid.shift)),
          by_u(-turn * plane.normal(ray_u_of[axis]).value()),
          by_v(-turn * plane.normal(ray_v_of[axis]).value()) {}

    // What is on the plane may come to be before it.
    static int nudge(const Plane& plane, int turn) {
        const auto along = [&](int axis) { return turn * plane.normal(axis).value(); };
        return moves_against(along(axis_x), along(axis_y), along(axis_z)) ? 1 : 0;
    }
};

// Rays along an axis that pass through the face, and what that adds to winding numbers.
class FaceInGrid::Passages {
  public:
    Passages(const RaysThroughPlane& rays, const OctantGrid& grid, int axis, int guess, RowWindings& windings)
        : rows_({rays.d, rays.by_u}, rays.n, rays.by_u, rays.by_v, grid.side() - 1, guess), grid_(grid),
          axis_(axis), windings_(windings) {}

    // Rays in a row along u, around which the face winds so often.
    void add(int v, const IndexRange& along_u, std::int32_t winding) {
        if (along_u.empty()) return;
        PlaneStair last = rows_.at(along_u.first, v);
        // Against the normal, into the solid.
        const std::int32_t number = is_right_handed(axis_) ? -winding : winding;
        if (axis_ == axis_x) {
            const auto row = static_cast<std::uint32_t>(grid_.row(along_u.first, v));
            return windings_.add_behind(row, row + along_u.count(), last, number);
        }
        for (int u = along_u.first; u <= along_u.last; ++u, last.next()) {
            if (!last.is_within()) continue;
            const int first = last.floor() + 1;
            windings_.change_first(axis_ == axis_y ? grid_.row(first, v) : grid_.row(u, first), number);
        }
    }

  private:
    OverPlane<PlaneStair> rows_; // the last points before the plane
    const OctantGrid& grid_;
    int axis_;
    RowWindings& windings_;
};

// The same along x, where rays are many, by quotients in fixed point.
class FaceInGrid::FixedPassages {
  public:
    FixedPassages(const FixedQuotients& quotients, const OctantGrid& grid, RowWindings& windings)
        : quotients_(quotients), grid_(grid), windings_(windings) {}

    void add(int v, const IndexRange& along_u, std::int32_t winding) {
        if (along_u.empty()) return;
        FixedQuotients::Stair last = quotients_.at(along_u.first, v);
        const auto row = static_cast<std::uint32_t>(grid_.row(along_u.first, v));
        windings_.add_behind(row, row + along_u.count(), last, is_right_handed(axis_x) ? -winding : winding);
    }

  private:
    const FixedQuotients& quotients_;
    const OctantGrid& grid_;
    RowWindings& windings_;
};

// Along z and y only from the first points along x, and along y only from the first along z.
void FaceInGrid::pass_all(RowWindings& windings, std::uint32_t* scratch) {
    const IndexRange z = between(axis_z);
    if (!z.empty()) pass(axis_x, between(axis_y), z, windings, scratch);
    const IndexRange first_x = common(between(axis_x), {0, 0});
    if (first_x.empty()) return;
    pass(axis_z, between(axis_y), first_x, windings, scratch);
    pass(axis_y, first_x, common(z, {0, 0}), windings, scratch);
}

void FaceInGrid::pass(int axis, const IndexRange& along_u, const IndexRange& along_v, RowWindings& windings,
                      std::uint32_t* scratch) {
    const IndexRange own = between(axis); // no point, or every one, comes before the face
    if (along_u.empty() || along_v.empty() || own.last < 0 || own.first == grid_.side()) return;
    if (plane().normal(axis).value() == 0) return; // seen as a line
    const RaysThroughPlane rays(plane(), grid_, axis);
    const auto pass_by = [&](auto passages) {
        is_convex() ? pass_convex(axis, along_u, along_v, passages, scratch)
                    : pass_any(axis, along_u, along_v, passages, scratch);
    };
    if constexpr (guesses_cost_much) {
        if (axis == axis_x) {
            const FixedQuotients quotients(rays.d, rays.n, rays.by_u, rays.by_v, grid_.side() - 1);
            if (quotients.fit() && quotients.come_near()) pass_by(FixedPassages(quotients, grid_, windings));
            if (quotients.fit()) return;
        }
    }
    pass_by(Passages(rays, grid_, axis, clipped(own.first, 0, grid_.side() - 1), windings));
}

// A row crosses one edge that rises and one that falls: which of them is on the left the normal tells.
template <class AnyPassages>
void FaceInGrid::pass_convex(int axis, const IndexRange& along_u, const IndexRange& along_v,
                             AnyPassages& passages, std::uint32_t* scratch) const {
    static_assert(last_grid_space(4) >= 2 * 16 && last_grid_space(5) >= 2 * 32, "room for both ends of rows");
    // In each row, how many points are left of the one, and of the other; each row that the face has crosses
    // one of either.
    auto* const first = reinterpret_cast<LeftOfEdge::Noted*>(scratch);
    const int end = grid_.side(); // from there on
    const int u = ray_u_of[axis];
    const int v = ray_v_of[axis];
    const bool turns_left = (plane_.normal(axis).value() > 0) == is_right_handed(axis);
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        const SeenEdge edge(*a, *b, u, v);
        a = b;
        const IndexRange rows = common(grid_.points_between(v, edge.v, edge.end_v), along_v);
        if (rows.empty()) continue;
        LeftOfEdge left_of(edge, grid_, u, v, rows.first);
        LeftOfEdge::Noted* const count = edge.rises == turns_left ? first + end : first;
        for (int row = rows.first; row <= rows.last; ++row, left_of.next()) {
            count[row] = left_of.noted_count();
        }
    }
    for (int row = along_v.first; row <= along_v.last; ++row) {
        passages.add(row, common({first[row], first[end + row] - 1}, along_u), turns_left ? 1 : -1);
    }
}

// How often rings wind around the points of a row along u: all in ranges, as edges cross it at a few places.
class FaceInGrid::RowOfRings {
  public:
    // A number a point, for the changes.
    RowOfRings(std::uint32_t* scratch, int side)
        : changes_(reinterpret_cast<std::int32_t*>(scratch)), side_(side) {}

    void begin() {
        first_ = 0;
        places_ = 0;
    }
    // Of an edge so many points are on the left.
    void cross(int count, bool rises) {
        if (count == 0) return;
        const std::int32_t by = rises ? 1 : -1;
        first_ += by;
        if (count == side_) return;
        const std::uint32_t place = std::uint32_t{1} << count;
        changes_[count] = ((places_ & place) != 0 ? changes_[count] : 0) - by;
        places_ |= place;
    }
    // Calls take(range, winding) for each range of points around which they wind.
    template <class Take>
    void each_range(Take take) const {
        std::int32_t winding = first_;
        int first = 0;
        for (std::uint32_t left = places_;; left &= left - 1) {
            const int place = left == 0 ? side_ : static_cast<int>(lowest_of(left));
            if (winding != 0) take(IndexRange{first, place - 1}, winding);
            if (left == 0) return;
            winding += changes_[place];
            first = place;
        }
    }

  private:
    std::int32_t* changes_;    // by how much it changes before a point
    std::uint32_t places_ = 0; // a bit for each point before which it does; of no other one there is a change
    std::int32_t first_ = 0;   // around the first point
    int side_;
};

// The same for a face of any rings, row by row.
template <class AnyPassages>
void FaceInGrid::pass_any(int axis, const IndexRange& along_u, const IndexRange& along_v,
                          AnyPassages& passages, std::uint32_t* scratch) const {
    static_assert(last_grid_space(4) >= 16 && last_grid_space(5) >= 32, "room for a row");
    RowOfRings rings(scratch, grid_.side());
    const std::uint32_t not_crossed = along_v.count() > 1 ? rings_not_crossed(axis, along_v) : 0;
    for (int row = along_v.first; row <= along_v.last; ++row) {
        rings.begin();
        std::uint32_t skipped = not_crossed;
        for (std::uint32_t ring = first_ring_; ring != ring_end_; ++ring, skipped >>= 1) {
            if ((skipped & 1U) == 0) cross_ring(ring, axis, row, rings);
        }
        rings.each_range([&](const IndexRange& range, std::int32_t winding) {
            passages.add(row, common(range, along_u), winding);
        });
    }
}

// Of the first rings, a bit for each that the rows of a range do not cross, or only before their first
// points.
std::uint32_t FaceInGrid::rings_not_crossed(int axis, const IndexRange& along_v) const {
    const int u = ray_u_of[axis];
    const int v = ray_v_of[axis];
    const Point first = grid_.reference();
    const std::int32_t low = first.at[v] + (along_v.first << grid_.shift);
    const std::int32_t high = first.at[v] + (along_v.last << grid_.shift);
    std::uint32_t not_crossed = 0;
    std::uint32_t place = 1; // no bit is left for those behind the first 32
    for (std::uint32_t r = first_ring_; r != ring_end_ && place != 0; ++r, place <<= 1) {
        const Ring ring = solid_.ring(r);
        const Extent extent(solid_, ring.corners, ring.corners + ring.count);
        const bool is_crossed =
            extent.high.at[u] > first.at[u] && extent.high.at[v] > low && extent.low.at[v] <= high;
        if (!is_crossed) not_crossed |= place;
    }
    return not_crossed;
}

// Points are moved up along v: what is level with them is below. And they are moved along u: an edge that
// begins and ends no further than the first one is left of all.
void FaceInGrid::cross_ring(std::uint32_t r, int axis, int row, RowOfRings& rings) const {
    const Ring ring = solid_.ring(r);
    const int u = ray_u_of[axis];
    const int v = ray_v_of[axis];
    const std::int32_t level = grid_.reference().at[v] + (row << grid_.shift);
    const std::int32_t first = grid_.reference().at[u];
    const std::int32_t last = first + ((grid_.side() - 1) << grid_.shift);
    const Point* a = &solid_.vertices[ring.corners[ring.count - 1]];
    bool begins_below = a->at[v] <= level;
    for (std::uint32_t corner = 0; corner < ring.count; ++corner) {
        const Point* b = &solid_.vertices[ring.corners[corner]];
        const bool ends_below = b->at[v] <= level;
        if (begins_below != ends_below && (a->at[u] > first || b->at[u] > first)) {
            const bool is_beyond = a->at[u] > last && b->at[u] > last;
            rings.cross(is_beyond ? grid_.side() : LeftOfEdge({*a, *b, u, v}, grid_, u, v, row).count(),
                        begins_below);
        }
        a = b;
        begins_below = ends_below;
    }
}

} // namespace osem
