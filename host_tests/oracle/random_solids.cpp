// Random solids, the same in every run.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <random>

#include "solids.hpp"

namespace oracle {

namespace {

using Hull = CGAL::Exact_predicates_inexact_constructions_kernel; // nothing is constructed: doubles are exact

Hull::Point_3 hull_point(const osem::Point& p) { return {p.x(), p.y(), p.z()}; }

bool comes_before(const osem::Point& a, const osem::Point& b) {
    return std::lexicographical_compare(std::begin(a.at), std::end(a.at), std::begin(b.at), std::end(b.at));
}

// Half of the coordinates are even and a quarter multiples of eight, so that corners, edges and faces often
// lie on planes of octants.
int small_coordinate(std::mt19937& random) {
    const int any = static_cast<int>(random() % 33U);
    switch (random() % 4U) {
    case 0:
        return any & ~7;
    case 1:
        return any & ~1;
    default:
        return any;
    }
}

osem::Point small_point(const Grid& grid, std::mt19937& random) {
    const int x = small_coordinate(random);
    const int y = small_coordinate(random);
    const int z = small_coordinate(random);
    return grid(x, y, z);
}

TestSolid soup(const Grid& grid, std::mt19937& random) {
    TestSolid all;
    const auto parts = static_cast<unsigned>(1 + random() % 4U);
    for (unsigned i = 0; i < parts; ++i) {
        const osem::Point a = small_point(grid, random);
        const osem::Point b = small_point(grid, random);
        const osem::Point c = small_point(grid, random);
        const osem::Point d = small_point(grid, random);
        TestSolid part = tetrahedron(a, b, c, d);
        if (random() % 4U == 0) part.invert();
        all.add(part);
    }
    return all;
}

bool collinear(const osem::Point& a, const osem::Point& b, const osem::Point& c) {
    return CGAL::collinear(hull_point(a), hull_point(b), hull_point(c));
}

CGAL::Orientation side(const osem::Point& a, const osem::Point& b, const osem::Point& c,
                       const osem::Point& q) {
    return CGAL::orientation(hull_point(a), hull_point(b), hull_point(c), hull_point(q));
}

// The points' convex hull in their common plane, counter-clockwise seen from the side on which `inner` is
// not: from each corner on to the point that has no other one to its right, the farthest of several.
Polygon wrapped(const Polygon& points, const osem::Point& inner) {
    const auto closer = [](const osem::Point& from, const osem::Point& a, const osem::Point& b) {
        return CGAL::has_smaller_distance_to_point(hull_point(from), hull_point(a), hull_point(b));
    };
    Polygon ring;
    osem::Point at = *std::min_element(points.begin(), points.end(), comes_before);
    do {
        ring.push_back(at);
        osem::Point next = at;
        for (const osem::Point& p : points) {
            const bool is_better =
                next == at || (collinear(at, next, p) ? closer(at, next, p) : side(at, next, p, inner) > 0);
            if (p != at && is_better) next = p;
        }
        at = next;
    } while (at != ring.front());
    return ring;
}

// Whether a, b and c are the first two points and the first one off their line.
bool spans_first(const Polygon& points, const osem::Point& a, const osem::Point& b, const osem::Point& c) {
    const auto off_line = [&](const osem::Point& p) { return !collinear(points[0], points[1], p); };
    return a == points[0] && b == points[1] && c == *std::find_if(points.begin(), points.end(), off_line);
}

// The points on a plane that has all others on one side; nothing when there are points on both.
struct Support {
    Polygon on_plane;
    std::optional<osem::Point> inner;
};

std::optional<Support> support(const Polygon& points, const osem::Point& a, const osem::Point& b,
                               const osem::Point& c) {
    Support support;
    for (const osem::Point& p : points) {
        const CGAL::Orientation where = side(a, b, c, p);
        if (where == CGAL::COPLANAR) {
            support.on_plane.push_back(p);
        } else if (!support.inner) {
            support.inner = p;
        } else if (side(a, b, c, *support.inner) != where) {
            return std::nullopt;
        }
    }
    return support;
}

// The convex hull by trying every plane through three points. (CGAL's convex_hull_3 cuts coplanar faces into
// triangles, and which ones depends on where its memory lies.)
TestSolid hull(const Grid& grid, std::mt19937& random) {
    Polygon points;
    const auto count = static_cast<unsigned>(6 + random() % 20U);
    for (unsigned i = 0; i < count; ++i) points.push_back(small_point(grid, random));
    std::sort(points.begin(), points.end(), comes_before);
    points.erase(std::unique(points.begin(), points.end()), points.end());

    TestSolid solid;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                if (collinear(points[i], points[j], points[k])) continue;
                const auto face = support(points, points[i], points[j], points[k]);
                // Each plane once: by the first three of its points that span it.
                if (face && face->inner && spans_first(face->on_plane, points[i], points[j], points[k])) {
                    solid.add_face({wrapped(face->on_plane, *face->inner)});
                }
            }
        }
    }
    return solid;
}

} // namespace

std::vector<TestSolid> random_solids(const Grid& grid, unsigned count, unsigned seed) {
    std::vector<TestSolid> solids;
    for (unsigned i = 0; i < count; ++i) {
        std::mt19937 random(seed + i);
        solids.push_back(i % 2 == 0 ? soup(grid, random) : hull(grid, random));
        solids.back().name = (i % 2 == 0 ? "soup of seed " : "hull of seed ") + std::to_string(seed + i);
    }
    return solids;
}

} // namespace oracle
