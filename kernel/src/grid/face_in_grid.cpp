#include "grid/face_in_grid.hpp"

#include "classify/box.hpp"
#include "grid/count_below.hpp"
#include "grid/seen_edge.hpp"

namespace osem {

FaceInGrid::FaceInGrid(const Solid& solid, std::uint32_t face, const OctantGrid& grid)
    : solid_(solid), grid_(grid), face_(face), first_ring_(solid.first_ring(face)),
      ring_end_(solid.end_ring(face)), corners_(solid.corners + solid.first_corner(first_ring_)),
      end_(solid.corners + solid.first_corner(ring_end_)), low_(solid.vertices[*corners_]), high_(low_) {
    for (const std::uint32_t* corner = corners_ + 1; corner != end_; ++corner) {
        const Point& p = solid.vertices[*corner];
        for (int axis = 0; axis < 3; ++axis) {
            low_.at[axis] = low_.at[axis] < p.at[axis] ? low_.at[axis] : p.at[axis];
            high_.at[axis] = high_.at[axis] > p.at[axis] ? high_.at[axis] : p.at[axis];
        }
    }
}

// Triangles are; and so are quadrangles that turn the same way at every corner: exterior angles below 180
// degrees add up to 360. (Five could add up to 720.) Seen along an axis that the normal is not across, turns
// keep their sign.
bool FaceInGrid::is_convex(const Plane& plane) const {
    if (end_ - corners_ > 4) return false; // as those of two rings are
    if (end_ - corners_ == 3) return true;
    int axis = 0;
    while (axis < 2 && plane.normal(axis).value() == 0) ++axis;
    const auto along = [&](int from, int seen) -> std::int64_t {
        const Point& a = solid_.vertices[corners_[from & 3]];
        const Point& b = solid_.vertices[corners_[(from + 1) & 3]];
        return b.at[seen] - a.at[seen];
    };
    int turns = 0;
    for (int i = 0; i < 4; ++i) {
        const std::int64_t turn =
            along(i, u_of[axis]) * along(i + 1, v_of[axis]) - along(i, v_of[axis]) * along(i + 1, u_of[axis]);
        turns += turn > 0 ? 1 : turn < 0 ? -1 : 0;
    }
    return turns == 4 || turns == -4;
}

// Whether the face lies between the ends of the only interval in a range along an axis.
bool FaceInGrid::is_within(int axis, const IndexRange& range) const {
    const std::int32_t low = grid_.corner.at[axis] + (range.first << grid_.shift);
    return range.first == range.last && low_.at[axis] >= low && high_.at[axis] <= low + grid_.length();
}

// Squares of the grid as seen along an axis, those that a face is seen to meet: a range along u for each slab
// along v. Its ends are kept within one square beside the grid.
class FaceInGrid::Slabs {
  public:
    // Memory: 64 bytes.
    explicit Slabs(std::int8_t* bytes) : first_(bytes), last_(bytes + 32) {}

    void fill(const IndexRange& slabs, const IndexRange& range) {
        for (int slab = slabs.first; slab <= slabs.last; ++slab) {
            first_[slab] = static_cast<std::int8_t>(range.first);
            last_[slab] = static_cast<std::int8_t>(range.last);
        }
    }
    // What the open slab holds reaches into a square from the right, or from the left.
    void reach(int slab, int square, bool left) {
        std::int8_t& end = left ? first_[slab] : last_[slab];
        if (left ? square < end : square > end) end = static_cast<std::int8_t>(square);
    }
    IndexRange at(int slab) const { return {first_[slab], last_[slab]}; }

  private:
    std::int8_t* first_;
    std::int8_t* last_;
};

// A convex face has inner points in an open slab wherever it has any; what it is seen to meet of a slab is in
// a row, from where its left edges in the slab reach least to where its right ones reach most. Seen as a line
// its edges are both.
void FaceInGrid::see(int u, int v, const Plane& plane, const IndexRange (&range)[3], Slabs& slabs) const {
    if (is_within(u, range[u]) || is_within(v, range[v])) return slabs.fill(range[v], range[u]);
    slabs.fill(range[v], {grid_.side() + 1, -1});
    const int axis = axis_x + axis_y + axis_z - u - v;
    const int turn = plane.normal(axis).sign() * (axis == axis_y ? -1 : 1); // (x, z) is left-handed
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        const SeenEdge edge(*a, *b, u, v);
        a = b;
        const bool is_right = edge.rises == (turn > 0);
        if (turn == 0 || !is_right) add_edge(u, v, edge, true, slabs);
        if (turn == 0 || is_right) add_edge(u, v, edge, false, slabs);
    }
}

