// Moments, surfaces and components.
#include <new>

#include "paint/paint.hpp"

namespace osem::cross {

namespace {

SurfaceMeasurement surface;
ClusterWalk clusters;
ComponentLabelling labelling;
std::uint32_t scratch[80000];
// The result of `moments` is its caller's: put here it is not on the stack that is measured.
alignas(SolidMoments) unsigned char moments_memory[sizeof(SolidMoments)];

void measure_cluster_walk(const Octree& tree) {
    measured("ClusterWalk::begin", [&] { clusters.begin(tree, 3, true, LeafBlocks{nullptr, 0}); });
    bool found = true;
    measured("ClusterWalk::ahead", [&] { found = clusters.ahead(); });
    expect(found);
    measured("ClusterWalk::visit", [&] {
        for (int i = 0; i < 1000 && clusters.ahead(); ++i) clusters.visit();
    });
    measured("ClusterWalk::cluster", [&] {
        const Cluster cluster = clusters.cluster();
        use(cluster);
    });
}

void measure_surfaces(const Octree& tree) {
    measured("moments", [&] { new (moments_memory) SolidMoments(moments(tree)); });
    measured("SurfaceMeasurement::begin", [&] { surface.begin(tree); });
    measured("SurfaceMeasurement::step", [&] { surface.step(10000); });
    Status status = Status::ok;
    measured("SurfaceMeasurement::finish", [&] { status = surface.finish().status; });
    expect(status == Status::unfinished);
    measured("measure_surface", [&] { status = measure_surface(surface, tree).status; });
    expect(status == Status::ok);
}

void measure_components(const Octree& tree) {
    constexpr std::uint32_t size = sizeof scratch / sizeof *scratch;
    measured("ComponentLabelling::begin",
             [&] { labelling.begin(tree, outer_void, Connectivity::corners, scratch, size); });
    measured("ComponentLabelling::step", [&] {
        while (labelling.step(UINT32_MAX)) {
        }
    });
    ComponentOutcome outcome = {};
    measured("ComponentLabelling::finish", [&] { outcome = labelling.finish(); });
    expect(outcome.status == Status::ok && outcome.components > 0);
    Component component = {};
    measured("ComponentLabelling::fill", [&] { use(labelling.fill(&component, 1)); });
    std::uint32_t found = no_component;
    measured("ComponentLabelling::component_of", [&] { found = labelling.component_of({{0, 0, 0}}); });
    expect(found == 0 && component.touches_border);
}

} // namespace

void paint_measures(const PaintTrees& trees) {
    measure_cluster_walk(trees.a);
    measure_surfaces(trees.a);
    measure_components(trees.a);
}

} // namespace osem::cross
