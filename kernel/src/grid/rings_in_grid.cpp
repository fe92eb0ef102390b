// The octants of a grid that a face of any rings meets: by classification, of as few as are needed.
#include <type_traits>

#include "classify/box.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/passed_octants.hpp"
#include "grid/seen_edge.hpp"
#include "grid/stair.hpp"
#include "tree/guesses.hpp"

namespace osem {

namespace {

// While octants are classified small parts have no stack to spare.
using RowsOfPlane = std::conditional_t<guesses_cost_much, PassedRows, PassedRowsAnew>;

// The axis along which an edge is longest: from slab to slab along it, it goes on by one octant at most.
int longest_axis(const Point& a, const Point& b) {
    const auto length = [&](int axis) {
        const std::int32_t difference = b.at[axis] - a.at[axis];
        return difference < 0 ? -difference : difference;
    };
    int longest = axis_x;
    for (int axis = axis_y; axis < 3; ++axis) {
        if (length(axis) > length(longest)) longest = axis;
    }
    return longest;
}

// The slab along v, or the octant along u, of a coordinate; their lower ends are counted to them. One beside
// the grid stands for all there.
int slab_of(const OctantGrid& grid, int axis, std::int32_t coordinate) {
    return clipped((coordinate - grid.corner.at[axis]) >> grid.shift, -1, grid.side());
}

// On which sides of the grid a point lies: a bit for each.
unsigned sides_beside(const OctantGrid& grid, const Point& point) {
    unsigned sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int slab = slab_of(grid, axis, point.at[axis]);
        sides = sides << 2 | (slab < 0 ? 1U : 0U) | (slab == grid.side() ? 2U : 0U);
    }
    return sides;
}

// Which octants along u an edge has in slabs along v, from the slab of its low end on.
class OctantsOfEdge {
  public:
    OctantsOfEdge(const SeenEdge& edge, const OctantGrid& grid, int u, int v)
        : before_(slab_of(grid, u, edge.u)), end_(slab_of(grid, u, edge.end_u)),
          line_({edge.rise() > 0 ? edge.rise() : 1, edge.run()}, // without a rise no line is asked for
                scaled(-edge.at(grid.corner.at[u], grid.corner.at[v]), grid.shift) +
                    (slab_of(grid, v, edge.v) + 1) * edge.run(),
                grid.side(), before_) {}

    IndexRange next(bool is_last) {
        const int after = is_last ? end_ : line_.floor();
        const IndexRange range = before_ < after ? IndexRange{before_, after} : IndexRange{after, before_};
        before_ = after;
        if (!is_last) line_.next();
        return range;
    }

  private:
    int before_;
    int end_;
    EdgeStair line_; ///< at the upper end of the slab
};

} // namespace

bool FaceInGrid::meets(int i, int j, int k) const {
    Box box = {grid_.at(i, j, k), {}};
    for (int axis = 0; axis < 3; ++axis) box.hi.at[axis] = box.lo.at[axis] + grid_.length();
    return classify_box(solid_, face_, box).meets;
}

// The plane's part in two octants that have a side in common hangs together, as it passes through that side.
// If no ring reaches into either one or that side, which is counted to the upper one, then rings wind around
// the plane's points in both as often: so the face meets both or neither. Where that is known of one it is
// known of all that hang together.
void FaceInGrid::mark_any(const Plane& plane, const Ranges& range, std::uint32_t* rows,
                          std::uint32_t* scratch, std::uint32_t* near_rings) const {
    static_assert(last_grid_space(4) >= 2 * 16 && last_grid_space(5) >= 2 * 32, "room for a layer");
    const bool has_plane = !plane.is_null();
    RowsOfPlane passed(plane, grid_, range[0]);
    if (near_rings == nullptr || !has_plane) {
        for (int k = range[2].first; k <= range[2].last; ++k) {
            passed.begin_layer(range[1].first, k);
            for (int j = range[1].first; j <= range[1].last; ++j) {
                const std::uint32_t octants =
                    has_plane ? passed.next(plane, grid_, range[0], j, k) : range[0].bits();
                classify_each(octants, j, k, rows);
            }
        }
        return;
    }
    find_near_rings(near_rings);
    auto* const below = reinterpret_cast<Settled*>(scratch); // of the layer below, row by row
    for (int j = 0; j < grid_.side(); ++j) below[j] = Settled{0, 0};
    for (int k = range[2].first; k <= range[2].last; ++k) {
        Settled before = {0, 0};
        passed.begin_layer(range[1].first, k);
        for (int j = range[1].first; j <= range[1].last; ++j) {
            const std::uint32_t octants = passed.next(plane, grid_, range[0], j, k);
            const int row = grid_.row(j, k);
            const std::uint32_t away = octants & ~near_rings[row];
            before = settled(away, before, below[j], j, k);
            below[j] = before;
            rows[row] |= before.met;
            classify_each(octants & near_rings[row], j, k, rows);
        }
    }
}

