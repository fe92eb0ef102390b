#include "solids.hpp"

#include <algorithm>

namespace oracle {

const Grid aligned_grid{"aligned", {{0, 0, 0}}, 1 << 15};
const Grid crooked_grid{"crooked", {{12347, 54323, 777}}, 29989};
const Grid tiny_grid{"tiny", {{(1 << 19) - 32, 1 << 19, (1 << 18) + 96}}, 1};
const osem::Octant tiny_window{tiny_grid.origin, 15};

std::uint32_t TestSolid::vertex(const osem::Point& p) {
    if (weld) {
        const auto found = std::find(vertices.begin(), vertices.end(), p);
        if (found != vertices.end()) return static_cast<std::uint32_t>(found - vertices.begin());
    }
    vertices.push_back(p);
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

void TestSolid::add_face(const std::vector<Polygon>& rings) {
    for (const Polygon& ring : rings) {
        for (const osem::Point& p : ring) corners.push_back(vertex(p));
        ring_starts.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    face_rings.push_back(static_cast<std::uint32_t>(ring_starts.size() - 1));
}

void TestSolid::add(const TestSolid& other) {
    const osem::Solid solid = other.view_with_tables();
    for (std::uint32_t f = 0; f < solid.face_count; ++f) {
        std::vector<Polygon> rings;
        for (std::uint32_t r = solid.first_ring(f); r < solid.end_ring(f); ++r) {
            const osem::Ring ring = solid.ring(r);
            Polygon polygon;
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                polygon.push_back(solid.vertices[ring.corners[i]]);
            }
            rings.push_back(std::move(polygon));
        }
        add_face(rings);
    }
}

void TestSolid::invert() {
    for (std::size_t r = 0; r + 1 < ring_starts.size(); ++r) {
        std::reverse(corners.begin() + ring_starts[r], corners.begin() + ring_starts[r + 1]);
    }
}

osem::Solid TestSolid::view_with_tables() const {
    return {vertices.data(),
            static_cast<std::uint32_t>(vertices.size()),
            corners.data(),
            static_cast<std::uint32_t>(corners.size()),
            ring_starts.data(),
            face_rings.data(),
            static_cast<std::uint32_t>(face_rings.size() - 1)};
}

osem::Solid TestSolid::view() const {
    osem::Solid solid = view_with_tables();
    for (std::uint32_t f = 0; f < solid.face_count; ++f) {
        if (face_rings[f + 1] != f + 1 || ring_starts[f + 1] != 3 * (f + 1)) return solid;
    }
    solid.ring_starts = nullptr;
    solid.face_rings = nullptr;
    return solid;
}

TestSolid prism(const Grid& grid, osem::Axis axis, const std::vector<FlatRing>& rings, int low, int high) {
    const auto lift = [&](const Flat& p, int level) {
        std::array<int, 3> at{};
        at[axis] = level;
        at[(axis + 1U) % 3] = p[0];
        at[(axis + 2U) % 3] = p[1];
        return grid(at[0], at[1], at[2]);
    };
    TestSolid solid;
    std::vector<Polygon> top;
    std::vector<Polygon> bottom;
    for (const FlatRing& ring : rings) {
        Polygon up;
        Polygon down;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Flat& next = ring[(i + 1) % ring.size()];
            up.push_back(lift(ring[i], high));
            down.push_back(lift(ring[i], low));
            solid.add_face({{lift(ring[i], low), lift(next, low), lift(next, high), lift(ring[i], high)}});
        }
        std::reverse(down.begin(), down.end());
        top.push_back(std::move(up));
        bottom.push_back(std::move(down));
    }
    solid.add_face(top);
    solid.add_face(bottom);
    return solid;
}

TestSolid box(const Grid& grid, std::array<int, 3> low, std::array<int, 3> high) {
    return prism(grid, osem::axis_z,
                 {{{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}}, low[2],
                 high[2]);
}

namespace {

// Six times the signed volume; coordinate differences are below 2^21, so the sum is below 2^66: in double
// only the sign of clearly non-zero values is used, and a flat tetrahedron may be turned either way.
double volume_sign(const osem::Point& a, const osem::Point& b, const osem::Point& c, const osem::Point& d) {
    double m[3][3];
    const osem::Point* ends[3] = {&b, &c, &d};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) m[i][k] = static_cast<double>(ends[i]->at[k] - a.at[k]);
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

} // namespace

TestSolid tetrahedron(const osem::Point& a, const osem::Point& b, const osem::Point& c,
                      const osem::Point& d) {
    TestSolid solid;
    solid.add_face({{a, c, b}});
    solid.add_face({{a, b, d}});
    solid.add_face({{b, c, d}});
    solid.add_face({{c, a, d}});
    if (volume_sign(a, b, c, d) < 0) solid.invert();
    return solid;
}

TestSolid sheared(TestSolid solid, osem::Axis from, osem::Axis to, int p, std::int32_t offset) {
    for (osem::Point& v : solid.vertices) v.at[to] += p * v.at[from] + offset;
    return solid;
}

std::vector<TestSolid> every(std::size_t step, std::vector<TestSolid> solids) {
    std::vector<TestSolid> some;
    for (std::size_t i = step / 2; i < solids.size(); i += step) some.push_back(std::move(solids[i]));
    return some;
}

} // namespace oracle
