// A face taken apart exactly: the triangles and segments that it consists of, over CGAL's exact kernel.
//
// Nothing here shares an idea with the kernel under test: faces are triangulated, pieces are clipped, and
// coordinates are rational numbers of any length.
#ifndef OSEM_ORACLE_EXACT_FACE_HPP
#define OSEM_ORACLE_EXACT_FACE_HPP

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <vector>

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace oracle {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = Exact::FT;
using Point3 = Exact::Point_3;
using Triangle3 = Exact::Triangle_3;
using Segment3 = Exact::Segment_3;

/// A triangle that the face's rings wind around `winding` times, counter-clockwise seen from the side that
/// the triangle's own normal points to. Never 0.
struct WoundTriangle {
    Triangle3 shape;
    int winding;
};

/// A face as a set of points: the union of its triangles and segments.
struct FacePieces {
    std::vector<WoundTriangle> triangles;
    std::vector<Segment3> segments; ///< ring edges that no triangle is sure to contain
};

Point3 exact_point(const osem::Point& p);

/// Takes a planar face apart. A face whose corners are all on one line has segments only.
FacePieces pieces_of(const osem::Solid& solid, std::uint32_t face);

/// Whether the piece shares a point with the open octant.
bool meets_open(const Triangle3& triangle, const osem::Octant& octant);
bool meets_open(const Segment3& segment, const osem::Octant& octant);

/// Whether any piece of the face does.
bool meets_open(const FacePieces& pieces, const osem::Octant& octant);

} // namespace oracle

#endif
