// Scenarios of surfaces: what is emitted, and whether it is checked and converted back.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

// Every vertex has two corners at least, and every ring four.
struct Work {
    Boundary job;
    BoundaryCorner scratch[most_corners];
    Point vertices[most_corners / 2];
    std::uint32_t corners[most_corners];
    std::uint32_t ring_starts[most_corners / 4 + 1];
    std::uint32_t face_rings[most_corners / 4 + 1];
};

BoundaryOutcome built(Work& work, const Octree& tree, SolidPart part, std::uint32_t units) {
    work.job.begin(tree, part, work.scratch, most_corners);
    while (work.job.step(units)) {
    }
    return work.job.finish();
}

void add(Digest& digest, const BoundaryOutcome& outcome) {
    digest.add(outcome.status);
    digest.add(outcome.sizes.vertices);
    digest.add(outcome.sizes.corners);
    digest.add(outcome.sizes.rings);
    digest.add(outcome.sizes.faces);
    digest.add(outcome.scratch_missing);
    digest.add(outcome.double_edges);
}

void add(Digest& digest, const Solid& surface) {
    for (std::uint32_t v = 0; v < surface.vertex_count; ++v) {
        for (const std::int32_t coordinate : surface.vertices[v].at) digest.add(coordinate);
    }
    for (std::uint32_t c = 0; c < surface.corner_count; ++c) digest.add(surface.corners[c]);
    for (std::uint32_t r = 0; r <= surface.ring_count(); ++r) digest.add(surface.ring_starts[r]);
    for (std::uint32_t f = 0; f <= surface.face_count; ++f) digest.add(surface.face_rings[f]);
}

// The surface of a tree, and the tree that it gives.
void add_round_trip(Digest& digest, const Octree& tree) {
    auto& work = fresh<Work>();
    const BoundaryOutcome outcome = built(work, tree, SolidPart::inner, 3);
    add(digest, outcome);
    if (outcome.status != Status::ok) return;
    const Solid surface =
        boundary_solid(work.job, {work.vertices, work.corners, work.ring_starts, work.face_rings});
    add(digest, surface);
    ConvertOptions options;
    options.depth = tree.depth;
    const TreeOutcome back = converted(surface, options);
    digest.add(back.status);
    digest.add(back.status == Status::ok && same_leaves(back.tree, tree));
}

} // namespace

// Where cells touch in edges and corners: every way to choose from two by two by two. Those of more corners
// than the scratch has are refused.
std::uint64_t surfaces_of_eight_cells() {
    Digest digest;
    for (unsigned black = 1; black < 255; ++black) {
        pool.roll_back(0);
        auto& builder = fresh<TreeBuilder>();
        builder.begin(&pool);
        for (unsigned k = 0; k < 8; ++k) {
            builder.leaf(k, ((black >> k) & 1U) != 0 ? Colour::black : Colour::white);
        }
        builder.close();
        add_round_trip(digest, builder.finish(1).tree);
    }
    return digest.value();
}

// A square ring, lying across each axis.
std::uint64_t surface_with_holes() {
    Digest digest;
    for (unsigned axis = 0; axis < 3; ++axis) {
        pool.roll_back(0);
        auto& builder = fresh<TreeBuilder>();
        builder.begin(&pool);
        for (unsigned k = 0; k < 8; ++k) {
            if (((k >> axis) & 1U) != 0) {
                builder.leaf(k, Colour::white);
                continue;
            }
            builder.open(k);
            const unsigned inmost = 7U ^ k;
            const unsigned across = 7U ^ (1U << axis);
            for (unsigned j = 0; j < 8; ++j) {
                const bool hole = (j & across) == (inmost & across);
                const bool low = ((j >> axis) & 1U) == 0;
                builder.leaf(j, low && !hole ? Colour::black : Colour::white);
            }
            builder.close();
        }
        builder.close();
        add_round_trip(digest, builder.finish(2).tree);
    }
    return digest.value();
}

// Surfaces too large for the scratch: their sizes, and what is missing.
std::uint64_t surfaces_counted() {
    Digest digest;
    ConvertOptions options;
    for (int depth = 2; depth <= 4; ++depth) {
        pool.roll_back(0);
        options.depth = depth;
        const Octree tree = converted(plate(), options).tree;
        for (const SolidPart part : {SolidPart::inner, SolidPart::outer}) {
            auto& work = fresh<Work>();
            add(digest, built(work, tree, part, 11));
        }
    }
    return digest.value();
}

} // namespace osem::cross
