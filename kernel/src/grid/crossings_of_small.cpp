// What a small triangle adds to the winding numbers of a grid's reference points.
#include "grid/edge_functions.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/seen_edge.hpp"
#include "grid/stair.hpp"

namespace osem {

namespace {

// The last points before the plane on rays along an axis, along which it is not seen as a line; as Passages
// has them, for a normal of 31 bits.
[[gnu::always_inline]] inline FourStairs last_before(const SmallPlane& plane, int axis, int shift) {
    const std::int64_t turn = plane.sign(axis);
    int tie = axis_x; // the first component that is not 0 decides about points on the plane
    while (plane.normal[tie] == 0) ++tie;
    const std::int64_t nudge = turn * plane.normal[tie] < 0 ? 1 : 0;
    return {turn * plane.normal[axis], ~((turn * plane.value - nudge) >> shift),
            -turn * plane.normal[u_of[axis]], -turn * plane.normal[v_of[axis]]};
}

// Places behind which there is one more, or one less, as they are found.
class Places {
  public:
    explicit Places(std::uint32_t* memory) : first_(memory), end_(memory) {}

    // Those of four that are there; of these `is_there` is 1, of others 0.
    [[gnu::always_inline]] void add(const Four& places, const Four& is_there) {
        for (unsigned i = 0; i < 4; ++i) { // kept if it is there
            *end_ = places[i];
            end_ += is_there[i];
        }
    }
    bool are_many() const { return end_ - first_ > most_kept; }
    [[gnu::always_inline]] void tell(RowWindings& windings, std::int32_t number) {
        windings.add_behind_each(first_, end_, number);
        end_ = first_;
    }

  private:
    static constexpr int most_kept = 44; // to which four may be added
    static_assert(last_grid_space(1) >= most_kept + 4, "room for places");

    std::uint32_t* first_;
    std::uint32_t* end_;
};

// Rays along x: of the rows of a range along y in four layers side by side, then in the next four. All of
// them are in the grid, so that those that the triangle does not have need not be left out. Where it is seen
// its plane is where it is, so quotients modulo 2^32 are the numbers themselves; elsewhere they do not
// matter.
void add_along_x(const SmallTriangle& triangle, const SmallPlane& plane, const OctantGrid& grid,
                 const IndexRange& y, int z, int fours, RowWindings& windings, std::uint32_t* scratch) {
    const int turn = plane.sign(axis_x);
    EdgeFunctions edges(triangle, axis_y, axis_z, turn, grid.shift, EdgeFunctions::Of::points);
    FourStairs last = last_before(plane, axis_x, grid.shift);
    Places places(scratch);
    const auto most = static_cast<std::uint32_t>(grid.side() - 1);
    const std::uint32_t layer = RowWindings::place(grid.row(0, 1), 0);
    Four first_row = {};
    set_multiples(first_row, layer);
    first_row += RowWindings::place(grid.row(y.first, z), 0);
    for (; fours > 0; --fours, first_row += 4 * layer) {
        Four row = first_row;
        edges.begin_four();
        last.begin_four();
        for (std::uint32_t left = y.count(); left != 0; --left) {
            Four outside = {}; // if its sign is set
            edges.outside(outside);
            outside |= last.values() | (most - 1 - last.values());
            places.add(row + last.values(), ~outside >> 31);
            if (places.are_many()) places.tell(windings, -turn);
            row += RowWindings::place(1, 0);
            edges.next();
            last.next();
        }
    }
    places.tell(windings, -turn);
}

// Rays along z, of the first points along x: of a range along y, four beside each other.
void add_along_z(const SmallTriangle& triangle, const SmallPlane& plane, const OctantGrid& grid,
                 const IndexRange& y, RowWindings& windings) {
    const int turn = plane.sign(axis_z);
    EdgeFunctions edges(triangle, axis_x, axis_y, turn, grid.shift, EdgeFunctions::Of::points);
    FourStairs last = last_before(plane, axis_z, grid.shift);
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
    const int fours = fours_of(z);
    const int first_z = first_of_fours(z, grid_.side());
    const SmallTriangle triangle = small_triangle(grid_.point(0, y.first, first_z));
    const SmallPlane plane(triangle);
    if (!plane.has_31_bits()) return false;
    if (!y.empty() && fours > 0 && is_crossed(axis_x) && plane.normal[axis_x] != 0) {
        add_along_x(triangle, plane, grid_, y, first_z, fours, windings, scratch);
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