// Of octants away from rings in a row, beside two rows where it is known: range by range, one of them
// decides.
FaceInGrid::Settled FaceInGrid::settled(std::uint32_t away, const Settled& before, const Settled& below,
                                        int j, int k) const {
    const std::uint32_t known = before.away | below.away;
    const std::uint32_t known_met = before.met | below.met;
    if ((away & ~known) == 0) return {away, away & known_met}; // each one is beside another that is like it
    std::uint32_t met = 0;
    for (std::uint32_t left = away; left != 0;) {
        const unsigned first = lowest_of(left);
        const std::uint32_t behind = ~left & ~((std::uint32_t{1} << first) - 1);
        const std::uint32_t range = left & (behind == 0 ? left : (behind & (~behind + 1)) - 1);
        left &= ~range;
        const bool is_met =
            (range & known) != 0 ? (range & known_met) != 0 : meets(static_cast<int>(first), j, k);
        if (is_met) met |= range;
    }
    return {away, met};
}

void FaceInGrid::classify_each(std::uint32_t octants, int j, int k, std::uint32_t* rows) const {
    std::uint32_t& row = rows[grid_.row(j, k)];
    octants &= ~row; // what is marked is
    for (; octants != 0; octants &= octants - 1) {
        const unsigned i = lowest_of(octants);
        if (meets(static_cast<int>(i), j, k)) row |= std::uint32_t{1} << i;
    }
}

// The octants into which a ring reaches, with their lower borders, and some beside them.
void FaceInGrid::find_near_rings(std::uint32_t* near_rings) const {
    for (int row = 0; row < grid_.rows(); ++row) near_rings[row] = 0;
    for (std::uint32_t r = first_ring_; r != ring_end_; ++r) {
        const Ring ring = solid_.ring(r);
        const Point* a = &solid_.vertices[ring.corners[ring.count - 1]];
        unsigned beside_a = sides_beside(grid_, *a);
        for (std::uint32_t corner = 0; corner < ring.count; ++corner) {
            const Point* b = &solid_.vertices[ring.corners[corner]];
            const unsigned beside_b = sides_beside(grid_, *b);
            if ((beside_a & beside_b) == 0) find_near_edge(*a, *b, near_rings);
            a = b;
            beside_a = beside_b;
        }
    }
}

void FaceInGrid::find_near_edge(const Point& a, const Point& b, std::uint32_t* near_rings) const {
    const int v = longest_axis(a, b);
    const SeenEdge edge(a, b, u_of[v], v);
    const SeenEdge other(a, b, v_of[v], v);
    OctantsOfEdge along_u(edge, grid_, u_of[v], v);
    OctantsOfEdge along_w(other, grid_, v_of[v], v);
    const IndexRange all = {0, grid_.side() - 1};
    const int last = slab_of(grid_, v, edge.end_v);
    for (int slab = slab_of(grid_, v, edge.v); slab <= last; ++slab) {
        IndexRange range[3];
        range[v] = common({slab, slab}, all);
        range[u_of[v]] = common(along_u.next(slab == last), all);
        range[v_of[v]] = common(along_w.next(slab == last), all);
        const std::uint32_t octants = range[0].bits_or_none();
        for (int k = range[2].first; k <= range[2].last; ++k) {
            for (int j = range[1].first; j <= range[1].last; ++j) near_rings[grid_.row(j, k)] |= octants;
        }
    }
}

} // namespace osem
