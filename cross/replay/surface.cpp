// Surfaces of octrees: their faces, what they enclose, and how they hang together.
#include "osem/boundary.hpp"

#include "planted_tree.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

constexpr int facings = 6; // 2 * axis of the outward normal + 1 if it points to the positive side

// What a record says of a surface, and what is found, both in squares and cells of the tree's depth.
struct SurfaceTruth {
    std::uint32_t faces[facings];
    std::uint32_t squares[facings];
    std::uint32_t cells;
    std::int32_t euler;
    std::uint32_t vertices; ///< at which three edges or more meet
};

SurfaceTruth read_truth(Reader& reader) {
    SurfaceTruth truth = {};
    for (int facing = 0; facing < facings; ++facing) {
        truth.faces[facing] = reader.u16();
        truth.squares[facing] = reader.u16();
    }
    truth.cells = reader.u32();
    truth.euler = reader.i32();
    truth.vertices = reader.u32();
    return truth;
}

BoundaryOutcome run(Boundary& job, const Octree& tree, SolidPart part, BoundaryCorner* scratch,
                    std::uint32_t size) {
    job.begin(tree, part, scratch, size);
    while (job.step(50)) {
    }
    return job.finish();
}

// Twice a ring's signed area, seen along an axis.
std::int64_t area_of(const Solid& surface, const Ring& ring, int axis) {
    const int u = axis == 2 ? 0 : axis + 1;
    const int v = axis == 0 ? 2 : axis - 1;
    std::int64_t area = 0;
    Point from = surface.vertices[ring.corners[ring.count - 1]];
    for (std::uint32_t i = 0; i < ring.count; ++i) {
        const Point& to = surface.vertices[ring.corners[i]];
        area += std::int64_t{from.at[u]} * to.at[v] - std::int64_t{from.at[v]} * to.at[u];
        from = to;
    }
    return area;
}

// The sums over all faces; the products wrap around, their sum fits.
struct Sums {
    std::uint32_t faces[facings] = {};
    std::int64_t areas[facings] = {}; ///< twice
    std::uint64_t volumes[3] = {};    ///< twice, by the faces across each axis
};

void add_face(const Solid& surface, std::uint32_t face, Sums& sums) {
    const std::uint32_t outer = surface.first_ring(face);
    int axis = 0;
    while (axis < 2 && area_of(surface, surface.ring(outer), axis) == 0) ++axis;
    const int facing = 2 * axis + (area_of(surface, surface.ring(outer), axis) > 0 ? 1 : 0);
    const std::int32_t height = surface.vertices[surface.ring(outer).corners[0]].at[axis];
    ++sums.faces[facing];
    for (std::uint32_t r = outer; r < surface.end_ring(face); ++r) {
        const std::int64_t area = area_of(surface, surface.ring(r), axis);
        sums.areas[facing] += facing % 2 != 0 ? area : -area;
        sums.volumes[axis] += static_cast<std::uint64_t>(height) * static_cast<std::uint64_t>(area);
    }
}

void compare_faces(Report& report, const SurfaceTruth& truth, const Solid& surface, int depth) {
    Sums sums;
    for (std::uint32_t face = 0; face < surface.face_count; ++face) add_face(surface, face, sums);
    const std::int64_t side = root_side >> depth;
    for (int facing = 0; facing < facings; ++facing) {
        report.expect("faces of a side", truth.faces[facing], sums.faces[facing]);
        report.expect("area of a side", 2 * side * side * truth.squares[facing], sums.areas[facing]);
    }
    for (const std::uint64_t volume : sums.volumes) {
        report.expect("volume", 2 * side * side * side * truth.cells, static_cast<std::int64_t>(volume));
    }
}

// A face is a disk with holes, which has the Euler characteristic 2 - rings; every edge has two corners.
void compare_euler(Report& report, const SurfaceTruth& truth, const Solid& surface) {
    report.expect("whether the corners are paired", 0, surface.corner_count % 2);
    report.expect("Euler characteristic", truth.euler,
                  std::int64_t{surface.vertex_count} - surface.corner_count / 2 +
                      2 * std::int64_t{surface.face_count} - surface.ring_count());
}

