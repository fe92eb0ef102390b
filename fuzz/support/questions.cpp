#include "support/questions.hpp"

#include <algorithm>
#include <vector>

#include "osem/collide.hpp"
#include "osem/nearest.hpp"
#include "osem/neighbour.hpp"
#include "osem/query.hpp"
#include "osem/ray.hpp"
#include "osem/slice.hpp"
#include "support/any_grid.hpp"
#include "support/leaf_list.hpp"
#include "support/query_oracles.hpp"
#include "support/slices.hpp"

namespace osem::fuzz {

namespace {

using tests::is_beyond;
using tests::leaves_of;
using tests::same_leaf;

bool in_root(const Point& p, std::int32_t last) {
    return std::all_of(std::begin(p.at), std::end(p.at),
                       [&](std::int32_t at) { return at >= 0 && at <= last; });
}

// A coordinate of the root, of its border, or of any size.
std::int32_t any_coordinate(Choices& choices) {
    const std::uint8_t kind = choices.byte();
    if (kind < 200) return kind % 17 * (root_side / 16) + (kind < 140 ? 0 : kind % 3 - 1);
    return kind < 240 ? choices.between(0, root_side) : static_cast<std::int32_t>(choices.word());
}

Point any_point(Choices& choices) {
    const std::int32_t x = any_coordinate(choices);
    const std::int32_t y = any_coordinate(choices);
    return {{x, y, any_coordinate(choices)}};
}

// Whether the cells of the grid in an octant are all of the colour.
bool is_all(const tests::DenseGrid& grid, const Octant& octant, Colour colour) {
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const Point p = grid.corner(cell);
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            inside = inside && p.at[axis] >= octant.corner.at[axis] &&
                     p.at[axis] < octant.corner.at[axis] + octant.side();
        }
        if (inside && grid[cell] != colour) return false;
    }
    return true;
}

// Colours of the cells with a part in a box, and whether a solid one at least touches it.
BoxOutcome expected_box(const tests::DenseGrid& grid, const CellBox& box) {
    BoxOutcome expected = {Status::ok, 0, false, 0};
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const Point p = grid.corner(cell);
        bool overlaps = true;
        bool touches = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t high = p.at[axis] + grid.cell_side();
            overlaps = overlaps && p.at[axis] < box.high.at[axis] && box.low.at[axis] < high;
            touches = touches && p.at[axis] <= box.high.at[axis] && box.low.at[axis] <= high;
        }
        if (overlaps) expected.colours = static_cast<std::uint8_t>(expected.colours | colour_bit(grid[cell]));
        if (touches && grid[cell] != Colour::white) expected.touches = true;
    }
    if ((expected.colours & solid_colours) != 0) expected.touches = false;
    return expected;
}

bool same(const Passage& passage, const tests::Stay& stay) {
    return same_leaf(passage.leaf, stay.leaf) && passage.entry == stay.entry.unmoved &&
           passage.exit == stay.exit.unmoved && passage.begins == (stay.entry.axis < 0) &&
           passage.ends == (stay.exit.axis < 0) &&
           (passage.begins || passage.entered_axis == stay.entry.axis) &&
           (passage.ends || passage.left_axis == stay.exit.axis);
}

} // namespace

void ask_point(const Forest::Entry& entry, Choices& choices) {
    const Point cell = any_point(choices);
    const PointOutcome found = leaf_at(entry.tree, cell);
    if (!in_root(cell, root_side - 1)) {
        EXPECT_EQ(found.status, Status::point_off_root);
        return;
    }
    ASSERT_EQ(found.status, Status::ok);
    EXPECT_EQ(found.leaf.colour, entry.grid.at(cell));
    EXPECT_LE(found.visited, entry.tree.depth);
    const Octant& octant = found.leaf.octant;
    EXPECT_TRUE(is_octant(octant) && octant.level <= entry.grid.depth());
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(cell.at[axis] & -octant.side(), octant.corner.at[axis]);
    EXPECT_TRUE(is_all(entry.grid, octant, found.leaf.colour));
    if (octant.level > 0) {
        EXPECT_FALSE(is_all(entry.grid, octant.parent(), found.leaf.colour)) << "canonical";
    }
}

void ask_box(const Forest::Entry& entry, Choices& choices) {
    CellBox box = {any_point(choices), any_point(choices)};
    if (choices.below(4) != 0) {
        for (int axis = 0; axis < 3; ++axis) {
            if (box.low.at[axis] > box.high.at[axis]) std::swap(box.low.at[axis], box.high.at[axis]);
        }
    }
    const BoxOutcome found = colours_in(entry.tree, box);
    bool is_empty = false;
    for (int axis = 0; axis < 3; ++axis) is_empty = is_empty || box.low.at[axis] >= box.high.at[axis];
    if (!in_root(box.low, root_side) || !in_root(box.high, root_side)) {
        EXPECT_EQ(found.status, Status::point_off_root);
    } else if (is_empty) {
        EXPECT_EQ(found.status, Status::box_empty);
    } else {
        const BoxOutcome expected = expected_box(entry.grid, box);
        ASSERT_EQ(found.status, Status::ok);
        EXPECT_EQ(found.colours, expected.colours);
        EXPECT_EQ(found.touches, expected.touches);
        EXPECT_EQ(found.clear(), expected.clear());
        EXPECT_EQ(found.mixed(), expected.mixed());
    }
}

