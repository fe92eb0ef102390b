#include "support/surface.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace osem::tests {

Surface::Surface(Boundary& job, const Octree& tree, SolidPart part) {
    job.begin(tree, part, nullptr, 0);
    while (job.step(1000)) {
    }
    counted_ = job.finish();
    std::vector<BoundaryCorner> scratch(boundary_scratch(counted_.sizes.corners) + 1);
    job.begin(tree, part, scratch.data(), boundary_scratch(counted_.sizes.corners));
    while (job.step(1000)) {
    }
    built_ = job.finish();
    vertices_.resize(built_.sizes.vertices);
    corners_.resize(built_.sizes.corners);
    ring_starts_.resize(built_.sizes.rings + std::size_t{1});
    face_rings_.resize(built_.sizes.faces + std::size_t{1});
    solid_ =
        boundary_solid(job, {vertices_.data(), corners_.data(), ring_starts_.data(), face_rings_.data()});
}

namespace {

using Cell = std::array<int, 3>;

std::size_t morton(const Cell& cell, int depth) {
    std::size_t index = 0;
    for (int bit = 0; bit < depth; ++bit) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto set = static_cast<std::size_t>((cell[static_cast<std::size_t>(axis)] >> bit) & 1);
            index |= set << (3 * bit + axis);
        }
    }
    return index;
}

bool is_black(const DenseGrid& grid, const Cell& cell) {
    for (const int coordinate : cell) {
        if (coordinate < 0 || coordinate >= 1 << grid.depth()) return false;
    }
    return grid[morton(cell, grid.depth())] == Colour::black;
}

UnitFace unit_face(const Cell& cell, int axis, bool positive) {
    return {cell[0], cell[1], cell[2], axis, positive};
}

bool on_surface(const DenseGrid& solid, Cell cell, int axis, bool positive) {
    if (!is_black(solid, cell)) return false;
    cell[static_cast<std::size_t>(axis)] += positive ? 1 : -1;
    return !is_black(solid, cell);
}

void flood(const DenseGrid& solid, const UnitFace& start, UnitFaces& seen, UnitFaces& face) {
    std::vector<UnitFace> waiting = {start};
    seen.insert(start);
    while (!waiting.empty()) {
        const UnitFace at = waiting.back();
        waiting.pop_back();
        face.insert(at);
        const auto [x, y, z, axis, positive] = at;
        for (int across = 0; across < 3; ++across) {
            for (const int way : {-1, 1}) {
                Cell beside = {x, y, z};
                beside[static_cast<std::size_t>(across)] += way;
                if (across == axis || !on_surface(solid, beside, axis, positive)) continue;
                const UnitFace next = unit_face(beside, axis, positive);
                if (seen.insert(next).second) waiting.push_back(next);
            }
        }
    }
}

const Point& corner_of(const Solid& s, const Ring& ring, std::uint32_t i) {
    return s.vertices[ring.corners[i % ring.count]];
}

// The normal of a face along the axes, as the axis and twice the signed area of its outer ring seen there.
struct Facing {
    int axis = 0;
    std::int64_t area = 0;
};

Facing facing_of(const Solid& s, const Ring& ring) {
    Facing facing;
    for (int axis = 0; axis < 3; ++axis) {
        std::int64_t area = 0;
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const Point& a = corner_of(s, ring, i);
            const Point& b = corner_of(s, ring, i + 1);
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            area += std::int64_t{a.at[u]} * b.at[v] - std::int64_t{b.at[u]} * a.at[v];
        }
        if (area != 0) facing = {axis, area};
    }
    return facing;
}

bool covers(const Solid& s, std::uint32_t face, int axis, const std::array<std::int64_t, 3>& twice_middle) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    bool inside = false;
    for (std::uint32_t r = s.first_ring(face); r < s.end_ring(face); ++r) {
        const Ring ring = s.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            const Point& a = corner_of(s, ring, i);
            const Point& b = corner_of(s, ring, i + 1);
            const std::int64_t mid_u = twice_middle[static_cast<std::size_t>(u)];
            const std::int64_t mid_v = twice_middle[static_cast<std::size_t>(v)];
            if (a.at[u] != b.at[u] || 2 * std::int64_t{a.at[u]} > mid_u) continue;
            const bool spans = 2 * std::int64_t{std::min(a.at[v], b.at[v])} < mid_v &&
                               mid_v < 2 * std::int64_t{std::max(a.at[v], b.at[v])};
            inside = inside != spans;
        }
    }
    return inside;
}

} // namespace

DenseGrid solid_cells(const DenseGrid& grid, SolidPart part) {
    DenseGrid solid = grid;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        if (grid[cell] == Colour::boundary) {
            solid[cell] = part == SolidPart::outer ? Colour::black : Colour::white;
        }
    }
    return solid;
}

std::set<UnitFaces> expected_faces(const DenseGrid& solid) {
    std::set<UnitFaces> faces;
    UnitFaces seen;
    const int cells = 1 << solid.depth();
    for (int i = 0; i < cells * cells * cells; ++i) {
        const Cell cell = {i % cells, i / cells % cells, i / cells / cells};
        for (int side = 0; side < 6; ++side) {
            const UnitFace start = unit_face(cell, side / 2, side % 2 == 1);
            if (!on_surface(solid, cell, side / 2, side % 2 == 1) || seen.count(start) != 0) continue;
            UnitFaces face;
            flood(solid, start, seen, face);
            faces.insert(face);
        }
    }
    return faces;
}

