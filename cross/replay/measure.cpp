// Moments, surfaces and components of trees given by their leaves.
#include "osem/measure.hpp"
#include "osem/components.hpp"

#include "planted_tree.hpp"
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

constexpr std::uint32_t component_size = 33; // bytes in a record

// A labelling takes a word for each node and leaf that counts, and what it finds: exactly that is taken.
void replay_labelling(Reader& reader, Arena& arena, Report& report, const Octree& tree) {
    const std::uint8_t colours = reader.u8();
    const auto connectivity = static_cast<Connectivity>(reader.u8());
    const std::uint32_t expected = reader.u32();
    const ArenaScope scope(arena);
    const auto words = static_cast<std::uint32_t>(component_scratch(measure(tree), colours));
    auto* const job = arena.take<ComponentLabelling>(1);
    auto* const scratch = arena.take<std::uint32_t>(words);
    auto* const found = arena.take<Component>(expected);
    if (job == nullptr || scratch == nullptr || found == nullptr) {
        report.too_large();
        reader.skip(expected * component_size);
        return;
    }
    report.begin_case();
    job->begin(tree, colours, connectivity, scratch, words);
    while (job->step(1000)) {
    }
    const ComponentOutcome outcome = job->finish();
    report.expect("status of a labelling", static_cast<int>(Status::ok), static_cast<int>(outcome.status));
    report.expect("components", expected, outcome.components);
    report.expect("words of scratch", words, static_cast<std::int64_t>(outcome.scratch_needed));
    const std::uint32_t filled = outcome.status == Status::ok ? job->fill(found, expected) : 0;
    for (std::uint32_t i = filled; i < expected; ++i) found[i] = Component{};
    for (std::uint32_t i = 0; i < expected; ++i) replay_component(reader, report, found[i]);
}

void replay_measures(Reader& reader, Report& report, SurfaceMeasurement& job, const Octree& tree) {
    report.begin_case();
    const SolidMoments m = moments(tree);
    const SurfaceOutcome surface = measure_surface(job, tree);
    replay_solid(reader, report, m.inner, surface.inner);
    replay_solid(reader, report, m.outer, surface.outer);
}

} // namespace

bool replay_measure(Reader& reader, Arena& arena, Report& report) {
    const PlantedTree planted(reader, arena);
    if (!planted.fits()) return false;
    {
        const ArenaScope scope(arena); // the surface's memory is given back
        auto* const surface = arena.take<SurfaceMeasurement>(1);
        if (surface == nullptr) return false;
        replay_measures(reader, report, *surface, planted.tree());
    }
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        replay_labelling(reader, arena, report, planted.tree());
    }
    return true;
}

} // namespace osem::cross
