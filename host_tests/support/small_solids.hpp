// Small solids that own their arrays: boxes, octahedra, single faces with holes.
#ifndef OSEM_SUPPORT_SMALL_SOLIDS_HPP
#define OSEM_SUPPORT_SMALL_SOLIDS_HPP

#include <cstdint>
#include <vector>

#include "osem/convert.hpp"
#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem::tests {

using Polygon = std::vector<Point>; ///< a ring by its corners

/// Faces with ring tables. Every ring has vertices of its own: a surface need not be welded.
class SmallSolid {
  public:
    void add_face(const std::vector<Polygon>& rings);
    /// Adds what another solid has.
    void add(const SmallSolid& other);

    /// The same faces in another order, each ring starting at another corner.
    SmallSolid shuffled(std::uint32_t seed) const;
    /// The same faces seen from the other side.
    SmallSolid inverted() const;
    /// The same surface cut into triangles, as a mesh without ring tables. Precondition: convex faces.
    SmallSolid triangulated() const;

    const std::vector<std::vector<Polygon>>& faces() const { return faces_; }
    std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }
    Solid view() const;
    /// For faces that are no surface, and solids known to be good.
    CheckedSolid vouched() const { return CheckedSolid::vouched(view()); }
    /// The solid, which has to pass the kernel's check.
    CheckedSolid checked() const;

  private:
    std::vector<std::vector<Polygon>> faces_;
    bool mesh_ = false;
    std::vector<Point> vertices_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> ring_starts_{0};
    std::vector<std::uint32_t> face_rings_{0};
};

/// Converts in one call, with scratch of exactly the stated size.
TreeOutcome converted(const SmallSolid& solid, const ConvertOptions& options, NodePool* pool);

/// An axis-parallel box, and how its surface is oriented: +1 outwards, -1 inwards.
struct Box {
    Point low;
    Point high;
    int winding = 1;
};

SmallSolid box_solid(const Box& box);
SmallSolid boxes_solid(const std::vector<Box>& boxes);

/// The colour of a cell by interval arithmetic: whether a surface meets the open cell, else by the number of
/// times the boxes wind around it.
Colour box_colour(const std::vector<Box>& boxes, WindingRule rule, const Point& corner, std::int32_t side);

/// Black or white by the cell's centre moved by (e, e^2, e^3): a box holds its low sides, not its high ones.
Colour box_centre_colour(const std::vector<Box>& boxes, WindingRule rule, const Point& corner,
                         std::int32_t side);

/// A box with a square tunnel along an axis from side to side: two of its faces have a hole.
struct Tunnel {
    Box outer;
    Box inner; ///< strictly inside the outer one across the axis; its extent along the axis does not count
    int axis;
};

SmallSolid tunnel_solid(const Tunnel& tunnel);
Colour tunnel_colour(const Tunnel& tunnel, const Point& corner, std::int32_t side);
Colour tunnel_centre_colour(const Tunnel& tunnel, const Point& corner, std::int32_t side);

/// The points at most `radius` from the centre, distances along the axes added up.
struct Octahedron {
    Point centre;
    std::int32_t radius;
};

SmallSolid octahedron_solid(const Octahedron& octahedron);
Colour octahedron_colour(const Octahedron& octahedron, const Point& corner, std::int32_t side);
Colour octahedron_centre_colour(const Octahedron& octahedron, const Point& corner, std::int32_t side);

/// A prism along an axis with a square on its tip as its base: distances along the other two axes added up
/// are at most `radius`. Its slanted sides are parallel to an axis.
struct Diamond {
    Point centre; ///< its coordinate along the axis does not count
    std::int32_t radius;
    int axis;
    std::int32_t low;
    std::int32_t high;
};

SmallSolid diamond_solid(const Diamond& diamond);
Colour diamond_colour(const Diamond& diamond, const Point& corner, std::int32_t side);
Colour diamond_centre_colour(const Diamond& diamond, const Point& corner, std::int32_t side);

/// A ball of so many triangles along each edge of an octahedron, with dents. Its corners are rounded to
/// multiples of a number: the greater it is, the more of them lie on octants' borders.
SmallSolid dented_ball(int edge, std::int32_t rounded_to);

} // namespace osem::tests

#endif
