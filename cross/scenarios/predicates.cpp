// Scenarios of what comes before a tree: mapping, checking, classifying.
#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

std::uint64_t frame_mapping() {
    Digest digest;
    Random random(11);
    for (int i = 0; i < 4000; ++i) {
        Frame frame = {};
        WorldPoint world = {};
        frame.shift = static_cast<std::int8_t>(random.below(54) - 32); // one past either end of the range
        // Most often a point near the frame.
        const int spread = random.below(31);
        for (int axis = 0; axis < 3; ++axis) {
            frame.origin[axis] = random.below(1 << 20) * 2048 - (1 << 30);
            world.at[axis] = frame.origin[axis] + (random.below(1 << 20) >> (spread < 20 ? spread : 0));
        }
        Point lattice = {};
        const FrameOutcome there = to_lattice(frame, &world, 1, &lattice);
        digest.add(there.status);
        if (there.status != Status::ok) continue;
        WorldPoint back = {};
        digest.add(to_world(frame, lattice, back));
        for (int axis = 0; axis < 3; ++axis) {
            digest.add(lattice.at[axis]);
            digest.add(back.at[axis]);
        }
    }
    return digest.value();
}

namespace {

// Every face against every octant that one of its corners lies in or next to, level by level.
void add_decisions(Digest& digest, const Solid& solid) {
    const CheckedSolid checked = CheckedSolid::vouched(solid);
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint8_t level = 0; level < 20; level = static_cast<std::uint8_t>(level + 3)) {
            for (std::uint32_t v = 0; v < solid.vertex_count; ++v) {
                const std::int32_t side = root_side >> level;
                Octant octant = {solid.vertices[v], level};
                for (std::int32_t& c : octant.corner.at) c &= -side;
                const Decision decision = classify(checked, face, octant);
                digest.add(decision.stage);
                digest.add(decision.meets);
            }
        }
    }
}

} // namespace

std::uint64_t classified_faces() {
    Digest digest;
    add_decisions(digest, plate());
    add_decisions(digest, octahedron());
    add_decisions(digest, nested_shells());
    add_decisions(digest, tetrahedra(5, Point{{0, 0, 0}}, root_side));
    return digest.value();
}

namespace {

void add_outcome(Digest& digest, const Solid& solid) {
    const CheckOutcome outcome = check(solid, edges, most_corners);
    digest.add(outcome.status);
    for (const char* text = describe(outcome.status); *text != '\0'; ++text) {
        digest.add_byte(static_cast<std::uint8_t>(*text));
    }
    digest.add(outcome.face);
    digest.add(outcome.ring);
    digest.add(outcome.corner);
    digest.add(outcome.vertex);
    digest.add(outcome.edge.from);
    digest.add(outcome.edge.to);
}

} // namespace

std::uint64_t refused_solids() {
    Digest digest;
    const Solid whole = plate();
    add_outcome(digest, whole);
    for (std::uint32_t faces = 0; faces < whole.face_count; ++faces) { // faces left out at the end
        Solid part = whole;
        part.face_count = faces;
        add_outcome(digest, part);
    }
    for (std::uint32_t vertices = 0; vertices < whole.vertex_count; ++vertices) { // missing vertices
        Solid part = whole;
        part.vertex_count = vertices;
        add_outcome(digest, part);
    }
    // One vertex moved: off its planes, or off the lattice.
    struct Vertices {
        Point at[most_vertices];
    };
    Point* const moved = fresh<Vertices>().at;
    for (std::uint32_t v = 0; v < whole.vertex_count; ++v) {
        for (std::uint32_t i = 0; i < whole.vertex_count; ++i) moved[i] = whole.vertices[i];
        moved[v].at[v % 3] += v % 2 == 0 ? 1 : root_side;
        Solid bent = whole;
        bent.vertices = moved;
        add_outcome(digest, bent);
    }
    return digest.value();
}

} // namespace osem::cross