void ask_segment(const Forest::Entry& entry, Choices& choices) {
    Point p = {};
    Point q = {};
    const std::int32_t length = choices.between(-16, 16);
    for (int axis = 0; axis < 3; ++axis) {
        p.at[axis] = choices.between(-12, 28);
        q.at[axis] = choices.flag() ? choices.between(-12, 28) : p.at[axis] + length * choices.between(-1, 1);
    }
    const Segment segment = {tests::in_units(p), tests::in_units(q)};
    const std::vector<tests::Stay> stays = tests::expected_stays(leaves_of(entry.tree), p, q);
    SegmentWalk walk(entry.tree, segment);
    ASSERT_EQ(walk.status(), Status::ok);
    Passage passage = {};
    for (const tests::Stay& stay : stays) ASSERT_TRUE(walk.next(passage) && same(passage, stay));
    EXPECT_FALSE(walk.next(passage));

    SegmentWalk crossings(entry.tree, segment);
    Crossing found = {};
    for (const Crossing& crossing : tests::expected_crossings(stays)) {
        ASSERT_TRUE(crossings.next_crossing(found));
        EXPECT_TRUE(found.at == crossing.at && found.axis == crossing.axis &&
                    found.before == crossing.before && found.after == crossing.after &&
                    same_leaf(found.entered, crossing.entered));
    }
    EXPECT_FALSE(crossings.next_crossing(found));

    const auto colours = static_cast<std::uint8_t>(choices.below(16));
    const auto first = std::find_if(stays.begin(), stays.end(), [&](const tests::Stay& stay) {
        return (colours & colour_bit(stay.leaf.colour)) != 0;
    });
    const HitOutcome hit = first_hit(entry.tree, segment, colours);
    ASSERT_EQ(hit.hit, first != stays.end());
    if (hit.hit) {
        EXPECT_TRUE(same(hit.passage, *first));
    }
}

void ask_neighbour(const Forest::Entry& entry, Choices& choices) {
    const PointOutcome at = leaf_at(entry.tree, any_cell(entry.grid.depth(), choices));
    Octant octant = at.leaf.octant;
    for (std::uint32_t up = choices.below(3); up > 0 && octant.level > 0; --up) octant = octant.parent();
    for (std::uint32_t down = choices.below(3); down > 0 && octant.level < max_depth; --down) {
        octant = octant.child(choices.below(8));
    }
    const OctantFace face = {static_cast<Axis>(choices.below(3)), choices.flag()};
    std::vector<Leaf> beyond;
    for (const Leaf& leaf : leaves_of(entry.tree)) {
        if (is_beyond(octant, face, leaf.octant)) beyond.push_back(leaf);
    }
    const NeighbourOutcome found = face_neighbour(entry.tree, octant, face);
    ASSERT_EQ(found.status, Status::ok);
    EXPECT_EQ(found.outside, beyond.empty());
    Leaf expected = beyond.empty() ? Leaf{root_octant, Colour::white} : beyond[0];
    if (beyond.size() > 1) {
        expected = {octant, Colour::grey};
        expected.octant.corner.at[face.axis] += face.high ? octant.side() : -octant.side();
    }
    EXPECT_TRUE(same_leaf({found.octant, found.colour}, expected));
    NeighbourWalk walk(entry.tree, octant, face);
    Leaf leaf = {};
    for (const Leaf& next : beyond) ASSERT_TRUE(walk.next(leaf) && same_leaf(leaf, next));
    EXPECT_FALSE(walk.next(leaf));
}

void ask_nearest(const Forest::Entry& entry, Choices& choices) {
    CellBox from = {any_point(choices), any_point(choices)};
    bool in_range = true;
    bool is_empty = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (choices.below(8) != 0) from.high.at[axis] = from.low.at[axis];
        is_empty = is_empty || from.low.at[axis] > from.high.at[axis];
        for (const std::int32_t at : {from.low.at[axis], from.high.at[axis]}) {
            in_range = in_range && at >= -segment_reach && at <= segment_reach;
        }
    }
    const auto colours = static_cast<std::uint8_t>(choices.below(16));
    const NearestOutcome found = nearest_leaf(entry.tree, from, colours);
    if (!in_range || is_empty) {
        EXPECT_EQ(found.status, !in_range ? Status::coordinate_out_of_range : Status::box_empty);
        return;
    }
    ASSERT_EQ(found.status, Status::ok);
    const tests::Nearest expected = tests::expected_nearest(tests::cells_of(entry.grid, colours), from);
    ASSERT_EQ(found.found, expected.found);
    if (!found.found) return;
    EXPECT_EQ(found.distance, expected.distance);
    EXPECT_TRUE(same_leaf(found.leaf, leaf_at(entry.tree, expected.corner).leaf));
    EXPECT_TRUE(nearest_leaf(entry.tree, from, colours, expected.distance).found);
    if (expected.distance > 0) {
        EXPECT_FALSE(nearest_leaf(entry.tree, from, colours, expected.distance - 1).found);
    }
}