std::set<UnitFaces> covered_faces(const Solid& s, int depth) {
    std::set<UnitFaces> faces;
    const int cells = 1 << depth;
    const std::int32_t side = root_side >> depth;
    for (std::uint32_t face = 0; face < s.face_count; ++face) {
        const Ring outer = s.ring(s.first_ring(face));
        const Facing facing = facing_of(s, outer);
        const bool positive = facing.area > 0;
        const int layer = corner_of(s, outer, 0).at[facing.axis] / side - (positive ? 1 : 0);
        UnitFaces covered;
        for (int i = 0; i < cells * cells; ++i) {
            Cell cell = {};
            cell[static_cast<std::size_t>(facing.axis)] = layer;
            cell[static_cast<std::size_t>((facing.axis + 1) % 3)] = i % cells;
            cell[static_cast<std::size_t>((facing.axis + 2) % 3)] = i / cells;
            std::array<std::int64_t, 3> twice = {};
            for (std::size_t axis = 0; axis < 3; ++axis)
                twice[axis] = std::int64_t{2 * cell[axis] + 1} * side;
            if (covers(s, face, facing.axis, twice)) covered.insert(unit_face(cell, facing.axis, positive));
        }
        faces.insert(covered);
    }
    return faces;
}

namespace {

using IndexEdge = std::pair<std::uint32_t, std::uint32_t>;

// The cell that lies behind both faces of an edge, just beside its start.
Cell cell_behind(const Solid& s, const IndexEdge& edge, const Facing& f, const Facing& g, std::int32_t side) {
    const Point& a = s.vertices[edge.first];
    const Point& b = s.vertices[edge.second];
    Cell cell = {};
    for (int axis = 0; axis < 3; ++axis) {
        std::int32_t at = std::min(a.at[axis], b.at[axis]);
        for (const Facing& facing : {f, g}) {
            if (facing.axis == axis && facing.area > 0) --at;
        }
        cell[static_cast<std::size_t>(axis)] = at >= 0 ? at / side : -1;
    }
    return cell;
}

// Whether a permutation of neighbours is one cycle.
bool is_one_cycle(const std::map<std::uint32_t, std::uint32_t>& next) {
    const std::uint32_t start = next.begin()->first;
    std::size_t length = 0;
    std::uint32_t at = start;
    do {
        const auto found = next.find(at);
        if (found == next.end() || ++length > next.size()) return false;
        at = found->second;
    } while (at != start);
    return length == next.size();
}

} // namespace

::testing::AssertionResult is_manifold(const Solid& s, const DenseGrid& solid) {
    std::map<IndexEdge, Facing> edges;
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> links;
    for (std::uint32_t face = 0; face < s.face_count; ++face) {
        const Facing facing = facing_of(s, s.ring(s.first_ring(face)));
        for (std::uint32_t r = s.first_ring(face); r < s.end_ring(face); ++r) {
            const Ring ring = s.ring(r);
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                const std::uint32_t from = ring.corners[i];
                const std::uint32_t to = ring.corners[(i + 1) % ring.count];
                const std::uint32_t then = ring.corners[(i + 2) % ring.count];
                if (!edges.insert({{from, to}, facing}).second) {
                    return ::testing::AssertionFailure() << "edge " << from << " " << to << " twice";
                }
                if (!links[to].insert({from, then}).second) {
                    return ::testing::AssertionFailure() << "vertex " << to;
                }
            }
        }
    }
    for (const auto& [edge, facing] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        if (opposite == edges.end()) return ::testing::AssertionFailure() << "open edge";
        const Cell cell = cell_behind(s, edge, facing, opposite->second, solid.cell_side());
        if (facing.axis == opposite->second.axis || !is_black(solid, cell)) {
            return ::testing::AssertionFailure() << "faces of different cubes share an edge";
        }
    }
    for (std::uint32_t v = 0; v < s.vertex_count; ++v) {
        if (links[v].size() < 2 || !is_one_cycle(links[v])) {
            return ::testing::AssertionFailure() << "faces around vertex " << v << " are not one cycle";
        }
    }
    return ::testing::AssertionSuccess();
}

// By the divergence of (x, y, z): each face adds its plane's coordinate times its signed area; a third of the
// sum is the volume, and `area` is doubled.
std::int64_t six_volumes(const Solid& s, std::int32_t unit) {
    std::int64_t sum = 0;
    for (std::uint32_t face = 0; face < s.face_count; ++face) {
        for (std::uint32_t r = s.first_ring(face); r < s.end_ring(face); ++r) {
            const Facing facing = facing_of(s, s.ring(r));
            const std::int64_t height = corner_of(s, s.ring(r), 0).at[facing.axis] / unit;
            sum += height * (facing.area / unit / unit);
        }
    }
    return sum;
}

} // namespace osem::tests
