#include "grid/face_in_grid.hpp"

#include "classify/box.hpp"
#include "geometry/plane.hpp"
#include "geometry/sight.hpp"

namespace osem {

namespace {

constexpr int u_of[3] = {1, 0, 0}; // what is seen along an axis: the other two in ascending order
constexpr int v_of[3] = {2, 2, 1};

// The edge from a to b of a convex face, and a grid, as seen along an axis: the function that is 0 on the
// edge's line and below 0 to its left. To the left or to the right, as `inside` says (1 or -1), lies the
// face.
class SeenEdge {
  public:
    SeenEdge(const Point& a, const Point& b, const Point& origin) {
        for (int axis = 0; axis < 3; ++axis) {
            way_[axis] = b.at[axis] - a.at[axis];
            from_[axis] = origin.at[axis] - a.at[axis];
        }
    }

    bool is_seen(int axis) const { return way_[u_of[axis]] != 0 || way_[v_of[axis]] != 0; }

    // The squares that reach to the face's side of the edge; the origin is the grid's corner.
    unsigned reaching(int axis, int inside, int shift, const Squares& squares) const {
        SquareFunction function = seen(axis, inside, shift, 0);
        function.value +=
            (function.step_u < 0 ? function.step_u : 0) + (function.step_v < 0 ? function.step_v : 0);
        return function.below(squares);
    }

    // The squares whose reference point lies there; the origin is the first one, which is moved by (e, e^2).
    unsigned holding(int axis, int inside, int shift, const Squares& squares) const {
        const std::int32_t u = inside * way_[v_of[axis]];
        const std::int32_t v = -inside * way_[u_of[axis]];
        return seen(axis, inside, shift, u < 0 || (u == 0 && v < 0) ? 1 : 0).below(squares);
    }

  private:
    // Products of differences of vertices: below 2^42. Steps are 2^20 at most and no square is five of them
    // away along either axis, so a value that is 2^24 or more keeps its sign and may be clipped.
    SquareFunction seen(int axis, int inside, int shift, int tie) const {
        constexpr std::int64_t most = std::int64_t{1} << 24;
        const int u = u_of[axis];
        const int v = v_of[axis];
        const std::int64_t exact = std::int64_t{way_[v]} * from_[u] - std::int64_t{way_[u]} * from_[v];
        const std::int64_t value = ((inside < 0 ? -exact : exact) - tie) >> shift;
        return {static_cast<std::int32_t>(value > most    ? most
                                          : value < -most ? -most
                                                          : value),
                inside * way_[v], -inside * way_[u]};
    }

    std::int32_t way_[3];
    std::int32_t from_[3];
};

// On which side of its edges a face lies as seen along an axis, the edges running as its corners: 1 for the
// left, -1 for the right, 0 when they are all in one line. (x, z) is left-handed as seen along y.
int inside_of(const Plane& plane, int axis) {
    const int sign = plane.normal(axis).sign();
    return axis == axis_y ? -sign : sign;
}

// Those of a set of octants through which a plane passes. The value at the grid's corner is at most
// 3 * (2^61 + 2^41), divided by the octants' side or not; steps are 2^41 at most, and fewer than 20 are
// taken.
std::uint64_t passed(const Plane& plane, const OctantGrid& grid, std::uint64_t set) {
    const std::int64_t value = plane.at(grid.corner).value();
    std::int64_t least = value >> grid.shift;       // of an octant: below 0 when the plane is above it
    std::int64_t greatest = (-value) >> grid.shift; // turned: below 0 when the plane is below it
    std::int64_t step[3];
    for (int axis = 0; axis < 3; ++axis) {
        step[axis] = plane.normal(axis).value();
        (step[axis] < 0 ? least : greatest) += step[axis] < 0 ? step[axis] : -step[axis];
    }
    std::uint64_t result = 0;
    for (unsigned row = 0; row < 16; ++row) {
        const unsigned octants = static_cast<unsigned>(set >> (4 * row)) & 15U;
        if (octants != 0) {
            const unsigned met = below_zero(least, step[0]) & below_zero(greatest, -step[0]);
            result |= std::uint64_t{octants & met} << (4 * row);
        }
        const std::int64_t next = (row & 3U) != 3 ? step[1] : step[2] - 3 * step[1];
        least += next;
        greatest -= next;
    }
    return result;
}

// On which side of a face's plane the reference points of a grid lie. Values are bounded
// as in `passed`.
class Sides {
  public:
    Sides(const Plane& plane, const OctantGrid& grid) {
        std::int64_t tie = 0; // what decides on the plane: the first component of the normal that is not 0
        for (int axis = 0; axis < 3; ++axis) {
            step_[axis] = plane.normal(axis).value();
            if (tie == 0) tie = step_[axis];
        }
        value_ = (plane.at(grid.reference(0, 0, 0)).value() - (tie < 0 ? 1 : 0)) >> grid.shift;
    }