void ask_collision(const Forest::Entry& a, const Forest::Entry& b, Choices& choices) {
    const std::vector<Leaf> of_a = leaves_of(a.tree);
    const std::vector<Leaf> of_b = leaves_of(b.tree);
    if (of_a.size() * of_b.size() > 60000) return;
    Point offset = any_point(choices);
    for (std::int32_t& at : offset.at) at = choices.flag() || at == INT32_MIN ? at : -at;
    Collision job;
    job.begin(a.tree, b.tree, offset);
    if (choices.below(4) == 0 && job.step(choices.byte())) {
        EXPECT_EQ(job.finish().status, Status::unfinished);
    }
    step_through(job, choices);
    const CollisionOutcome found =
        choices.below(4) == 0 ? collide(job, a.tree, b.tree, offset) : job.finish();
    ASSERT_EQ(found.status, Status::ok);
    EXPECT_EQ(found.contact, tests::expected_contact(of_a, of_b, offset));
    if (found.contact != Contact::clear) {
        EXPECT_EQ(tests::contact_of(found.a, found.b, offset), found.contact);
    }
}

namespace {

struct TakenRows {
    std::vector<std::vector<std::uint8_t>> rows;
    static bool take(void* context, std::int32_t, const std::uint8_t* bytes, std::size_t count) {
        static_cast<TakenRows*>(context)->rows.emplace_back(bytes, bytes + count);
        return true;
    }
};

struct TakenRuns {
    std::vector<PixelRun> runs;
    static bool take(void* context, const PixelRun& run) {
        static_cast<TakenRuns*>(context)->runs.push_back(run);
        return true;
    }
};

bool same_run(const PixelRun& a, const PixelRun& b) {
    return a.row == b.row && a.start == b.start && a.length == b.length && a.colour == b.colour;
}

void expect_bitmaps(const Octree& tree, const Slice& slice, const tests::Rows& rows, Choices& choices) {
    const auto bits = static_cast<Bits>(choices.below(3));
    TakenRows taken;
    std::vector<std::uint8_t> buffer(slice_buffer(slice.level, bits));
    BitmapSlicing job;
    const RowSink sink = {TakenRows::take, &taken};
    EXPECT_EQ(job.begin(tree, slice, bits, buffer.data(), buffer.size() - 1, sink),
              Status::scratch_too_small);
    ASSERT_EQ(job.begin(tree, slice, bits, buffer.data(), buffer.size(), sink), Status::ok);
    step_through(job, choices);
    EXPECT_EQ(job.finish().status, Status::ok);
    ASSERT_EQ(taken.rows.size(), rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::vector<std::uint8_t> expected;
        if (bits != Bits::inner) expected = tests::bits_of(rows[row], false);
        if (bits != Bits::outer) {
            const std::vector<std::uint8_t> inner = tests::bits_of(rows[row], true);
            expected.insert(expected.end(), inner.begin(), inner.end());
        }
        EXPECT_TRUE(taken.rows[row] == expected);
    }
}

} // namespace

void ask_slice(const Forest::Entry& entry, Choices& choices) {
    Slice slice = {static_cast<Axis>(choices.below(3)), any_coordinate(choices),
                   static_cast<std::uint8_t>(choices.below(entry.tree.depth + 2U))};
    TakenRuns taken;
    RunSlicing job;
    const Status status = job.begin(entry.tree, slice, {TakenRuns::take, &taken});
    if (slice.cell < 0 || slice.cell >= root_side) {
        EXPECT_EQ(status, Status::point_off_root);
        return;
    }
    if (slice.level > entry.tree.depth) {
        EXPECT_EQ(status, Status::level_out_of_range);
        return;
    }
    ASSERT_EQ(status, Status::ok);
    if (slice.level > entry.grid.depth()) return; // the model has no such pixels
    step_through(job, choices);
    EXPECT_EQ(job.finish().status, Status::ok);
    const tests::Rows rows = tests::expected_rows(entry.grid, slice);
    std::size_t at = 0;
    RowWalk walk;
    ASSERT_EQ(walk.begin(entry.tree, slice), Status::ok);
    for (int row = 0; row < walk.rows(); ++row) {
        walk.enter(row);
        PixelRun run = {};
        for (const PixelRun& expected : tests::runs_of(rows[static_cast<std::size_t>(row)], row, true)) {
            ASSERT_TRUE(walk.next(run) && same_run(run, expected));
            if (expected.colour == Colour::white) continue;
            ASSERT_TRUE(at < taken.runs.size() && same_run(taken.runs[at], expected));
            ++at;
        }
        EXPECT_FALSE(walk.next(run));
    }
    EXPECT_EQ(at, taken.runs.size());
    expect_bitmaps(entry.tree, slice, rows, choices);
}

} // namespace osem::fuzz
