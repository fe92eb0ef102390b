#include "grid/face_in_grid.hpp"

#include "grid/passed_octants.hpp"
#include "grid/seen_edge.hpp"
#include "grid/stair.hpp"

namespace osem {

// Triangles are; and so are quadrangles that turn the same way at every corner: exterior angles below 180
// degrees add up to 360. (Five could add up to 720.) Seen along an axis that the normal is not across, turns
// keep their sign.
bool FaceInGrid::is_convex() {
    if (end_ - corners_ > 4) return false; // as those of two rings are
    if (end_ - corners_ == 3) return true;
    int axis = 0;
    while (axis < 2 && plane().normal(axis).value() == 0) ++axis;
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

FaceInGrid::Ranges FaceInGrid::ranges() const {
    Ranges range = {};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t first = first_octant(axis);
        const std::int32_t last = last_octant(axis);
        range.along[axis] = {clipped(first, 0, grid_.side()), clipped(last, -1, grid_.side() - 1)};
        range.within |= (first == last ? 1U : 0U) << axis;
    }
    return range;
}

// Squares of the grid as seen along an axis, those that a face is seen to meet: a range along u for each slab
// along v. Slabs and the ends of ranges are kept within one beside the grid; of the last square the
// complement is kept, so that both ends go down when the face reaches further.
class FaceInGrid::Slabs {
  public:
    static constexpr std::uint32_t words(int side) {
        return 2 * static_cast<std::uint32_t>(words_of_ends(side));
    }

    // Memory: words(side).
    Slabs(std::uint32_t* memory, int side) : ends_{memory, memory + words_of_ends(side)} {}

    // Before others reach further: these slabs and those beside them, by words.
    void fill(const IndexRange& slabs, const IndexRange& range) {
        const std::uint32_t first = four_of(range.first);
        const std::uint32_t last = four_of(~range.last);
        for (int word = slabs.first / 4; word <= (slabs.last + 2) / 4; ++word) {
            ends_[0][word] = first;
            ends_[1][word] = last;
        }
    }
    // The left or the right ends; of the slab before the first one at -1.
    std::int8_t* ends(bool right) { return reinterpret_cast<std::int8_t*>(ends_[right ? 1 : 0]) + 1; }
    IndexRange at(int slab) { return {ends(false)[slab], ~ends(true)[slab]}; }

  private:
    // A byte a slab.
    static constexpr int words_of_ends(int side) { return (side + 5) / 4; }
    static constexpr std::uint32_t four_of(int end) {
        return static_cast<std::uint8_t>(end) * std::uint32_t{0x01010101};
    }

    std::uint32_t* ends_[2];
};

// In each slab a left edge reaches least where the slab's lower line cuts it, or its upper line, as the edge
// leans; or at its end. What is on a line from the left does not reach into the square behind it: so of right
// edges the squares are those of what is just before.
[[gnu::always_inline]] inline void FaceInGrid::add_edge(int u, int v, const SeenEdge& edge, bool right,
                                                        Slabs& slabs) const {
    const int side = grid_.side();
    const std::int32_t first_u = grid_.corner.at[u];
    const std::int32_t first_v = grid_.corner.at[v];
    const int low = clipped((edge.v - first_v) >> grid_.shift, -1, side); // the slabs of its ends
    const int high = clipped((edge.end_v - 1 - first_v) >> grid_.shift, -1, side);
    const int before = right ? 1 : 0;
    const bool at_lower = right == (edge.run() < 0);
    std::int8_t* const ends = slabs.ends(right) - (1 - int{at_lower}); // by the lines below slabs
    const auto reach = [ends, before](int line, int square) {
        const int end = square ^ -before;
        ends[line] = static_cast<std::int8_t>(end < ends[line] ? end : ends[line]);
    };
    reach(chosen(at_lower, low, high + 1),
          clipped((chosen(at_lower, edge.u, edge.end_u) - before - first_u) >> grid_.shift, -1, side));
    int line = low + 1;
    if (line > high) return;
    const std::int64_t value = -edge.at(first_u, first_v) - before;
    const int guess = clipped((edge.u - first_u) >> grid_.shift, -1, side);
    EdgeStair square({edge.rise(), edge.run()}, scaled(value, grid_.shift) + line * edge.run(), side, guess);
    for (; line <= high; ++line, square.next()) reach(line, square.floor());
}

// A convex face has inner points in an open slab wherever it has any; what it is seen to meet of a slab is in
// a row, from where its left edges in the slab reach least to where its right ones reach most. Seen as a line
// its edges are both.
void FaceInGrid::see(int u, int v, const Plane& plane, const Ranges& range, Slabs& slabs) const {
    if (range.is_within(u) || range.is_within(v)) return slabs.fill(range[v], range[u]);
    slabs.fill(range[v], {grid_.side() + 1, -1});
    const int turn = turn_of(plane, axis_x + axis_y + axis_z - u - v);
    if (turn >= 0) add_edges(u, v, true, slabs);
    if (turn <= 0) add_edges(u, v, false, slabs);
}

// All edges; right ones are those that rise, or else those that fall.
void FaceInGrid::add_edges(int u, int v, bool rising_right, Slabs& slabs) const {
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        const SeenEdge edge(*a, *b, u, v);
        a = b;
        add_edge(u, v, edge, edge.rises == rising_right, slabs);
    }
}