// In each slab a left edge reaches least where the slab's lower line cuts it, or its upper line, as the edge
// leans; or at its end. What is on a line from the left does not reach into the square behind it.
void FaceInGrid::add_edge(int u, int v, const SeenEdge& edge, bool left, Slabs& slabs) const {
    const int side = grid_.side();
    const std::int32_t first_u = grid_.corner.at[u];
    const std::int32_t first_v = grid_.corner.at[v];
    const std::int32_t low = (edge.v - first_v) >> grid_.shift; // the slabs of its ends
    const std::int32_t high = (edge.end_v - 1 - first_v) >> grid_.shift;
    int slab = clipped(low, 0, side);
    int last = clipped(high, -1, side - 1);
    if (slab > last) return;
    const int line_of_square = left ? 0 : 1;
    const int low_square = clipped((edge.u - first_u - line_of_square) >> grid_.shift, -1, side);
    const int high_square = clipped((edge.end_u - first_u - line_of_square) >> grid_.shift, -1, side);
    if (low_square == high_square) { // it is in no other
        for (; slab <= last; ++slab) slabs.reach(slab, low_square, left);
        return;
    }
    const int guess = low == slab ? low_square : (low_square + high_square) / 2;
    const bool at_lower = left == (edge.run() >= 0);
    if (at_lower && low == slab) slabs.reach(slab++, low_square, left);
    if (!at_lower && high == last) slabs.reach(last--, high_square, left);
    if (slab > last) return;
    const std::int64_t value = edge.at(first_u, first_v);
    // Whether a left edge may cut the slabs' lines where squares begin: the rest that the values leave out.
    const bool may_meet = left && (value & (grid_.length() - 1)) == 0;
    const int line = at_lower ? slab : slab + 1;
    CountBelow<std::int32_t> passed(scaled(value, grid_.shift) - line * edge.run(), edge.rise(), side + 1,
                                    guess + 1);
    for (;; passed.raise(-edge.run())) {
        const bool meets = may_meet && passed.next_value() == 0;
        slabs.reach(slab, meets ? passed.count() : passed.count() - 1, left);
        if (slab++ == last) return;
    }
}

namespace {

// The octants of the rows along x through which a plane passes, row by row. The normal is turned so that it
// does not point down: then those that reach below the plane are the row's first ones, and those that reach
// above it the last ones. Values are at most 3 * (2^61 + 2^41), divided by the octants' side or not; steps
// are 2^41 at most, and fewer than 100 are taken.
class PassedOctants {
  public:
    using Count = CountBelow<std::int64_t>;

    PassedOctants(const Plane& plane, const OctantGrid& grid, const IndexRange (&range)[3])
        : PassedOctants(plane, grid, range, plane.normal(0).value() < 0 ? -1 : 1) {}

    void move_to(int j, int k) {
        const std::int64_t change = (j - j_) * step_y_ + (k - k_) * step_z_;
        not_above_.raise(change);
        below_.raise(change);
        j_ = j;
        k_ = k;
    }
    const Count& not_above() const { return not_above_; } // how many of the row do not reach above the plane
    const Count& below() const { return below_; }         // how many reach below it
    std::int64_t step_along_y() const { return step_y_; }

  private:
    PassedOctants(const Plane& plane, const OctantGrid& grid, const IndexRange (&range)[3], int turn)
        : PassedOctants(turn * plane.at(grid.corner).value(), turn * plane.normal(0).value(),
                        turn * plane.normal(1).value(), turn * plane.normal(2).value(), grid, range) {}

    // From the value at the grid's corner: of a row's first octant the values are least where all steps that
    // fall lead, greatest where those lead that do not; these are rounded down from just below.
    PassedOctants(std::int64_t at_corner, std::int64_t step_x, std::int64_t step_y, std::int64_t step_z,
                  const OctantGrid& grid, const IndexRange (&range)[3])
        : step_y_(step_y), step_z_(step_z), j_(range[1].first), k_(range[2].first),
          not_above_(~(-at_corner >> grid.shift) + step_x + raising(step_y, j_) + raising(step_z, k_), step_x,
                     grid.side(), range[0].first),
          below_((at_corner >> grid.shift) + falling(step_y, j_) + falling(step_z, k_), step_x, grid.side(),
                 range[0].first) {}

    // To row `row`, and to the side of it where the value is greater, or less.
    static std::int64_t raising(std::int64_t step, int row) { return step * (step > 0 ? row + 1 : row); }
    static std::int64_t falling(std::int64_t step, int row) { return step * (step < 0 ? row + 1 : row); }

