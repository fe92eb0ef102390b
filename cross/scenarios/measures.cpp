// Scenarios of moments, surfaces and components.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

void add(Digest& digest, const Moments& m) {
    digest.add(m.volume);
    for (const Wide& first : m.first) {
        digest.add(first.high);
        digest.add(first.low);
    }
    for (const Wide& second : m.second) {
        digest.add(second.high);
        digest.add(second.low);
    }
}

void add(Digest& digest, const SurfaceMeasures& m) {
    for (const std::uint64_t area : m.area) digest.add(area);
    digest.add(m.euler_closed);
    digest.add(m.euler_open);
}

void add_measures(Digest& digest, const Octree& tree) {
    const SolidMoments m = moments(tree);
    add(digest, m.inner);
    add(digest, m.outer);
    auto& job = fresh<SurfaceMeasurement>();
    const SurfaceOutcome surface = measure_surface(job, tree);
    digest.add(surface.status);
    add(digest, surface.inner);
    add(digest, surface.outer);
    digest.add(job.clusters_visited());
}

struct Labelling {
    ComponentLabelling job;
    std::uint32_t scratch[200]; // too few for some of the trees
};

void add_components(Digest& digest, Labelling& labelling, const Octree& tree, std::uint8_t colours,
                    Connectivity connectivity) {
    ComponentLabelling& job = labelling.job;
    job.begin(tree, colours, connectivity, labelling.scratch, 200);
    while (job.step(7)) {
    }
    const ComponentOutcome outcome = job.finish();
    digest.add(outcome.status);
    digest.add(outcome.components);
    digest.add(outcome.scratch_needed);
    digest.add(job.units_visited());
    if (outcome.status != Status::ok) return;
    Component components[4] = {};
    const std::uint32_t count = job.fill(components, 4);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Component& c = components[i];
        digest.add(c.volume);
        digest.add(c.leaves);
        for (const std::int32_t at : c.box.low.at) digest.add(at);
        for (const std::int32_t at : c.box.high.at) digest.add(at);
        digest.add(c.touches_border);
        digest.add(job.component_of(c.box.low));
    }
}

} // namespace

std::uint64_t moments_and_surfaces() {
    Digest digest;
    for (const int depth : {1, 3, 4}) {
        for (std::uint32_t seed = 1; seed <= 3; ++seed) {
            pool.roll_back(0);
            ConvertOptions options;
            options.depth = static_cast<std::uint8_t>(depth);
            const Solid solid = seed == 1   ? plate()
                                : seed == 2 ? octahedron()
                                            : tetrahedra(300, Point{{0, 0, 0}}, root_side);
            const TreeOutcome outcome = converted(solid, options);
            digest.add(outcome.status);
            if (outcome.status == Status::ok) add_measures(digest, outcome.tree);
        }
    }
    add_measures(digest, Octree::uniform(pool, Colour::black));
    return digest.value();
}

std::uint64_t labelled_components() {
    Digest digest;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        pool.roll_back(0);
        ConvertOptions options;
        options.depth = 3;
        options.leaves = seed % 2 == 0 ? LeafRule::centre : LeafRule::conservative;
        const TreeOutcome outcome = converted(tetrahedra(400 + seed, Point{{0, 0, 0}}, root_side), options);
        if (outcome.status != Status::ok) continue;
        auto& labelling = fresh<Labelling>();
        for (const std::uint8_t colours : {inner_solid, outer_solid, inner_void, outer_void}) {
            for (const auto connectivity :
                 {Connectivity::faces, Connectivity::edges, Connectivity::corners}) {
                add_components(digest, labelling, outcome.tree, colours, connectivity);
            }
        }
    }
    return digest.value();
}

} // namespace osem::cross
