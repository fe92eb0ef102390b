#include "grid/face_in_grid.hpp"

#include "classify/box.hpp"
#include "geometry/plane.hpp"
#include "geometry/sight.hpp"

namespace osem {

namespace {

constexpr int u_of[3] = {1, 0, 0}; // what is seen along an axis: the other two in ascending order
constexpr int v_of[3] = {2, 2, 1};

// An edge seen along an axis, as the function that is 0 on its line and below 0 to its left. Its values in
// the root are below 2^42.
struct SeenEdge {
    std::int64_t u; ///< how much it grows by a unit along u
    std::int64_t v;
    std::int64_t value; ///< at the corner of the first square

    SeenEdge(const Point& a, const Point& b, int axis, const Point& corner)
        : u(b.at[v_of[axis]] - a.at[v_of[axis]]), v(a.at[u_of[axis]] - b.at[u_of[axis]]),
          value(u * (corner.at[u_of[axis]] - a.at[u_of[axis]]) +
                v * (corner.at[v_of[axis]] - a.at[v_of[axis]])) {}

    bool is_null() const { return u == 0 && v == 0; }

    // The squares that reach to the edge's left.
    unsigned reaching(const OctantGrid& grid, const Squares& squares) const {
        const std::int64_t step_u = scaled(u, grid.shift);
        const std::int64_t step_v = scaled(v, grid.shift);
        const std::int64_t least = value + (step_u < 0 ? step_u : 0) + (step_v < 0 ? step_v : 0);
        return SquareFunction{least, step_u, step_v}.below(squares);
    }

    // The squares whose reference point is to the edge's left; the corner is a reference point.
    unsigned holding(const OctantGrid& grid, const Squares& squares) const {
        const bool moves_left = u < 0 || (u == 0 && v < 0);
        return SquareFunction{value - (moves_left ? 1 : 0), scaled(u, grid.shift), scaled(v, grid.shift)}
            .below(squares);
    }
};

// A convex face as seen along an axis: its edges run counter-clockwise, or all in one line.
template <Axis axis>
class SeenFace {
  public:
    SeenFace(const Solid& solid, const std::uint32_t* corners, int count, const Plane& plane)
        : count_(count), in_line_(plane.normal(axis).value() == 0) {
        // (x, z) is left-handed as seen along y.
        const bool forward = (plane.normal(axis).sign() < 0) == (axis == axis_y);
        for (int i = 0; i < count; ++i) corner_[i] = &solid.vertices[corners[forward ? i : count - 1 - i]];
    }

    // The squares that it meets, of those that its bounding rectangle meets; `first` is the corner of the
    // first one.
    unsigned met(const OctantGrid& grid, const IndexRange (&range)[3], const Point& first) const {
        const Squares squares = {range[u_of[axis]], range[v_of[axis]]};
        unsigned set = squares.all();
        for (int i = 0; i < count_ && set != 0; ++i) {
            const Point& a = *corner_[i];
            const Point& b = *corner_[i + 1 == count_ ? 0 : i + 1];
            const SeenEdge edge(a, b, axis, first);
            if (edge.is_null()) continue; // a null axis separates nothing
            set &= edge.reaching(grid, squares);
            if (in_line_) set &= SeenEdge(b, a, axis, first).reaching(grid, squares);
        }
        return set;
    }

    // Those whose reference point it holds, of which `first` is the first one. Precondition: it is not in one
    // line.
    unsigned holding(const OctantGrid& grid, const Squares& squares, const Point& first) const {
        unsigned set = squares.all();
        for (int i = 0; i < count_ && set != 0; ++i) {
            set &= SeenEdge(*corner_[i], *corner_[i + 1 == count_ ? 0 : i + 1], axis, first)
                       .holding(grid, squares);
        }
        return set;
    }