    // The reference points behind the plane on a ray along an axis: those on another side than the ray's
    // first one. Seen from there, they are all that the ray leads to: a plane of points along z, a row along
    // x.
    std::uint64_t behind(int axis, int u, int v) const {
        unsigned across = below_zero(value_ + u * step_[u_of[axis]] + v * step_[v_of[axis]], step_[axis]);
        if ((across & 1U) != 0) across ^= 15U;
        if (axis == axis_x) return std::uint64_t{across} << (4 * u + 16 * v);
        if (axis == axis_y) return std::uint64_t{spread(across)} * 15U << (16 * v);
        std::uint64_t set = 0;
        for (unsigned k = 1; k < 4; ++k) {
            if ((across >> k & 1U) != 0) set |= std::uint64_t{0xffff} << (16 * k);
        }
        return set;
    }

  private:
    std::int64_t value_;
    std::int64_t step_[3];
};

} // namespace

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

bool FaceInGrid::is_between_octants() const {
    for (int axis = 0; axis < 3; ++axis) {
        if (low_.at[axis] == high_.at[axis] && (low_.at[axis] & (grid_.side() - 1)) == 0) return true;
    }
    return false;
}

namespace {

IndexRange clipped(int first, int last, const OctantGrid& grid) {
    return {first < 0 ? 0 : first, last > grid.last ? grid.last : last};
}

} // namespace

// Triangles are; and so are quadrangles that turn the same way at every corner: exterior angles below 180
// degrees add up to 360. (Five could add up to 720.) Seen along an axis that the normal is not across, turns
// keep their sign.
bool FaceInGrid::is_convex(const Plane& plane) const {
    if (end_ - corners_ > 4) return false; // as those of two rings are
    if (corner_count() == 3) return true;
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

// Which open intervals of the grid along an axis the face overlaps: it must reach beyond both ends.
IndexRange FaceInGrid::overlapped(int axis) const {
    const std::int32_t corner = grid_.corner.at[axis];
    return clipped((low_.at[axis] - corner) >> grid_.shift, (high_.at[axis] - 1 - corner) >> grid_.shift,
                   grid_);
}

// Which reference points lie between its ends: moved by an infinitesimal, they are above an end with which
// they are level.
IndexRange FaceInGrid::between(int axis) const {
    const std::int32_t first = grid_.corner.at[axis] + grid_.offset;
    return clipped((low_.at[axis] - first + grid_.side() - 1) >> grid_.shift,
                   (high_.at[axis] - 1 - first) >> grid_.shift, grid_);
}

std::uint64_t FaceInGrid::octants_met() const {
    const IndexRange range[3] = {overlapped(0), overlapped(1), overlapped(2)};
    if (range[0].empty() || range[1].empty() || range[2].empty()) return 0;
    const Plane plane(solid_, corners_, end_);
    if (!is_convex(plane)) return classified(range);
    // A convex face between the ends of one interval along an axis has inner points in the open interval
    // wherever it has any: it meets what it is seen to meet along that axis. Between two such pairs it meets
    // all in the range.
    int first_axis = 0;
    int end_axis = 3;
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_within(axis, range[axis])) continue;
        if (end_axis - first_axis == 1) return octants_in(range);
        first_axis = axis;
        end_axis = axis + 1;
    }
    // The separating axes of a box and a convex face: the box's own are the ranges; those across an edge are
    // the squares' as seen along each axis; and the plane.
    unsigned met[3] = {0xffff, 0xffff, 0xffff};
    cut_squares(plane, range, first_axis, end_axis, met);
    const std::uint64_t set =
        octants_in(range) & behind_x(met[axis_x]) & behind_y(met[axis_y]) & behind_z(met[axis_z]);
    return end_axis - first_axis == 1 || set == 0 || plane.is_null() ? set : passed(plane, grid_, set);
}