// Where the edge from each corner leads.
void find_ends(const Solid& surface, std::uint32_t* ends) {
    for (std::uint32_t r = 0; r < surface.ring_count(); ++r) {
        const Ring ring = surface.ring(r);
        std::uint32_t* const to = ends + (ring.corners - surface.corners);
        for (std::uint32_t i = 0; i < ring.count; ++i) to[i] = ring.corners[i + 1 < ring.count ? i + 1 : 0];
    }
}

// Every edge once each way; as many edges at a vertex as corners.
void compare_edges(Report& report, const SurfaceTruth& truth, const Solid& surface,
                   const std::uint32_t* ends) {
    const std::uint32_t* const starts = surface.corners;
    for (std::uint32_t i = 0; i < surface.corner_count; ++i) {
        unsigned along = 0;
        unsigned back = 0;
        for (std::uint32_t j = 0; j < surface.corner_count; ++j) {
            if (starts[j] == starts[i] && ends[j] == ends[i]) ++along;
            if (starts[j] == ends[i] && ends[j] == starts[i]) ++back;
        }
        report.expect("uses of an edge", 1, along);
        report.expect("uses of an edge the other way", 1, back);
    }
    std::uint32_t vertices = 0;
    for (std::uint32_t v = 0; v < surface.vertex_count; ++v) {
        unsigned edges = 0;
        for (std::uint32_t i = 0; i < surface.corner_count; ++i) {
            if (starts[i] == v) ++edges;
        }
        report.expect("at least two edges at a vertex", 1, edges >= 2 ? 1 : 0);
        if (edges > 2) ++vertices;
    }
    report.expect("vertices", truth.vertices, vertices);
}

// A ring has four corners or more.
BoundaryArrays take_arrays(Arena& arena, const BoundarySizes& sizes) {
    return BoundaryArrays{arena.take<Point>(sizes.vertices), arena.take<std::uint32_t>(sizes.corners),
                          arena.take<std::uint32_t>(sizes.corners / 4 + 1),
                          arena.take<std::uint32_t>(sizes.corners / 4 + 1)};
}

void replay_part(Reader& reader, Arena& arena, Report& report, const Octree& tree, SolidPart part) {
    const SurfaceTruth truth = read_truth(reader);
    const ArenaScope scope(arena);
    auto* const job = arena.take<Boundary>(1);
    if (job == nullptr) return report.too_large();
    const BoundaryOutcome counted = run(*job, tree, part, nullptr, 0);
    const BoundaryArrays arrays = take_arrays(arena, counted.sizes);
    auto* const ends = arena.take<std::uint32_t>(counted.sizes.corners);
    const std::uint32_t size = boundary_scratch(counted.sizes.corners);
    auto* const scratch = arena.take<BoundaryCorner>(size);
    if (arrays.vertices == nullptr || arrays.corners == nullptr || arrays.ring_starts == nullptr) {
        return report.too_large();
    }
    if (arrays.face_rings == nullptr || ends == nullptr || scratch == nullptr) return report.too_large();
    report.begin_case();
    const BoundaryOutcome built = run(*job, tree, part, scratch, size);
    report.expect("status of a count", static_cast<int>(Status::ok), static_cast<int>(counted.status));
    report.expect("double edges", 0, built.double_edges);
    // The arrays have the counted sizes.
    const bool as_counted =
        report.expect("vertices counted", counted.sizes.vertices, built.sizes.vertices) &&
        report.expect("corners counted", counted.sizes.corners, built.sizes.corners) &&
        report.expect("few enough rings", 1, built.sizes.rings <= counted.sizes.corners / 4 ? 1 : 0) &&
        report.expect("few enough faces", 1, built.sizes.faces <= built.sizes.rings ? 1 : 0);
    if (!as_counted) return;
    if (!report.expect("status of a surface", static_cast<int>(Status::ok), static_cast<int>(built.status))) {
        return;
    }
    const Solid surface = boundary_solid(*job, arrays);
    compare_faces(report, truth, surface, tree.depth);
    compare_euler(report, truth, surface);
    find_ends(surface, ends);
    compare_edges(report, truth, surface, ends);
}

} // namespace

bool replay_surface(Reader& reader, Arena& arena, Report& report) {
    const PlantedTree planted(reader, arena);
    if (!planted.fits()) return false;
    replay_part(reader, arena, report, planted.tree(), SolidPart::inner);
    replay_part(reader, arena, report, planted.tree(), SolidPart::outer);
    return true;
}

} // namespace osem::cross
