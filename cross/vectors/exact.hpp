// Exact integers and the values of the predicates in them.
#ifndef OSEM_VECTORS_EXACT_HPP
#define OSEM_VECTORS_EXACT_HPP

#include <CGAL/Gmpz.h>

#include <array>
#include <cstdint>
#include <optional>

#include "osem/lattice.hpp"
#include "solids.hpp"

namespace vectors {

using Integer = CGAL::Gmpz;

Integer integer(std::int64_t value);

/// Throws when the integer does not fit.
std::int64_t to_i64(const Integer& value);

/// Twice the signed area of (a, b, q) seen along an axis, the other two axes in ascending order; its sign is
/// that of CGAL's predicate.
std::int64_t area_along_axis(int axis, const osem::Point& a, const osem::Point& b, const osem::Point& q);

/// The same along the diagonal (1, y, z), in the plane of y and z into which the diagonal projects.
std::int64_t area_along_diagonal(int y, int z, const osem::Point& a, const osem::Point& b,
                                 const osem::Point& q);

/// The first corner of a face and the first two others that span its plane with it; nothing when there are
/// none. All by CGAL's predicates.
struct Spanning {
    osem::Point origin, second, third;
};
std::optional<Spanning> spanning(const oracle::Polygon& corners);

/// Six times the signed volume of the spanning corners and q, positive on the side from which they are seen
/// counter-clockwise; its sign is that of CGAL's predicate.
std::int64_t volume(const Spanning& plane, const osem::Point& q);

/// All corners of a solid's faces, ring by ring.
oracle::Polygon corners_of(const oracle::TestSolid& solid);

} // namespace vectors

#endif
