// Triangulation: the boundary stays, and a planar face is covered exactly once.
#include "mesh/triangulate.hpp"

#include <gtest/gtest.h>

#include <random>

#include "builders.hpp"

namespace osem::host {
namespace {

struct Face : FaceTable {
    std::vector<Point> vertices;
    Solid view() const {
        return {vertices.data(),    static_cast<std::uint32_t>(vertices.size()),
                corners.data(),     static_cast<std::uint32_t>(corners.size()),
                ring_starts.data(), face_rings.data(),
                face_count()};
    }
};

using Vector = std::array<std::int64_t, 3>;

Vector doubled_area(const Point& a, const Point& b, const Point& c) {
    Vector area{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        area[axis] = std::int64_t{b.at[u] - a.at[u]} * (c.at[v] - a.at[v]) -
                     std::int64_t{b.at[v] - a.at[v]} * (c.at[u] - a.at[u]);
    }
    return area;
}

Chain boundary_of(const std::vector<Triangle>& triangles) {
    Chain chain;
    for (const Triangle& triangle : triangles) add_ring_edges(chain, triangle.data(), 3);
    return chain;
}

// No triangle turned over and the areas adding up to the face's: with the boundary being the face's, every
// point of the face is then covered once, since it is covered as often as the rings wind around it.
void expect_exact_cover(const Face& face, const Vector& area, std::size_t axis) {
    const auto triangles = triangulate_face(face.view(), 0);
    EXPECT_EQ(boundary_of(triangles), boundary(face.view()));
    const std::int64_t sign = area[axis] < 0 ? -1 : 1;
    Vector sum{};
    for (const Triangle& t : triangles) {
        const Vector part = doubled_area(face.vertices[t[0]], face.vertices[t[1]], face.vertices[t[2]]);
        EXPECT_GE(sign * part[axis], 0);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += part[i];
    }
    EXPECT_EQ(sum, area);
}

using Cell = std::pair<int, int>;

// The boundary of a set of grid cells, cells on the left: outlines and holes at once, which touch wherever
// two cells meet at a corner only. There the way on is chosen at random.
std::vector<std::vector<Cell>> trace(const std::map<Cell, bool>& filled, std::mt19937& random) {
    const auto is_filled = [&](int x, int y) { return filled.count({x, y}) != 0; };
    std::multimap<Cell, Cell> edges;
    for (const auto& entry : filled) {
        const auto [x, y] = entry.first;
        if (!is_filled(x, y - 1)) edges.insert({{x, y}, {x + 1, y}});
        if (!is_filled(x + 1, y)) edges.insert({{x + 1, y}, {x + 1, y + 1}});
        if (!is_filled(x, y + 1)) edges.insert({{x + 1, y + 1}, {x, y + 1}});
        if (!is_filled(x - 1, y)) edges.insert({{x, y + 1}, {x, y}});
    }
    std::vector<std::vector<Cell>> rings;
    while (!edges.empty()) {
        std::vector<Cell> ring;
        Cell at = edges.begin()->first;
        const Cell start = at;
        do {
            auto edge = edges.lower_bound(at);
            if (edges.count(at) == 2 && random() % 2 == 0) ++edge;
            ring.push_back(at);
            at = edge->second;
            edges.erase(edge);
        } while (at != start);
        rings.push_back(ring);
    }
    return rings;
}

bool is_straight(const Cell& a, const Cell& b, const Cell& c) {
    return (b.first - a.first) * (c.second - b.second) == (b.second - a.second) * (c.first - b.first);
}

// Rings of cells as a face in the plane origin + x a + y b. Straight corners go in some rings, so that other
// rings then touch edges between corners.
Face face_of(const std::vector<std::vector<Cell>>& rings, const Vector& a, const Vector& b,
             std::mt19937& random) {
    Face face;
    std::map<Cell, std::uint32_t> numbers;
    for (const auto& ring : rings) {
        const bool simplify = random() % 2 == 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Cell& previous = ring[(i + ring.size() - 1) % ring.size()];
            if (simplify && is_straight(previous, ring[i], ring[(i + 1) % ring.size()])) continue;
            const auto [entry, added] =
                numbers.emplace(ring[i], static_cast<std::uint32_t>(face.vertices.size()));
            if (added) {
                Point p{};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    p.at[axis] = static_cast<std::int32_t>((1 << 19) + ring[i].first * a[axis] +
                                                           ring[i].second * b[axis]);
                }
                face.vertices.push_back(p);
            }
            face.corners.push_back(entry->second);
        }
        face.end_ring();
    }
    face.end_face();
    return face;
}

TEST(Triangulate, RandomPolygonsWithHolesThatTouch) {
    for (unsigned seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int size = 2 + static_cast<int>(seed % 11);
        std::map<Cell, bool> filled;
        for (int x = 0; x < size; ++x) {
            for (int y = 0; y < size; ++y) {
                if (random() % 8 < 3 + seed % 5) filled[{x, y}] = true;
            }
        }
        if (filled.empty()) continue;
        const auto step = [&] { return static_cast<std::int64_t>(random() % 2001) - 1000; };
        Vector a{step(), step(), step()};
        Vector b{step(), step(), step()};
        if (seed % 4 == 0) { // axis-parallel, so that many corners have a coordinate in common
            a = {7, 0, 0};
            b = {0, 7, 0};
        }
        const Point o{{0, 0, 0}};
        const auto point = [](const Vector& v) {
            return Point{{static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]),
                          static_cast<std::int32_t>(v[2])}};
        };
        Vector area = doubled_area(o, point(a), point(b));
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            if (std::abs(area[i]) > std::abs(area[axis])) axis = i;
        }
        if (area[axis] == 0) continue;
        for (auto& component : area) component *= 2 * static_cast<std::int64_t>(filled.size());
        expect_exact_cover(face_of(trace(filled, random), a, b, random), area, axis);
    }
}