  private:
    const Point* corner_[4];
    int count_;
    bool in_line_;
};

// Those of a set of octants through which a plane passes.
std::uint64_t passed(const Plane& plane, const OctantGrid& grid, std::uint64_t set) {
    std::int64_t step[3];
    std::int64_t least = plane.at(grid.corner).value();
    std::int64_t greatest = least;
    for (int axis = 0; axis < 3; ++axis) {
        step[axis] = scaled(plane.normal(axis).value(), grid.shift);
        (step[axis] < 0 ? least : greatest) += step[axis];
    }
    std::uint64_t result = 0;
    for (unsigned row = 0; row < 16; ++row) {
        const unsigned octants = static_cast<unsigned>(set >> (4 * row)) & 15U;
        if (octants != 0) {
            const unsigned met = below_zero(least, step[0]) & below_zero(-greatest, -step[0]);
            result |= std::uint64_t{octants & met} << (4 * row);
        }
        const std::int64_t next = (row & 3U) != 3 ? step[1] : step[2] - 3 * step[1];
        least += next;
        greatest += next;
    }
    return result;
}

// On which side of a face's plane the reference points of a grid lie. A value is that of the plane at a
// lattice point at most 5/4 of the root's side from the root's corner along one axis (5/2 in a grid of eight
// octants) and within the root along the others. The components of the normal are 2^41 at most each and 2^42
// together (a determinant of numbers up to 1 is at most 4), so values are below 7 * 2^60.
class Sides {
  public:
    Sides(const Plane& plane, const OctantGrid& grid) {
        std::int64_t tie = 0; // what decides on the plane: the first component of the normal that is not 0
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t component = plane.normal(axis).value();
            step_[axis] = scaled(component, grid.shift);
            if (tie == 0) tie = component;
        }
        value_ = plane.at(grid.reference(0, 0, 0)).value() - (tie < 0 ? 1 : 0);
    }

    // The reference points behind the plane on a ray along an axis: those on another side than the ray's
    // first one. Seen from there, they are all that the ray leads to: a plane of points along z, a row along
    // x.
    std::uint64_t behind(int axis, int u, int v) const {
        unsigned across = below_zero(value_ + u * step_[u_of[axis]] + v * step_[v_of[axis]], step_[axis]);
        if ((across & 1U) != 0) across ^= 15U;
        if (axis == axis_x) return std::uint64_t{across} << (4 * u + 16 * v);
        if (axis == axis_y) return std::uint64_t{spread(across) * 15U} << (16 * v);
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

bool FaceInGrid::is_level() const {
    return low_.x() == high_.x() || low_.y() == high_.y() || low_.z() == high_.z();
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
    if (ring_end_ != first_ring_ + 1 || end_ - corners_ > 4) return false;
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
    const bool within[3] = {is_within(0, range[0]), is_within(1, range[1]), is_within(2, range[2])};
    const std::uint64_t all = octants_in(range);
    if ((within[0] ? 1 : 0) + (within[1] ? 1 : 0) + (within[2] ? 1 : 0) > 1) return all;
    const Point first = grid_.at(range[0].first, range[1].first, range[2].first);
    const auto seen = [&](auto view) { return view.met(grid_, range, first); };
    if (within[0]) return all & behind_x(seen(SeenFace<axis_x>(solid_, corners_, corner_count(), plane)));
    if (within[1]) return all & behind_y(seen(SeenFace<axis_y>(solid_, corners_, corner_count(), plane)));
    if (within[2]) return all & behind_z(seen(SeenFace<axis_z>(solid_, corners_, corner_count(), plane)));
    // The separating axes of a box and a convex face: the box's own are the ranges; those across an edge are
    // the squares' as seen along each axis; and the plane.
    std::uint64_t set = behind_x(seen(SeenFace<axis_x>(solid_, corners_, corner_count(), plane)));
    set &= behind_y(seen(SeenFace<axis_y>(solid_, corners_, corner_count(), plane)));
    set &= behind_z(seen(SeenFace<axis_z>(solid_, corners_, corner_count(), plane)));
    set &= all;
    return set == 0 || plane.is_null() ? set : passed(plane, grid_, set);
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
    add_along<axis_x>(plane, rays.seen[0], windings);
    add_along<axis_y>(plane, rays.seen[1], windings);
    add_along<axis_z>(plane, rays.seen[2], windings);
}

template <Axis axis>
void FaceInGrid::add_along(const Plane& plane, const Squares& seen, WindingLanes& windings) const {
    if (seen.empty() || plane.normal(axis).value() == 0) return;
    int index[3] = {0, 0, 0};
    index[u_of[axis]] = seen.u.first;
    index[v_of[axis]] = seen.v.first;
    const Point first = grid_.reference(index[0], index[1], index[2]);
    unsigned through = SeenFace<axis>(solid_, corners_, corner_count(), plane).holding(grid_, seen, first);
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
