#include "exact_face.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>

#include <array>
#include <optional>
#include <stdexcept>

namespace oracle {

namespace {

using Point2 = Exact::Point_2;
using Vector3 = Exact::Vector_3;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Exact, CGAL::Default, CGAL::Exact_intersections_tag>;
using RingPoints = std::vector<Point3>;

std::vector<RingPoints> rings_of(const osem::Solid& solid, std::uint32_t face) {
    std::vector<RingPoints> rings;
    for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
        const osem::Ring ring = solid.ring(r);
        RingPoints points;
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            points.push_back(exact_point(solid.vertices[ring.corners[i]]));
        }
        rings.push_back(std::move(points));
    }
    return rings;
}

void add_edges(const RingPoints& ring, std::vector<Segment3>& segments) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
    }
}

// The plane through the first corner and the first two others that are not on one line with it. The sum of
// the edges' cross products would not do: it is zero for a ring shaped like an eight, which has an inside.
std::optional<Vector3> normal_of(const std::vector<RingPoints>& rings) {
    const Point3& base = rings.front().front();
    std::optional<Vector3> arm;
    for (const RingPoints& ring : rings) {
        for (const Point3& p : ring) {
            if (p == base) continue;
            if (!arm) {
                arm = p - base;
            } else if (const Vector3 n = CGAL::cross_product(*arm, p - base); n != CGAL::NULL_VECTOR) {
                return n;
            }
        }
    }
    return std::nullopt;
}

// The projection along one coordinate axis in which the plane is steepest, and the way back. Axes are taken
// in cyclic order, so that counter-clockwise in the projection is counter-clockwise seen from the positive
// end of the axis.
class Projection {
  public:
    Projection(const Vector3& normal, const Point3& base) : normal_(normal), base_(base) {
        axis_ = 0;
        for (int i = 1; i < 3; ++i) {
            if (CGAL::abs(normal[i]) > CGAL::abs(normal[axis_])) axis_ = i;
        }
        u_ = (axis_ + 1) % 3;
        v_ = (axis_ + 2) % 3;
    }

    Point2 down(const Point3& p) const { return {p[u_], p[v_]}; }

    Point3 up(const Point2& p) const {
        std::array<FT, 3> at;
        at[static_cast<std::size_t>(u_)] = p.x();
        at[static_cast<std::size_t>(v_)] = p.y();
        at[static_cast<std::size_t>(axis_)] =
            base_[axis_] -
            (normal_[u_] * (p.x() - base_[u_]) + normal_[v_] * (p.y() - base_[v_])) / normal_[axis_];
        return {at[0], at[1], at[2]};
    }

  private:
    Vector3 normal_;
    Point3 base_;
    int axis_;
    int u_;
    int v_;
};

// Winding number of closed polygons around a point that is on none of their edges.
int winding_around(const std::vector<std::vector<Point2>>& rings, const Point2& p) {
    int winding = 0;
    for (const auto& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2& a = ring[i];
            const Point2& b = ring[(i + 1) % ring.size()];
            const bool a_below = a.y() <= p.y();
            const bool b_below = b.y() <= p.y();
            if (a_below == b_below) continue;
            const CGAL::Orientation side = CGAL::orientation(a, b, p);
            if (a_below && side == CGAL::LEFT_TURN) ++winding;
            if (b_below && side == CGAL::RIGHT_TURN) --winding;
        }
    }
    return winding;
}

void triangulate(const std::vector<RingPoints>& rings, const Vector3& normal,
                 std::vector<WoundTriangle>& triangles) {
    const Projection projection(normal, rings.front().front());
    std::vector<std::vector<Point2>> flat;
    Triangulation triangulation;
    for (const RingPoints& ring : rings) {
        std::vector<Point2> points;
        for (const Point3& p : ring) points.push_back(projection.down(p));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point2& next = points[(i + 1) % points.size()];
            if (points[i] != next) triangulation.insert_constraint(points[i], next);
        }
        flat.push_back(std::move(points));
    }
    for (const auto handle : triangulation.finite_face_handles()) {
        const Point2& a = handle->vertex(0)->point();
        const Point2& b = handle->vertex(1)->point();
        const Point2& c = handle->vertex(2)->point();
        const int winding = winding_around(flat, CGAL::centroid(a, b, c));
        if (winding == 0) continue;
        triangles.push_back({Triangle3(projection.up(a), projection.up(b), projection.up(c)), winding});
    }
}

