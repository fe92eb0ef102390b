// The plane of a face.
#ifndef OSEM_GEOMETRY_PLANE_HPP
#define OSEM_GEOMETRY_PLANE_HPP

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

inline VertexDifference difference(const Point& a, const Point& b, int axis) {
    return VertexCoordinate::claim(a.at[axis]) - VertexCoordinate::claim(b.at[axis]);
}

/// The plane through a face's first corner and the first two others that span one. The normal is the cross
/// product of two differences of vertices, so its components are below 2^41 whatever the face looks like
/// (Newell's sum over a long ring would not be), but at a reflex corner it points the other way: every use
/// below is indifferent to the normal's sign. A face whose corners are collinear has the null normal.
class Plane {
  public:
    Plane(const Solid& solid, std::uint32_t face)
        : Plane(solid, solid.corners + solid.first_corner(solid.first_ring(face)),
                solid.corners + solid.first_corner(solid.end_ring(face))) {}

    /// The same for the face whose corners are [corner, end).
    Plane(const Solid& solid, const std::uint32_t* corner, const std::uint32_t* end)
        : Plane(solid.vertices[*corner]) {
        const Point* second = nullptr;
        for (++corner; corner != end && is_null(); ++corner) {
            const Point& p = solid.vertices[*corner];
            if (second == nullptr) {
                if (p != origin_) second = &p;
            } else {
                for (int axis = 0; axis < 3; ++axis) normal_[axis] = cross(*second, p, axis);
            }
        }
    }

    /// With the null normal.
    explicit Plane(const Point& origin)
        : origin_(origin), normal_{NormalComponent::claim(0), NormalComponent::claim(0),
                                   NormalComponent::claim(0)} {}

    bool is_null() const {
        return normal_[0].value() == 0 && normal_[1].value() == 0 && normal_[2].value() == 0;
    }

    NormalComponent normal(int axis) const { return normal_[axis]; }

    /// n . (q - first corner); its sign tells the side. Below 3 * 2^61 + 3 * 2^41 in magnitude, as its type
    /// says.
    PlaneValue at(const Point& q) const {
        return normal_[0] * offset(q, 0) + normal_[1] * offset(q, 1) + normal_[2] * offset(q, 2);
    }

  private:
    NormalComponent cross(const Point& a, const Point& b, int axis) const {
        const int u = axis == 2 ? 0 : axis + 1;
        const int v = axis == 0 ? 2 : axis - 1;
        return difference(a, origin_, u) * difference(b, origin_, v) -
               difference(a, origin_, v) * difference(b, origin_, u);
    }

    QueryDifference offset(const Point& q, int axis) const {
        return QueryCoordinate::claim(q.at[axis]) - VertexCoordinate::claim(origin_.at[axis]);
    }

    Point origin_;
    NormalComponent normal_[3];
};

} // namespace osem

#endif