// Takes from the squares seen along some axes those that the face is not seen to meet.
void FaceInGrid::cut_squares(const Plane& plane, const IndexRange (&range)[3], int first_axis, int end_axis,
                             unsigned (&met)[3]) const {
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        const SeenEdge edge(*a, *b, grid_.corner);
        a = b;
        for (int axis = first_axis; axis < end_axis; ++axis) {
            if (!edge.is_seen(axis)) continue; // a null axis separates nothing
            const Squares squares = {range[u_of[axis]], range[v_of[axis]]};
            // Of a ring seen in one line some edges run one way and some the other: both sides are looked at.
            const int inside = inside_of(plane, axis) < 0 ? -1 : 1;
            met[axis] &= edge.reaching(axis, inside, grid_.shift, squares);
        }
    }
}

// Whether the face lies between the ends of the only interval in a range along an axis.
bool FaceInGrid::is_within(int axis, const IndexRange& range) const {
    const std::int32_t low = grid_.corner.at[axis] + (range.first << grid_.shift);
    return range.first == range.last && low_.at[axis] >= low && high_.at[axis] <= low + grid_.side();
}

// The same for a face of any rings, octant by octant.
std::uint64_t FaceInGrid::classified(const IndexRange (&range)[3]) const {
    std::uint64_t set = 0;
    for (std::uint64_t left = octants_in(range); left != 0; left &= left - 1) {
        const auto place = static_cast<int>(lowest_of(left));
        Box box = {grid_.at(place & 3, place >> 2 & 3, place >> 4), {}};
        for (int axis = 0; axis < 3; ++axis) box.hi.at[axis] = box.lo.at[axis] + grid_.side();
        if (classify_box(solid_, face_, box).meets) set |= std::uint64_t{1} << place;
    }
    return set;
}

// Along y and z only from the first points along x, and along z only from the first along y.
GridRays FaceInGrid::rays() const {
    const IndexRange x = between(axis_x);
    const IndexRange y = between(axis_y);
    const IndexRange z = between(axis_z);
    const auto first = [](const IndexRange& range) {
        return IndexRange{range.first, range.last < 0 ? -1 : 0};
    };
    return {{{y, z}, {first(x), z}, {first(x), first(y)}}};
}

void FaceInGrid::add_crossings(WindingLanes& windings) const {
    const GridRays rays = this->rays();
    if (rays.none()) return;
    const Plane plane(solid_, corners_, end_);
    if (!is_convex(plane)) return add_ray_by_ray(rays, windings);
    for (int axis = 0; axis < 3; ++axis) add_along(axis, plane, rays.seen[axis], windings);
}

void FaceInGrid::add_along(int axis, const Plane& plane, const Squares& squares,
                           WindingLanes& windings) const {
    const int inside = inside_of(plane, axis);
    if (squares.empty() || inside == 0) return;
    unsigned through = squares.all();
    const Point first = grid_.reference(0, 0, 0);
    const Point* a = &solid_.vertices[end_[-1]];
    for (const std::uint32_t* corner = corners_; corner != end_ && through != 0; ++corner) {
        const Point* b = &solid_.vertices[*corner];
        through &= SeenEdge(*a, *b, first).holding(axis, inside, grid_.shift, squares);
        a = b;
    }
    if (through == 0) return;
    const Sides sides(plane, grid_);
    std::uint64_t behind = 0;
    for (; through != 0; through &= through - 1) {
        const auto ray = static_cast<int>(lowest_of(through));
        behind |= sides.behind(axis, ray & 3, ray >> 2);
    }
    windings.add(behind, plane.normal(axis).sign() < 0); // against the normal, into the solid
}

// The same for a face of any rings.
void FaceInGrid::add_ray_by_ray(const GridRays& rays, WindingLanes& windings) const {
    const Sides sides(Plane(solid_, corners_, end_), grid_);
    for (int axis = 0; axis < 3; ++axis) {
        for (unsigned left = rays.seen[axis].all(); left != 0; left &= left - 1) {
            const auto ray = static_cast<int>(lowest_of(left));
            int index[3] = {0, 0, 0};
            index[u_of[axis]] = ray & 3;
            index[v_of[axis]] = ray >> 2;
            const Point from = grid_.reference(index[0], index[1], index[2]);
            std::int32_t winding =
                winding_of_rings(solid_, first_ring_, ring_end_, Sight(from, static_cast<Axis>(axis)));
            if (axis != axis_y) winding = -winding;
            const std::uint64_t behind = sides.behind(axis, ray & 3, ray >> 2);
            for (; winding > 0; --winding) windings.add(behind, true);
            for (; winding < 0; ++winding) windings.add(behind, false);
        }
    }
}

} // namespace osem