// Here, where what PassedOctants does stands once already.
[[gnu::noinline]] std::uint32_t PassedRowsAnew::next(const Plane& plane, const OctantGrid& grid,
                                                     const IndexRange& x, int j, int k) {
    return passed_in_row(plane, x, PassedOctants(plane, grid, x.first).at(j, k));
}

void FaceInGrid::mark_many(std::uint32_t* rows, std::uint32_t* scratch, std::uint32_t* near_rings) {
    const Ranges range = ranges();
    if (range[0].empty() || range[1].empty() || range[2].empty()) return;
    if (end_ - corners_ == 3 && range.is_within_two()) return mark_all(range, rows);
    if (guesses_cost_much && is_small() && mark_small(range, rows, scratch)) return;
    if (is_convex()) {
        mark_convex(plane(), range, rows, scratch);
    } else {
        mark_any(plane(), range, rows, scratch, near_rings);
    }
}

// The separating axes of a box and a convex face: the box's own are the ranges; those across an edge are the
// squares' as seen along each axis; and the plane. A face between the ends of one interval along an axis
// meets what it is seen to meet along that axis; and between two such pairs it meets all in its box. Seen as
// a line along x it is the plane's too.
void FaceInGrid::mark_convex(const Plane& plane, const Ranges& range, std::uint32_t* rows,
                             std::uint32_t* scratch) const {
    static_assert(last_grid_space(4) >= 16 + 2 * Slabs::words(16) &&
                      last_grid_space(5) >= 32 + 2 * Slabs::words(32),
                  "room for the slabs");
    std::uint32_t* const x_by_y = scratch;
    Slabs x_by_z(scratch + grid_.side(), grid_.side());
    Slabs y_by_z(scratch + grid_.side() + Slabs::words(grid_.side()), grid_.side());
    see(axis_x, axis_y, plane, range, x_by_z);
    for (int j = range[1].first; j <= range[1].last; ++j) {
        x_by_y[j] = common(range[0], x_by_z.at(j)).bits_or_none();
    }
    see(axis_x, axis_z, plane, range, x_by_z);
    see(axis_y, axis_z, plane, range, y_by_z);
    // Otherwise the plane adds nothing.
    const bool is_cut = plane.normal(axis_x).value() != 0 && range.within == 0;
    PassedOctants passed(plane, grid_, range[0].first);
    for (int k = range[2].first; k <= range[2].last; ++k) {
        const std::uint32_t x = common(x_by_z.at(k), range[0]).bits_or_none();
        const IndexRange y = common(y_by_z.at(k), range[1]);
        std::uint32_t* row = rows + grid_.row(y.first, k);
        if (!is_cut) {
            for (int j = y.first; j <= y.last; ++j) *row++ |= x & x_by_y[j];
        } else if (!y.empty()) {
            PlaneBand band = passed.at(y.first, k);
            for (int j = y.first; j <= y.last; ++j, band.next()) {
                *row++ |= x & x_by_y[j] & band.bits(range[0]);
            }
        }
    }
}

void FaceInGrid::mark_all(const Ranges& range, std::uint32_t* rows) const {
    const std::uint32_t bits = range[0].bits();
    for (int k = range[2].first; k <= range[2].last; ++k) {
        for (int j = range[1].first; j <= range[1].last; ++j) rows[grid_.row(j, k)] |= bits;
    }
}

std::uint64_t FaceInGrid::octants_of_many(std::uint32_t* scratch) {
    for (int row = 0; row < grid_.rows(); ++row) scratch[row] = 0;
    mark_many(scratch, scratch + 16, nullptr);
    return as_mask(scratch, grid_.levels);
}

} // namespace osem
