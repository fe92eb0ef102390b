#include "exact.hpp"

#include <CGAL/determinant.h>

#include <stdexcept>

#include "exact_face.hpp"

namespace vectors {

namespace {

const Integer two_to_32 = Integer(65536) * Integer(65536);

Integer difference(const osem::Point& a, const osem::Point& b, int axis) {
    return integer(a.at[axis]) - integer(b.at[axis]);
}

oracle::Exact::Point_2 seen_along(int axis, const osem::Point& p) {
    const int u = axis == 0 ? 1 : 0;
    const int v = axis == 2 ? 1 : 2;
    return {p.at[u], p.at[v]};
}

void confirm(const Integer& value, CGAL::Orientation orientation) {
    if (CGAL::sign(value) != orientation) throw std::logic_error("value and predicate have different signs");
}

} // namespace

Integer integer(std::int64_t value) {
    const auto high = static_cast<std::int32_t>(value >> 32);
    const auto low = static_cast<std::uint32_t>(value);
    return Integer(static_cast<int>(high)) * two_to_32 + Integer(static_cast<unsigned long>(low));
}

std::int64_t to_i64(const Integer& value) {
    const bool negative = value < 0;
    const Integer magnitude = negative ? Integer(-value) : value;
    const Integer high = magnitude / two_to_32;
    if (high >= two_to_32 / 2) throw std::logic_error("a value past 63 bits");
    const auto bits = static_cast<std::int64_t>(CGAL::to_double(high)) * (std::int64_t{1} << 32) +
                      static_cast<std::int64_t>(CGAL::to_double(Integer(magnitude - high * two_to_32)));
    return negative ? -bits : bits;
}

std::int64_t area_along_axis(int axis, const osem::Point& a, const osem::Point& b, const osem::Point& q) {
    const int u = axis == 0 ? 1 : 0;
    const int v = axis == 2 ? 1 : 2;
    const Integer value = CGAL::determinant(difference(b, a, u), difference(b, a, v), //
                                            difference(q, a, u), difference(q, a, v));
    confirm(value, CGAL::orientation(seen_along(axis, a), seen_along(axis, b), seen_along(axis, q)));
    return to_i64(value);
}

std::int64_t area_along_diagonal(int y, int z, const osem::Point& a, const osem::Point& b,
                                 const osem::Point& q) {
    const oracle::Exact::Vector_3 way(1, y, z);
    const Integer value = CGAL::determinant(Integer(1), Integer(y), Integer(z), //
                                            difference(a, q, 0), difference(a, q, 1), difference(a, q, 2),
                                            difference(b, q, 0), difference(b, q, 1), difference(b, q, 2));
    const oracle::Point3 from = oracle::exact_point(q);
    confirm(value, CGAL::orientation(way, oracle::exact_point(a) - from, oracle::exact_point(b) - from));
    return to_i64(value);
}

std::optional<Spanning> spanning(const oracle::Polygon& corners) {
    const osem::Point& origin = corners.front();
    std::size_t second = 1;
    while (second < corners.size() && corners[second] == origin) ++second;
    for (std::size_t third = second + 1; third < corners.size(); ++third) {
        if (!CGAL::collinear(oracle::exact_point(origin), oracle::exact_point(corners[second]),
                             oracle::exact_point(corners[third]))) {
            return Spanning{origin, corners[second], corners[third]};
        }
    }
    return std::nullopt;
}

std::int64_t volume(const Spanning& plane, const osem::Point& q) {
    const osem::Point& o = plane.origin;
    Integer m[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        m[0][axis] = difference(plane.second, o, axis);
        m[1][axis] = difference(plane.third, o, axis);
        m[2][axis] = difference(q, o, axis);
    }
    const Integer value =
        CGAL::determinant(m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]);
    confirm(value, CGAL::orientation(oracle::exact_point(o), oracle::exact_point(plane.second),
                                     oracle::exact_point(plane.third), oracle::exact_point(q)));
    return to_i64(value);
}

oracle::Polygon corners_of(const oracle::TestSolid& solid) {
    oracle::Polygon corners;
    for (const std::uint32_t corner : solid.corners) corners.push_back(solid.vertices[corner]);
    return corners;
}

} // namespace vectors
