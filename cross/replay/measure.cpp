// Moments, surfaces and components of trees given by their leaves.
#include "osem/measure.hpp"
#include "osem/components.hpp"

#include "leaf_planter.hpp"
#include "records.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

void expect_number(Reader& reader, Report& report, const char* what, std::uint64_t found) {
    report.expect(what, reader.i64(), static_cast<std::int64_t>(found));
}

void replay_solid(Reader& reader, Report& report, const Moments& m, const SurfaceMeasures& surface) {
    expect_number(reader, report, "volume", m.volume);
    for (const Wide& first : m.first) {
        expect_number(reader, report, "first moment, high half", first.high);
        expect_number(reader, report, "first moment, low half", first.low);
    }
    for (const Wide& second : m.second) {
        expect_number(reader, report, "second moment, high half", second.high);
        expect_number(reader, report, "second moment, low half", second.low);
    }
    for (const std::uint64_t area : surface.area) expect_number(reader, report, "area", area);
    report.expect("Euler characteristic, closed", reader.i64(), surface.euler_closed);
    report.expect("Euler characteristic, open", reader.i64(), surface.euler_open);
}

void expect_point(Reader& reader, Report& report, const char* what, const Point& found) {
    const Point expected = reader.point();
    for (int axis = 0; axis < 3; ++axis) report.expect(what, expected.at[axis], found.at[axis]);
}

void replay_component(Reader& reader, Report& report, const Component& found) {
    expect_number(reader, report, "volume of a component", found.volume);
    expect_point(reader, report, "low corner of a component", found.box.low);
    expect_point(reader, report, "high corner of a component", found.box.high);
    report.expect("whether a component touches the border", reader.u8(), found.touches_border ? 1 : 0);
}

struct Work {
    ComponentLabelling* job;
    std::uint32_t* scratch;
    std::uint32_t size;
    Component* found;
};

void replay_labelling(Reader& reader, Report& report, const Work& work, const Octree& tree) {
    report.begin_case();
    const std::uint8_t colours = reader.u8();
    const auto connectivity = static_cast<Connectivity>(reader.u8());
    const std::uint32_t expected = reader.u32();
    work.job->begin(tree, colours, connectivity, work.scratch, work.size);
    while (work.job->step(1000)) {
    }
    const ComponentOutcome outcome = work.job->finish();
    report.expect("status of a labelling", static_cast<int>(Status::ok), static_cast<int>(outcome.status));
    report.expect("components", expected, outcome.components);
    report.expect("words of scratch", static_cast<std::int64_t>(component_scratch(measure(tree), colours)),
                  static_cast<std::int64_t>(outcome.scratch_needed));
    const std::uint32_t filled = work.job->fill(work.found, expected < work.size ? expected : work.size);
    for (std::uint32_t i = filled; i < expected && i < work.size; ++i) work.found[i] = Component{};
    for (std::uint32_t i = 0; i < expected; ++i) {
        replay_component(reader, report, i < work.size ? work.found[i] : Component{});
    }
}

} // namespace

bool replay_measure(Reader& reader, Arena& arena, Report& report) {
    const std::uint8_t depth = reader.u8();
    const std::uint32_t leaves = reader.u32();
    const std::uint32_t nodes = nodes_of(leaves);
    Node* const memory = take_nodes(arena, nodes);
    auto* const builder = arena.take<TreeBuilder>(1);
    auto* const surface = arena.take<SurfaceMeasurement>(1);
    const Work work = {arena.take<ComponentLabelling>(1), arena.take<std::uint32_t>(nodes + leaves),
                       nodes + leaves, arena.take<Component>(nodes + leaves)};
    if (memory == nullptr || builder == nullptr || surface == nullptr || work.found == nullptr) return false;
    if (work.job == nullptr || work.scratch == nullptr) return false;
    NodePool pool(memory, nodes);
    const TreeOutcome outcome = plant_leaves(reader, depth, leaves, *builder, pool);
    report.begin_case();
    report.expect("status of the tree", static_cast<int>(Status::ok), static_cast<int>(outcome.status));
    if (outcome.status != Status::ok) return true;
    const SolidMoments m = moments(outcome.tree);
    const SurfaceOutcome measured = measure_surface(*surface, outcome.tree);
    replay_solid(reader, report, m.inner, measured.inner);
    replay_solid(reader, report, m.outer, measured.outer);
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        replay_labelling(reader, report, work, outcome.tree);
    }
    return true;
}

} // namespace osem::cross
