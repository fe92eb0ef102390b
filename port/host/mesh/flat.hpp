// Faces and their planes, and the plane geometry of a face projected along an axis. Everything is exact: a
// projected coordinate has at most 21 bits, so an orientation fits in 64 bits with room for sums of millions.
#ifndef OSEM_HOST_MESH_FLAT_HPP
#define OSEM_HOST_MESH_FLAT_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "osem/solid.hpp"

namespace osem::host {

/// Greatest number of corners of a face: below it Newell's sums stay under 2^41 * 2^21 = 2^62.
constexpr std::uint32_t max_face_corners = std::uint32_t{1} << 21;

struct FlatPoint {
    std::int32_t u;
    std::int32_t v;

    friend bool operator==(const FlatPoint& a, const FlatPoint& b) { return a.u == b.u && a.v == b.v; }
};

/// Twice the signed area of a triangle: positive when a, b, c turn left. Swapping two arguments changes the
/// sign, turning all three around does not.
inline std::int64_t orient(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
    return std::int64_t{b.u - a.u} * (c.v - a.v) - std::int64_t{b.v - a.v} * (c.u - a.u);
}

/// Whether p lies in the bounding box of a and b, border included.
inline bool in_box(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) {
    return (a.u <= p.u || b.u <= p.u) && (p.u <= a.u || p.u <= b.u) && (a.v <= p.v || b.v <= p.v) &&
           (p.v <= a.v || p.v <= b.v);
}

using Normal = std::array<std::int64_t, 3>;

/// Newell's normal of a ring: its components are twice the signed areas of the projections.
Normal newell_normal(const Solid& solid, std::uint32_t ring);

inline std::int64_t magnitude(std::int64_t value) { return value < 0 ? -value : value; }

/// Drops one axis, so that what is counter-clockwise around the normal is so in the projection.
class Projection {
  public:
    /// Along the normal's longest component.
    explicit Projection(const Normal& normal);

    FlatPoint operator()(const Point& p) const { return {p.at[u_], p.at[v_]}; }
    /// The axis dropped.
    int axis() const { return 3 - u_ - v_; }

  private:
    int u_;
    int v_;
};

/// The plane of a face: through the first corner and the first two others that span one with it. A face
/// whose corners are all collinear has the null normal.
class FacePlane {
  public:
    FacePlane(const Solid& solid, std::uint32_t face);

    const Normal& normal() const { return normal_; }
    bool is_null() const { return normal_ == Normal{}; }
    /// n . (p - first corner), at most 3 * 2^61 in magnitude.
    std::int64_t at(const Point& p) const;

  private:
    Point origin_;
    Normal normal_{};
};

/// Whether all corners of a face lie in one plane.
bool is_planar(const Solid& solid, std::uint32_t face);

enum class Side { inside, on, outside };

/// Where a point lies against a polygon, by the even-odd rule.
Side side_of(const std::vector<FlatPoint>& polygon, const FlatPoint& p);

} // namespace osem::host

#endif
