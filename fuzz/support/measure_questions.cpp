#include <algorithm>
#include <vector>

#include "osem/components.hpp"
#include "osem/measure.hpp"
#include "support/cell_measures.hpp"
#include "support/leaf_list.hpp"
#include "support/questions.hpp"

namespace osem::fuzz {

namespace {

bool same(const Moments& a, const Moments& b) {
    return a.volume == b.volume && std::equal(std::begin(a.first), std::end(a.first), std::begin(b.first)) &&
           std::equal(std::begin(a.second), std::end(a.second), std::begin(b.second));
}

bool same(const SurfaceMeasures& a, const SurfaceMeasures& b) {
    return std::equal(std::begin(a.area), std::end(a.area), std::begin(b.area)) &&
           a.euler_closed == b.euler_closed && a.euler_open == b.euler_open;
}

bool same(const Component& a, const Component& b) {
    return a.volume == b.volume && a.box.low == b.box.low && a.box.high == b.box.high &&
           a.touches_border == b.touches_border;
}

} // namespace

void ask_measures(const Forest::Entry& entry) {
    const tests::Masks masks = tests::preorder_masks(entry.grid);
    std::size_t nodes = 0;
    for (NodeWalk walk(entry.tree); !walk.done(); walk.next()) {
        ASSERT_LT(nodes, masks.size());
        EXPECT_EQ(walk.node().may, masks[nodes].first);
        EXPECT_EQ(walk.node().must, masks[nodes].second);
        ++nodes;
    }
    EXPECT_EQ(nodes, masks.size());
    std::uint64_t counts[4] = {};
    std::uint64_t volume = 0;
    for (const Leaf& leaf : tests::leaves_of(entry.tree)) {
        ++counts[static_cast<unsigned>(leaf.colour)];
        volume += volume_at(leaf.octant.level);
        EXPECT_EQ(entry.grid.at(leaf.octant.corner), leaf.colour);
    }
    EXPECT_EQ(volume, root_volume);
    const Measures m = measure(entry.tree);
    EXPECT_EQ(m.nodes, nodes);
    EXPECT_EQ(m.white_leaves, counts[0]);
    EXPECT_EQ(m.boundary_leaves, counts[1]);
    EXPECT_EQ(m.black_leaves, counts[3]);
    EXPECT_EQ(m.inner_volume, entry.grid.volume(Colour::black));
    EXPECT_EQ(m.outer_volume, m.inner_volume + entry.grid.volume(Colour::boundary));
}

void ask_moments(const Forest::Entry& entry) {
    const SolidMoments found = moments(entry.tree);
    EXPECT_TRUE(same(found.inner, tests::cell_moments({entry.grid, inner_solid})));
    EXPECT_TRUE(same(found.outer, tests::cell_moments({entry.grid, outer_solid})));
}

void ask_surface(const Forest::Entry& entry, Choices& choices) {
    SurfaceMeasurement job;
    EXPECT_EQ(job.finish().status, Status::unfinished);
    job.begin(entry.tree);
    step_through(job, choices);
    const SurfaceOutcome found = choices.below(4) == 0 ? measure_surface(job, entry.tree) : job.finish();
    ASSERT_EQ(found.status, Status::ok);
    EXPECT_TRUE(same(found.inner, tests::cell_surface({entry.grid, inner_solid})));
    EXPECT_TRUE(same(found.outer, tests::cell_surface({entry.grid, outer_solid})));
}

void ask_components(const Forest::Entry& entry, Choices& choices) {
    constexpr std::uint8_t sets[] = {inner_solid, outer_solid, inner_void, outer_void};
    const std::uint8_t colours = sets[choices.below(4)];
    const auto connectivity = static_cast<Connectivity>(1 + choices.below(3));
    const std::uint64_t needed = component_scratch(measure(entry.tree), colours);
    std::vector<std::uint32_t> scratch(choices.below(static_cast<std::uint32_t>(needed)));
    ComponentLabelling job;
    job.begin(entry.tree, colours, connectivity, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
    step_through(job, choices);
    EXPECT_EQ(job.finish().status, Status::scratch_too_small);
    EXPECT_EQ(job.finish().scratch_needed, needed);
    scratch.resize(needed);
    job.begin(entry.tree, colours, connectivity, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
    step_through(job, choices);
    ASSERT_EQ(job.finish().status, Status::ok);

    const tests::CellComponents expected = tests::cell_components(entry.grid, colours, connectivity);
    ASSERT_EQ(job.finish().components, expected.components.size());
    std::vector<Component> found(expected.components.size());
    const auto count = static_cast<std::uint32_t>(found.size());
    EXPECT_EQ(job.fill(found.data(), count), count);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_TRUE(same(found[i], expected.components[i]));
    for (std::size_t cell = 0; cell < entry.grid.size(); ++cell) {
        EXPECT_EQ(job.component_of(entry.grid.corner(cell)), expected.labels[cell]);
    }
}

} // namespace osem::fuzz
