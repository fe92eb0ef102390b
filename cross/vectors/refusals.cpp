#include "refusals.hpp"

#include "broken_solids.hpp"
#include "directed_edges.hpp"
#include "random.hpp"
#include "sources.hpp"

namespace vectors {

namespace {

using oracle::TestSolid;
using osem::Status;

void add(VectorFile& file, const osem::Solid& solid, Status status, std::size_t place) {
    Bytes body;
    body.solid(solid);
    body.u8(static_cast<std::uint64_t>(status));
    body.u32(place);
    body.u8(0); // nothing to convert
    file.tally().count(status != Status::ok, reaches_end(solid));
    file.add_record(std::move(body));
}

// Planes face by face, then the edges: what is left to go wrong once tables and numbers are in order.
void add_judged(VectorFile& file, const osem::Solid& solid) {
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        if (!oracle::is_planar(solid, face)) return add(file, solid, Status::face_not_planar, face);
    }
    const bool closed = oracle::DirectedEdges(solid).closed();
    add(file, solid, closed ? Status::ok : Status::surface_not_closed, 0);
}

void add_changed_faces(VectorFile& file, const TestSolid& solid, Random& random) {
    const int faces = static_cast<int>(solid.view().face_count);
    for (const bool turned : {false, true}) {
        const auto changed = static_cast<std::uint32_t>(random.below(faces));
        add_judged(file, oracle::rebuilt(solid, changed, turned).view());
    }
}

void add_moved_vertices(VectorFile& file, const TestSolid& solid, Random& random) {
    const int count = static_cast<int>(solid.vertices.size());
    const auto vertex = static_cast<std::size_t>(random.below(count));
    TestSolid moved = solid;
    std::int32_t& coordinate = moved.vertices[vertex].at[random.below(3)];
    const std::int32_t before = coordinate;
    coordinate += coordinate < osem::root_side ? 1 : -1;
    add_judged(file, moved.view());
    constexpr std::int32_t off[] = {-1, osem::root_side + 1, INT32_MIN, INT32_MAX};
    coordinate = off[random.below(4)];
    add(file, moved.view(), Status::coordinate_off_lattice, vertex);
    coordinate = before;
}

void add_bad_tables(VectorFile& file, const TestSolid& solid, Random& random) {
    TestSolid broken = solid;
    const auto corner = static_cast<std::size_t>(random.below(static_cast<int>(solid.corners.size())));
    broken.corners[corner] = static_cast<std::uint32_t>(solid.vertices.size());
    add(file, broken.view(), Status::index_out_of_range, corner);

    broken = solid;
    const std::size_t rings = solid.ring_starts.size() - 1;
    const auto ring = static_cast<std::size_t>(random.below(static_cast<int>(rings)));
    broken.ring_starts[ring + 1] = broken.ring_starts[ring] + 2;
    add(file, broken.view_with_tables(), Status::ring_too_short, ring);

    broken = solid;
    broken.ring_starts[rings] = broken.ring_starts[rings - 1] - 1;
    add(file, broken.view_with_tables(), Status::ring_table_invalid, 0);
    broken.ring_starts[rings] = solid.ring_starts[rings] + 1;
    add(file, broken.view_with_tables(), Status::ring_table_invalid, 0);
    broken = solid;
    broken.face_rings.push_back(static_cast<std::uint32_t>(rings));
    add(file, broken.view_with_tables(), Status::ring_table_invalid, 0);
}

} // namespace

void add_refusals(VectorFile& file) {
    Random random(16);
    for (const oracle::Grid* grid : {&oracle::crooked_grid, &oracle::aligned_grid}) {
        for (const TestSolid& solid : oracle::every(2, all_solids(*grid, 16, 5000))) {
            add_changed_faces(file, solid, random);
            add_moved_vertices(file, solid, random);
            add_bad_tables(file, solid, random);
        }
    }
    for (const char* open : {"pig", "patch-01"}) {
        const oracle::TriangleMesh mesh = real_mesh(open, oracle::whole_root);
        add_judged(file, mesh.view());
    }
}

} // namespace vectors