using Coordinates = std::array<FT, 3>;

Coordinates coordinates(const Point3& p) { return {p.x(), p.y(), p.z()}; }

// The part of a convex polygon on the inner side (`sign` times the axis coordinate at least `sign` times
// `bound`) of one side of a box: Sutherland and Hodgman. A cut corner's coordinate is the bound itself.
std::vector<Coordinates> clip(const std::vector<Coordinates>& polygon, std::size_t axis, const FT& bound,
                              CGAL::Sign inner) {
    std::vector<Coordinates> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Coordinates& a = polygon[i];
        const Coordinates& b = polygon[(i + 1) % polygon.size()];
        const CGAL::Sign side_a = CGAL::compare(a[axis], bound) * inner;
        const CGAL::Sign side_b = CGAL::compare(b[axis], bound) * inner;
        if (side_a != CGAL::NEGATIVE) kept.push_back(a);
        if (side_a * side_b != CGAL::NEGATIVE) continue;
        const FT t = (bound - a[axis]) / (b[axis] - a[axis]);
        Coordinates cut;
        for (std::size_t k = 0; k < 3; ++k) cut[k] = k == axis ? bound : a[k] + t * (b[k] - a[k]);
        kept.push_back(cut);
    }
    return kept;
}

bool any_strictly_inside(const std::vector<Coordinates>& polygon, std::size_t axis, const FT& bound,
                         CGAL::Sign inner) {
    for (const Coordinates& p : polygon) {
        if (CGAL::compare(p[axis], bound) * inner == CGAL::POSITIVE) return true;
    }
    return false;
}

// The clipped polygon is convex and lies in the closed box. It reaches the open box if and only if no side
// of the box contains all of it: the mean of its corners is then off all six sides.
bool convex_meets_open(std::vector<Coordinates> polygon, const osem::Octant& octant) {
    FT bound[3][2];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bound[axis][0] = FT(octant.corner.at[axis]);
        bound[axis][1] = FT(octant.corner.at[axis] + octant.side());
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            const CGAL::Sign inner = high ? CGAL::NEGATIVE : CGAL::POSITIVE;
            if (!any_strictly_inside(polygon, axis, bound[axis][high], inner)) return false;
            polygon = clip(polygon, axis, bound[axis][high], inner);
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!any_strictly_inside(polygon, axis, bound[axis][0], CGAL::POSITIVE)) return false;
        if (!any_strictly_inside(polygon, axis, bound[axis][1], CGAL::NEGATIVE)) return false;
    }
    return true;
}

} // namespace

Point3 exact_point(const osem::Point& p) { return {FT(p.x()), FT(p.y()), FT(p.z())}; }

FacePieces pieces_of(const osem::Solid& solid, std::uint32_t face) {
    const std::vector<RingPoints> rings = rings_of(solid, face);
    if (rings.empty() || rings.front().empty()) throw std::logic_error("a face without corners");
    FacePieces pieces;
    const std::optional<Vector3> normal = normal_of(rings);
    if (normal && rings.size() == 1 && rings.front().size() == 3) {
        const RingPoints& corner = rings.front();
        pieces.triangles.push_back({Triangle3(corner[0], corner[1], corner[2]), 1});
        return pieces;
    }
    for (const RingPoints& ring : rings) add_edges(ring, pieces.segments);
    if (normal) triangulate(rings, *normal, pieces.triangles);
    return pieces;
}

bool meets_open(const Triangle3& triangle, const osem::Octant& octant) {
    return convex_meets_open({coordinates(triangle[0]), coordinates(triangle[1]), coordinates(triangle[2])},
                             octant);
}

bool meets_open(const Segment3& segment, const osem::Octant& octant) {
    return convex_meets_open({coordinates(segment[0]), coordinates(segment[1])}, octant);
}

bool meets_open(const FacePieces& pieces, const osem::Octant& octant) {
    for (const WoundTriangle& triangle : pieces.triangles) {
        if (meets_open(triangle.shape, octant)) return true;
    }
    for (const Segment3& segment : pieces.segments) {
        if (meets_open(segment, octant)) return true;
    }
    return false;
}

} // namespace oracle
