// Rings as seen along a line.
#ifndef OSEM_GEOMETRY_SIGHT_HPP
#define OSEM_GEOMETRY_SIGHT_HPP

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem {

/// A line of sight: from a point along an axis, leaning by at most 2 units along each of the other two axes,
/// u and v in ascending order, for every unit of the way. So it runs along an axis or a diagonal of a cube,
/// or of a cube halved along one or two axes. Points are seen in the plane of u and v, projected along the
/// line; the line itself is seen as the origin.
class Sight {
  public:
    using Lean = Bounded<-2, 2>;
    using Distance = decltype(VertexCoordinate::claim(0) - QueryCoordinate::claim(0));
    using Offset = decltype(Distance::claim(0) - Lean::claim(0) * Distance::claim(0));

    /// A point as it is seen.
    struct Seen {
        Offset u;
        Offset v;
    };

    explicit Sight(const Point& from, Axis along, int lean_u = 0, int lean_v = 0)
        : from_(from), along_(along), u_(along == axis_x ? axis_y : axis_x),
          v_(along == axis_z ? axis_y : axis_z), lean_u_(Lean::claim(lean_u)), lean_v_(Lean::claim(lean_v)) {}

    Seen see(const Point& vertex) const {
        const Distance way = ahead(vertex, along_);
        return {ahead(vertex, u_) - lean_u_ * way, ahead(vertex, v_) - lean_v_ * way};
    }

  private:
    Distance ahead(const Point& vertex, Axis axis) const {
        return VertexCoordinate::claim(vertex.at[axis]) - QueryCoordinate::claim(from_.at[axis]);
    }

    Point from_;
    Axis along_;
    Axis u_;
    Axis v_;
    Lean lean_u_;
    Lean lean_v_;
};

/// Which way one turns, standing on the line of sight, from looking at a to looking at b: positive to the
/// left, u being to the right and v ahead. Antisymmetric. Below 2^45 in magnitude, as its type says.
inline auto turn(const Sight::Seen& a, const Sight::Seen& b) { return a.u * b.v - a.v * b.u; }

/// How often the rings [first, end) wind around the line of sight moved by (e, e^2) in u and v for an
/// infinitesimal e > 0. No ring is on the moved line. Cost: O(corners of the rings).
std::int32_t winding_of_rings(const Solid& solid, std::uint32_t first, std::uint32_t end, const Sight& sight);

} // namespace osem

#endif