// A star-shaped ring around a centre, counter-clockwise or clockwise, with the twice-signed area.
std::int64_t add_star(Face& face, std::int32_t x, std::int32_t y, std::int32_t reach, bool hole,
                      std::mt19937& random) {
    // Directions in ascending angle, each from a different octant boundary, so that the ring is simple.
    const int directions[16][2] = {{4, 0},  {4, 1},   {3, 3},   {1, 4},   {0, 4},  {-1, 4}, {-3, 3}, {-4, 1},
                                   {-4, 0}, {-4, -1}, {-3, -3}, {-1, -4}, {0, -4}, {1, -4}, {3, -3}, {4, -1}};
    const auto first = static_cast<std::uint32_t>(face.vertices.size());
    for (const auto& d : directions) {
        const auto r = static_cast<std::int32_t>(1 + random() % static_cast<unsigned>(reach));
        face.vertices.push_back({{x + r * d[0], y + r * d[1], 5}});
    }
    std::int64_t area = 0;
    for (std::uint32_t i = 0; i < 16; ++i) {
        const std::uint32_t k = first + (i + 1) % 16;
        area += doubled_area(Point{{x, y, 5}}, face.vertices[first + i], face.vertices[k])[2];
        face.corners.push_back(hole ? first + 15 - i : first + i);
    }
    face.end_ring();
    return hole ? -area : area;
}

TEST(Triangulate, RandomStarsInAFrame) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        Face face;
        face.vertices = std::vector<Point>{{{0, 0, 5}}, {{1000, 0, 5}}, {{1000, 1000, 5}}, {{0, 1000, 5}}};
        face.corners = {0, 1, 2, 3};
        face.end_ring();
        std::int64_t area = 2 * 1000 * 1000;
        for (std::int32_t x = 50; x < 1000; x += 100) {
            for (std::int32_t y = 50; y < 1000; y += 100) {
                if (random() % 3 != 0) area += add_star(face, x, y, 12, true, random);
            }
        }
        face.end_face();
        expect_exact_cover(face, {0, 0, area}, 2);
    }
}

TEST(Triangulate, KeyholeRingCoversWithoutItsSlit) {
    Face face; // a square with a square hole, joined by the slit 0 - 4 in one ring
    face.vertices = std::vector<Point>{{{0, 0, 0}},   {{30, 0, 0}},  {{30, 30, 0}}, {{0, 30, 0}},
                                       {{10, 10, 0}}, {{10, 20, 0}}, {{20, 20, 0}}, {{20, 10, 0}}};
    face.corners = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
    face.end_ring();
    face.end_face();
    expect_exact_cover(face, {0, 0, 2 * (900 - 100)}, 2);
}

TEST(Triangulate, CollinearCornersStay) {
    Face face;
    face.vertices = std::vector<Point>{{{0, 0, 0}}, {{10, 0, 0}}, {{20, 0, 0}}, {{30, 0, 0}}, {{30, 30, 0}}};
    face.corners = {0, 1, 2, 3, 4};
    face.end_ring();
    face.end_face();
    const auto triangles = triangulate_face(face.view(), 0);
    EXPECT_EQ(triangles.size(), 3U); // corners - 2
    expect_exact_cover(face, {0, 0, 900}, 2);
}

TEST(Triangulate, CollinearFaceKeepsItsBoundary) {
    Face face; // no area: there and back over four points
    face.vertices = std::vector<Point>{{{0, 0, 0}}, {{10, 20, 30}}, {{20, 40, 60}}, {{40, 80, 120}}};
    face.corners = {0, 3, 1, 2};
    face.end_ring();
    face.end_face();
    EXPECT_EQ(boundary_of(triangulate_face(face.view(), 0)), boundary(face.view()));
}

// Rings that wind anyhow, cross and are not planar: nothing is asked of the shape, but the boundary stays.
TEST(Triangulate, AnyRingsKeepTheirBoundary) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const unsigned reach = seed % 2 == 0 ? 4 : 1 << 20;
        std::map<std::array<std::int32_t, 3>, std::uint32_t> numbers;
        Face face;
        for (unsigned ring = 0; ring < 1 + seed % 4; ++ring) {
            const std::size_t start = face.corners.size();
            const std::size_t count = 3 + random() % 30;
            while (face.corners.size() < start + count) {
                Point p{};
                for (auto& c : p.at) c = static_cast<std::int32_t>(random() % (reach + 1));
                const auto [entry, added] =
                    numbers.emplace(std::array<std::int32_t, 3>{p.at[0], p.at[1], p.at[2]},
                                    static_cast<std::uint32_t>(face.vertices.size()));
                if (added) face.vertices.push_back(p);
                const bool last = face.corners.size() + 1 == start + count;
                if (face.corners.size() > start && face.corners.back() == entry->second) continue;
                if (last && face.corners[start] == entry->second) continue;
                face.corners.push_back(entry->second);
            }
            face.end_ring();
        }
        face.end_face();
        const auto triangles = triangulate_face(face.view(), 0);
        EXPECT_EQ(boundary_of(triangles), boundary(face.view()));
        for (const Triangle& t : triangles) EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    }
}

} // namespace
} // namespace osem::host