    std::int64_t step_y_;
    std::int64_t step_z_;
    int j_;
    int k_;
    Count not_above_;
    Count below_;
};

// Those of one row; apart, so that it takes no stack while octants are classified.
[[gnu::noinline]] IndexRange passed_in_row(const Plane& plane, const OctantGrid& grid, const IndexRange& x,
                                           int j, int k) {
    const IndexRange range[3] = {x, {j, j}, {k, k}};
    const PassedOctants passed(plane, grid, range);
    return common(x, {passed.not_above().count(), passed.below().count() - 1});
}

} // namespace

void FaceInGrid::mark(std::uint32_t* rows, std::uint32_t* scratch) const {
    mark_in({overlapped(0), overlapped(1), overlapped(2)}, rows, scratch);
}

void FaceInGrid::mark_in(const IndexRange (&range)[3], std::uint32_t* rows, std::uint32_t* scratch) const {
    if (range[0].empty() || range[1].empty() || range[2].empty()) return;
    if (meets_all_of(range)) return mark_all(range, rows);
    const Plane plane(solid_, corners_, end_);
    if (is_convex(plane)) {
        mark_convex(plane, range, rows, scratch);
    } else {
        classify_octants(plane, range, rows);
    }
}

int FaceInGrid::axes_within(const IndexRange (&range)[3]) const {
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) axes += is_within(axis, range[axis]) ? 1 : 0;
    return axes;
}

// The separating axes of a box and a convex face: the box's own are the ranges; those across an edge are the
// squares' as seen along each axis; and the plane. A face between the ends of one interval along an axis
// meets what it is seen to meet along that axis; and between two such pairs it meets all in its box.
void FaceInGrid::mark_convex(const Plane& plane, const IndexRange (&range)[3], std::uint32_t* rows,
                             std::uint32_t* scratch) const {
    auto* const tables = reinterpret_cast<std::int8_t*>(scratch);
    Slabs x_by_y(tables);
    Slabs x_by_z(tables + 64);
    Slabs y_by_z(tables + 128);
    see(axis_x, axis_y, plane, range, x_by_y);
    see(axis_x, axis_z, plane, range, x_by_z);
    see(axis_y, axis_z, plane, range, y_by_z);
    const bool is_cut = !plane.is_null() && axes_within(range) == 0;
    PassedOctants passed(plane, grid_, range);
    for (int k = range[2].first; k <= range[2].last; ++k) {
        const IndexRange x = common(x_by_z.at(k), range[0]);
        const IndexRange y = common(y_by_z.at(k), range[1]);
        if (y.empty()) continue;
        passed.move_to(y.first, k);
        PassedOctants::Count begin = passed.not_above();
        PassedOctants::Count end = passed.below();
        for (int j = y.first; j <= y.last; ++j) {
            IndexRange met = common(x, x_by_y.at(j));
            if (is_cut) {
                met = common(met, {begin.count(), end.count() - 1});
                begin.raise(passed.step_along_y());
                end.raise(passed.step_along_y());
            }
            if (!met.empty()) rows[grid_.row(j, k)] |= met.bits();
        }
    }
}

void FaceInGrid::mark_all(const IndexRange (&range)[3], std::uint32_t* rows) const {
    const std::uint32_t bits = range[0].bits();
    for (int k = range[2].first; k <= range[2].last; ++k) {
        for (int j = range[1].first; j <= range[1].last; ++j) rows[grid_.row(j, k)] |= bits;
    }
}

// The same for a face of any rings, octant by octant.
void FaceInGrid::classify_octants(const Plane& plane, const IndexRange (&range)[3],
                                  std::uint32_t* rows) const {
    for (int k = range[2].first; k <= range[2].last; ++k) {
        for (int j = range[1].first; j <= range[1].last; ++j) {
            const IndexRange x = plane.is_null() ? range[0] : passed_in_row(plane, grid_, range[0], j, k);
            for (int i = x.first; i <= x.last; ++i) {
                Box box = {grid_.at(i, j, k), {}};
                for (int axis = 0; axis < 3; ++axis) box.hi.at[axis] = box.lo.at[axis] + grid_.length();
                if (classify_box(solid_, face_, box).meets) rows[grid_.row(j, k)] |= std::uint32_t{1} << i;
            }
        }
    }
}

std::uint64_t FaceInGrid::octants_met(std::uint32_t* scratch) const {
    const IndexRange range[3] = {overlapped(0), overlapped(1), overlapped(2)};
    if (is_one(range) && meets_all_of(range)) { // as most faces do
        return std::uint64_t{1} << (range[0].first + 4 * range[1].first + 16 * range[2].first);
    }
    for (int row = 0; row < grid_.rows(); ++row) scratch[row] = 0;
    mark_in(range, scratch, scratch + 16);
    return as_mask(scratch, 0, grid_.levels);
}

} // namespace osem
