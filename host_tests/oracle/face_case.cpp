#include "face_case.hpp"

#include <algorithm>

namespace oracle {

namespace {

std::int32_t on_lattice(std::int64_t c) {
    return static_cast<std::int32_t>(c < 0 ? 0 : c > osem::root_side ? osem::root_side : c);
}

} // namespace

FaceCase::FaceCase(unsigned seed) : random_(seed) {
    octant_.level = static_cast<std::uint8_t>(below(osem::lattice_bits + 1));
    for (std::int32_t& c : octant_.corner.at) {
        // Often at an end of the root.
        const int last = (1 << octant_.level) - 1;
        const int at = below(4) == 0 ? (below(2) == 0 ? 0 : last) : below(last + 1);
        c = at * octant_.side();
    }
}

std::vector<osem::Octant> FaceCase::octants() const {
    std::vector<osem::Octant> all{octant_};
    if (octant_.level < osem::max_depth) {
        for (unsigned k = 0; k < 8; ++k) all.push_back(octant_.child(k));
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
        osem::Octant next = octant_;
        next.corner.at[axis] += octant_.side();
        if (next.corner.at[axis] < osem::root_side) all.push_back(next);
    }
    return all;
}

TestSolid FaceCase::face() {
    TestSolid solid;
    const int kind = below(16);
    if (kind < 4) {
        solid.add_face(quad());
    } else if (kind < 9) {
        solid.add_face(with_hole());
    } else if (kind < 11) {
        solid.add_face({long_ring()});
    } else if (kind == 11) {
        // There and back: on one plane whatever the corners are, and without an inside.
        const osem::Point middle = near_point();
        solid.add_face({{near_point(), middle, near_point(), middle}});
    } else {
        solid.add_face({{corner(), corner(), corner()}});
    }
    return solid;
}

// Near the octant: on its half-side grid, one off it, anywhere within three sides, or at the root's end.
std::int32_t FaceCase::coordinate(unsigned axis) {
    const std::int64_t low = octant_.corner.at[axis];
    const std::int64_t side = octant_.side();
    const std::int64_t on_grid = low + side / 2 * (below(9) - 3);
    switch (below(8)) {
    case 0:
        return on_lattice(on_grid + below(3) - 1);
    case 1:
        return on_lattice(low + side * (below(3) - 1) + below(static_cast<int>(side)));
    case 2:
        return below(2) == 0 ? 0 : osem::root_side;
    case 3:
        return below(osem::root_side + 1);
    default:
        return on_lattice(on_grid);
    }
}

osem::Point FaceCase::corner() {
    const std::int32_t x = coordinate(0);
    const std::int32_t y = coordinate(1);
    const std::int32_t z = coordinate(2);
    return {{x, y, z}};
}

// origin + i u + j v: on one plane for all i and j. Nothing when it is off the lattice.
struct FaceCase::Span {
    osem::Point origin, u, v;
    bool at(int i, int j, osem::Point& p) const {
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t c =
                std::int64_t{origin.at[axis]} + std::int64_t{i} * u.at[axis] + std::int64_t{j} * v.at[axis];
            if (c < 0 || c > osem::root_side) return false;
            p.at[axis] = static_cast<std::int32_t>(c);
        }
        return true;
    }
};

// In or on the octant, most often on its half-side grid.
osem::Point FaceCase::near_point() {
    osem::Point p = octant_.corner;
    for (std::int32_t& c : p.at) {
        c += below(4) == 0 ? below(octant_.side() + 1) : octant_.side() / 2 * below(3);
    }
    return p;
}

// One step along a plane: from far less than the octant's side to twice as much.
osem::Point FaceCase::step(std::int32_t unit) {
    osem::Point d{};
    for (std::int32_t& c : d.at) c = below(3) == 0 ? below(2 * unit + 1) - unit : unit * (below(5) - 2);
    return d;
}

bool FaceCase::on_span(const std::vector<FlatRing>& rings, const Span& span, std::vector<Polygon>& polygons) {
    polygons.clear();
    for (const FlatRing& ring : rings) {
        Polygon polygon;
        for (const Flat& p : ring) {
            osem::Point q{};
            if (!span.at(p[0], p[1], q)) return false;
            polygon.push_back(q);
        }
        polygons.push_back(std::move(polygon));
    }
    return true;
}

// The rings on random planes until one holds them; a plane through the root's ends if none does.
std::vector<Polygon> FaceCase::laid(const std::vector<FlatRing>& rings) {
    std::vector<Polygon> polygons;
    for (int tries = 0; tries < 20; ++tries) {
        // Some point of the rings' plane, from their first corner to their middle, is near the octant.
        const std::int32_t unit = std::max(1, octant_.side() >> below(5));
        Span span{near_point(), step(unit), step(unit)};
        const int i = below(2) == 0 ? 0 : below(9);
        const int j = below(2) == 0 ? 0 : below(9);
        for (int axis = 0; axis < 3; ++axis) {
            span.origin.at[axis] -= i * span.u.at[axis] + j * span.v.at[axis];
        }
        if (on_span(rings, span, polygons)) return polygons;
    }
    const int unit = osem::root_side / 16;
    on_span(rings, {{{0, 0, 0}}, {{unit, 0, unit}}, {{0, unit, 0}}}, polygons);
    return polygons;
}

std::vector<Polygon> FaceCase::quad() {
    const int cut = 1 + below(3);
    if (below(2) == 0) return laid({{{0, 0}, {4, 0}, {4, cut}, {0, 4}}});
    return laid({{{0, 0}, {4, 0}, {cut, cut}, {0, 4}}}); // concave, or straight at (2, 2)
}

std::vector<Polygon> FaceCase::with_hole() {
    switch (below(4)) {
    case 0:
        return laid({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{2, 2}, {2, 6}, {6, 6}, {6, 2}}});
    case 1:
        return laid({{{0, 0}, {8, 0}, {0, 8}}, {{0, 0}, {1, 4}, {4, 1}}});
    case 2:
        return laid({{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{1, 1}, {4, 4}, {7, 1}}, {{4, 4}, {1, 7}, {7, 7}}});
    default:
        return laid({{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
                     {{1, 1}, {1, 7}, {7, 7}, {7, 1}},
                     {{3, 3}, {5, 3}, {5, 5}, {3, 5}}});
    }
}

// Concave, self-intersecting and spurred rings.
Polygon FaceCase::long_ring() {
    static const std::vector<FlatRing> rings = {
        {{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 2}, {2, 2}, {2, 8}, {0, 8}},
        {{4, 8}, {1, 0}, {8, 5}, {0, 5}, {7, 0}},
        {{0, 0}, {4, 0}, {4, 4}, {8, 6}, {4, 4}, {0, 4}},
        {{0, 0}, {4, 4}, {4, 0}, {0, 4}},
        {{0, 0}, {2, 0}, {8, 0}, {5, 0}},
        {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {6, 0}, {6, 6}, {0, 6}},
    };
    return laid({rings[static_cast<std::size_t>(below(static_cast<int>(rings.size())))]}).front();
}

bool boxes_overlap(const TestSolid& face, const osem::Octant& octant) {
    for (int axis = 0; axis < 3; ++axis) {
        std::int32_t low = osem::root_side;
        std::int32_t high = 0;
        for (const osem::Point& p : face.vertices) {
            low = std::min(low, p.at[axis]);
            high = std::max(high, p.at[axis]);
        }
        const std::int32_t start = octant.corner.at[axis];
        if (high <= start || low >= start + octant.side()) return false;
    }
    return true;
}

} // namespace oracle
