// Conversion by a bintree and labelling: the same trees as divide and conquer, in the same places; against
// dense grids; and where filling by connectivity alone goes wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "osem/bintree.hpp"
#include "support/dense_grid.hpp"
#include "support/heap_pool.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

constexpr WindingRule winding_rules[] = {WindingRule::nonzero, WindingRule::odd, WindingRule::positive};
constexpr std::int32_t sixteenth = root_side / 16;

std::int32_t at(std::int32_t sixteenths) { return sixteenths * sixteenth; }

Box box(std::int32_t low, std::int32_t high, int winding = 1) {
    return {{{at(low), at(low), at(low)}}, {{at(high), at(high), at(high)}}, winding};
}

// Scratch of exactly so many words, so that the address sanitizer sees one too many.
struct Words {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> blocks;

    Words(const SmallSolid& solid, std::uint32_t block_size)
        : faces(solid.face_count()), blocks(block_size) {}
    Status begin(Labelling& job, const SmallSolid& solid, int depth, WindingRule rule, NodePool* pool) {
        return job.begin(solid.checked(), depth, rule, faces.data(), static_cast<std::uint32_t>(faces.size()),
                         blocks.data(), static_cast<std::uint32_t>(blocks.size()), pool);
    }
};

LabellingOutcome labelled(Labelling& job, const SmallSolid& solid, int depth, WindingRule rule,
                          std::uint32_t block_size, NodePool* pool) {
    Words run(solid, block_size);
    return convert_by_labelling(job, solid.checked(), depth, rule, run.faces.data(), solid.face_count(),
                                run.blocks.data(), block_size, pool);
}

std::uint32_t blocks_needed(const SmallSolid& solid, int depth) {
    Labelling job;
    const LabellingOutcome outcome = labelled(job, solid, depth, WindingRule::nonzero, 0, nullptr);
    EXPECT_EQ(outcome.built.status, Status::scratch_too_small);
    return outcome.blocks_needed;
}

void expect_same_as_divide_and_conquer(const SmallSolid& solid, int greatest_depth) {
    Labelling job;
    for (int depth = 1; depth <= greatest_depth; ++depth) {
        const std::uint32_t blocks = blocks_needed(solid, depth);
        for (const WindingRule rule : winding_rules) {
            HeapPool expected(40000);
            const ConvertOptions options = {depth, LeafRule::conservative, rule};
            const TreeOutcome divided = converted(solid, options, &*expected);
            ASSERT_EQ(divided.status, Status::ok);
            HeapPool pool(divided.nodes_needed);
            const LabellingOutcome outcome = labelled(job, solid, depth, rule, blocks, &*pool);
            ASSERT_EQ(outcome.built.status, Status::ok);
            ASSERT_EQ(outcome.blocks_needed, blocks);
            ASSERT_EQ(outcome.built.nodes_needed, divided.nodes_needed);
            ASSERT_EQ(outcome.built.tree.top, divided.tree.top) << "depth " << depth;
            ASSERT_EQ(outcome.built.tree.depth, depth);
            ASSERT_EQ(pool.used_nodes(), expected.used_nodes());
        }
    }
}

TEST(Labelling, BoxesNestedTouchingAndOverlapping) {
    const std::vector<std::vector<Box>> cases = {
        {box(2, 9)},
        {{{{100001, 90003, 120005}}, {{600007, 500009, 400011}}}},
        {box(1, 15), box(3, 12, -1), box(5, 9)},                         // shells in shells
        {box(0, 16), box(4, 12, -1)},                                    // the root, and a cavity
        {box(1, 9), box(5, 13)},                                         // overlapping
        {box(1, 9), box(5, 13, -1)},                                     // and of opposite orientation
        {box(2, 6), {{{at(6), at(2), at(2)}}, {{at(9), at(6), at(6)}}}}, // touching in a side
        {box(2, 6), box(6, 9)},                                          // touching in a corner
        {box(4, 8), box(4, 8, -1)},                                      // a surface that cancels itself
        {box(4, 8), box(4, 8)},                                          // and one twice
    };
    for (const auto& boxes : cases) expect_same_as_divide_and_conquer(boxes_solid(boxes), 5);
}

// A closed room whose walls lie in planes of blocks meets no block but is between them.
TEST(Labelling, WallsInPlanesOfBlocksSeparate) {
    const std::vector<Box> boxes = {box(0, 8), box(2, 6, -1)};
    for (int depth = 1; depth <= 5; ++depth) {
        const SmallSolid solid = boxes_solid(boxes);
        const std::uint32_t words = blocks_needed(solid, depth);
        Labelling job;
        HeapPool pool(2000);
        const LabellingOutcome outcome = labelled(job, solid, depth, WindingRule::nonzero, words, &*pool);
        const DenseGrid grid = make_grid(depth, [&](const Point& p, std::int32_t side) {
            return box_colour(boxes, WindingRule::nonzero, p, side);
        });
        EXPECT_EQ(digest(outcome.built.tree), expected_digest(grid)) << "depth " << depth;
        EXPECT_EQ(outcome.components, depth < 3 ? 1U : 3U) << "outside, solid, room";
        EXPECT_EQ(grid.volume(Colour::boundary) == 0, depth >= 3);
    }
}

TEST(Labelling, TunnelsObtuseAndObliqueFaces) {
    for (int axis = 0; axis < 3; ++axis) {
        const Tunnel tunnel = {{{{at(1), at(2), at(3)}}, {{at(13), at(14), at(12)}}},
                               {{{300007, 350001, 400003}}, {{600001, 610007, 640009}}},
                               axis};
        expect_same_as_divide_and_conquer(tunnel_solid(tunnel), 5);
        const Diamond diamond = {{{524288, 500001, 480003}}, 300007, axis, 90001, 900011};
        expect_same_as_divide_and_conquer(diamond_solid(diamond), 5);
    }
    const SmallSolid octahedron = octahedron_solid({{{at(8), at(8), at(8)}}, at(6)});
    expect_same_as_divide_and_conquer(octahedron, 5);
    expect_same_as_divide_and_conquer(octahedron.triangulated().inverted(), 5);
    SmallSolid crowd = octahedron_solid({{{700001, 300003, 600005}}, 123456});
    crowd.add(octahedron_solid({{{600001, 350003, 650005}}, 200001}).shuffled(7));
    crowd.add(boxes_solid({{{{100001, 90003, 120005}}, {{600007, 500009, 400011}}}, box(5, 11, -1)}));
    expect_same_as_divide_and_conquer(crowd, 5);
}

TEST(Labelling, LeavesOfSideOne) {
    const SmallSolid solid = octahedron_solid({{{root_side / 2 + 1, root_side / 2 - 1, root_side / 2}}, 5});
    Labelling job;
    const std::uint32_t blocks = blocks_needed(solid, max_depth);
    HeapPool pool(5000);
    HeapPool expected(5000);
    const TreeOutcome divided = converted(solid, {max_depth}, &*expected);
    const LabellingOutcome outcome = labelled(job, solid, max_depth, WindingRule::nonzero, blocks, &*pool);
    ASSERT_EQ(outcome.built.status, Status::ok);
    EXPECT_TRUE(same_leaves(outcome.built.tree, divided.tree));
}

// Half an octant: classified exactly, as the 8-fold grid of its cells says for a box's faces.
TEST(Labelling, BlocksAreHalvesOfOctants) {
    Block block = {root_octant.corner, 0};
    std::uint64_t volume = root_volume;
    for (unsigned level = 0; level < max_block_level; ++level) {
        EXPECT_EQ(static_cast<std::uint64_t>(block.side(0)) * static_cast<std::uint64_t>(block.side(1)) *
                      static_cast<std::uint64_t>(block.side(2)),
                  volume);
        const unsigned high = level % 5 == 1 ? 1U : 0U;
        const Block half = block.half(high);
        EXPECT_EQ(half.is_high(), high == 1);
        EXPECT_EQ(half.parent().corner, block.corner);
        EXPECT_EQ(half.side(block.axis()), block.half_side());
        block = half;
        volume /= 2;
    }
}

// The rule that the outside is white and all else black, on a dense grid: cells that the surface leaves free,
// filled from the root's first corner.
DenseGrid filled_from_outside(const DenseGrid& truth) {
    DenseGrid grid(truth.depth());
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        grid[cell] = truth[cell] == Colour::boundary ? Colour::boundary : Colour::black;
    }
    std::map<std::vector<std::int32_t>, std::size_t> cell_at;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const Point corner = grid.corner(cell);
        cell_at[{corner.x(), corner.y(), corner.z()}] = cell;
    }
    std::vector<std::size_t> reached = {0};
    grid[0] = Colour::white;
    while (!reached.empty()) {
        const Point corner = grid.corner(reached.back());
        reached.pop_back();
        for (std::size_t way = 0; way < 6; ++way) {
            std::vector<std::int32_t> next = {corner.x(), corner.y(), corner.z()};
            next[way / 2] += way % 2 == 0 ? grid.cell_side() : -grid.cell_side();
            const auto to = cell_at.find(next);
            if (to == cell_at.end() || grid[to->second] != Colour::black) continue;
            grid[to->second] = Colour::white;
            reached.push_back(to->second);
        }
    }
    return grid;
}

TEST(Labelling, FillingByConnectivityIsRightForOneShellOnly) {
    struct Case {
        std::vector<Box> boxes;
        WindingRule rule;
        bool naive_is_right;
    };
    const Box outer = {{{90001, 90001, 90001}}, {{950001, 950001, 950001}}};
    const Box inner = {{{300001, 300001, 300001}}, {{750001, 750001, 750001}}, -1};
    const Box beside = {{{600001, 600001, 600001}}, {{1000001, 1000001, 1000001}}};
    const Case cases[] = {
        {{outer}, WindingRule::nonzero, true},
        {{outer, inner}, WindingRule::nonzero, false},                  // a cavity is filled
        {{inner, beside}, WindingRule::odd, false},                     // where two parts overlap
        {{inner}, WindingRule::positive, false},                        // a shell turned inside out
        {{outer, {inner.low, inner.high}}, WindingRule::nonzero, true}, // twice inside is inside
    };
    for (const Case& of : cases) {
        const DenseGrid truth = make_grid(
            4, [&](const Point& p, std::int32_t side) { return box_colour(of.boxes, of.rule, p, side); });
        const SmallSolid solid = boxes_solid(of.boxes);
        Labelling job;
        HeapPool pool(5000);
        const LabellingOutcome outcome = labelled(job, solid, 4, of.rule, blocks_needed(solid, 4), &*pool);
        EXPECT_EQ(digest(outcome.built.tree), expected_digest(truth));
        EXPECT_EQ(filled_from_outside(truth) == truth, of.naive_is_right);
    }
}

TEST(Labelling, EveryScratchAndEveryPoolSize) {
    const SmallSolid solid =
        boxes_solid({box(1, 15), {{{300001, 300001, 300001}}, {{750001, 700001, 400001}}, -1}});
    const std::uint32_t blocks = blocks_needed(solid, 3);
    Labelling job;
    const std::uint32_t nodes =
        labelled(job, solid, 3, WindingRule::nonzero, blocks, nullptr).built.nodes_needed;
    ASSERT_GT(nodes, 5U);
    for (std::uint32_t size = 0; size < blocks; ++size) {
        HeapPool pool(nodes + 3);
        pool.fill_to(3);
        const PoolImage before(pool);
        const LabellingOutcome outcome = labelled(job, solid, 3, WindingRule::nonzero, size, &*pool);
        ASSERT_EQ(outcome.built.status, Status::scratch_too_small);
        ASSERT_EQ(outcome.blocks_needed, blocks);
        ASSERT_TRUE(before.same_nodes(pool));
    }
    for (std::uint32_t room = 0; room <= nodes; ++room) {
        HeapPool pool(3 + room);
        pool.fill_to(3);
        const PoolImage before(pool);
        const LabellingOutcome outcome = labelled(job, solid, 3, WindingRule::nonzero, blocks, &*pool);
        ASSERT_EQ(outcome.built.status, room < nodes ? Status::pool_exhausted : Status::ok);
        ASSERT_EQ(outcome.built.nodes_missing, nodes - room);
        ASSERT_EQ(before.same_nodes(pool), room < nodes);
    }
}

TEST(Labelling, StepsOfEverySizeAndGivingUp) {
    const SmallSolid solid =
        boxes_solid({box(1, 15), {{{300001, 300001, 300001}}, {{750001, 700001, 400001}}, -1}});
    const std::uint32_t blocks = blocks_needed(solid, 3);
    Words run(solid, blocks);
    std::vector<std::uint64_t> digests;
    for (const std::uint32_t steps : {1U, 2U, 7U, 1000U, UINT32_MAX}) {
        HeapPool pool(1000);
        Labelling job;
        ASSERT_EQ(run.begin(job, solid, 3, WindingRule::nonzero, &*pool), Status::ok);
        EXPECT_TRUE(job.step(0));
        while (job.step(steps)) {
        }
        EXPECT_FALSE(job.step(steps));
        const LabellingOutcome outcome = job.finish();
        digests.push_back(digest(outcome.built.tree) + job.blocks_visited() + job.pairs_visited());
    }
    EXPECT_EQ(digests, std::vector<std::uint64_t>(digests.size(), digests[0]));
    HeapPool pool(1000);
    pool.fill_to(3);
    const PoolImage before(pool);
    Labelling job;
    for (std::uint32_t steps = 0;; steps += 5) {
        ASSERT_EQ(run.begin(job, solid, 3, WindingRule::nonzero, &*pool), Status::ok);
        if (!job.step(steps)) break;
        ASSERT_EQ(job.finish().built.status, Status::unfinished);
        ASSERT_FALSE(job.step(1));
        ASSERT_EQ(job.finish().built.status, Status::unfinished);
        ASSERT_TRUE(before.same_nodes(pool));
    }
    const LabellingOutcome outcome = job.finish(); // of a job that had others before
    EXPECT_EQ(digest(outcome.built.tree) + job.blocks_visited() + job.pairs_visited(), digests[0]);
    EXPECT_EQ(job.finish().built.status, Status::ok);
}

// Given up before it is known how many blocks there are, a labelling never says that they did not fit.
TEST(Labelling, GivenUpWithTooFewWordsItStaysUnfinished) {
    const SmallSolid solid = boxes_solid({box(1, 15)});
    Words run(solid, 3);
    Labelling job;
    HeapPool pool(1000);
    ASSERT_EQ(run.begin(job, solid, 3, WindingRule::nonzero, &*pool), Status::ok);
    ASSERT_TRUE(job.step(20));
    for (int time = 0; time < 2; ++time) EXPECT_EQ(job.finish().built.status, Status::unfinished);
    ASSERT_EQ(run.begin(job, solid, 3, WindingRule::nonzero, &*pool), Status::ok);
    while (job.step(UINT32_MAX)) {
    }
    for (int time = 0; time < 2; ++time) EXPECT_EQ(job.finish().built.status, Status::scratch_too_small);
}

TEST(Labelling, Refusals) {
    const SmallSolid solid = boxes_solid({box(1, 15)});
    Labelling job;
    EXPECT_EQ(job.finish().built.status, Status::unfinished);
    for (const int depth : {-1, 0, 21}) {
        EXPECT_EQ(labelled(job, solid, depth, WindingRule::nonzero, 9, nullptr).built.status,
                  Status::depth_out_of_range);
    }
    Words run(solid, 9);
    EXPECT_EQ(
        job.begin(solid.checked(), 3, WindingRule::odd, run.faces.data(), 5, run.blocks.data(), 9, nullptr),
        Status::scratch_too_small);
    EXPECT_FALSE(job.step(1));
}

// The size is an upper bound: more than there can be blocks is as good as enough.
TEST(Labelling, WordsOfEveryNumberThatCanBeStated) {
    const SmallSolid solid = boxes_solid({box(1, 15)});
    HeapPool expected(1000);
    const TreeOutcome divided = converted(solid, {3}, &*expected);
    Words run(solid, blocks_needed(solid, 3));
    for (const std::uint32_t size : {UINT32_MAX - 2, UINT32_MAX - 1, UINT32_MAX}) {
        HeapPool pool(1000);
        Labelling job;
        ASSERT_EQ(job.begin(solid.checked(), 3, WindingRule::nonzero, run.faces.data(),
                            static_cast<std::uint32_t>(run.faces.size()), run.blocks.data(), size, &*pool),
                  Status::ok);
        while (job.step(1000)) {
        }
        EXPECT_TRUE(same_leaves(job.finish().built.tree, divided.tree));
    }
}

// Whether a rectangle along the axes meets an open block.
bool rectangle_meets(const Polygon& rectangle, const Block& block) {
    for (int axis = 0; axis < 3; ++axis) {
        std::int32_t low = rectangle[0].at[axis];
        std::int32_t high = low;
        for (const Point& corner : rectangle) {
            low = std::min(low, corner.at[axis]);
            high = std::max(high, corner.at[axis]);
        }
        const std::int32_t start = block.corner.at[axis];
        const std::int32_t end = start + block.side(axis);
        if (low == high ? low <= start || low >= end : low >= end || high <= start) return false;
    }
    return true;
}

// A block is asked about the faces that meet the one above it, and each answer is counted once.
TEST(Labelling, EveryAnswerIsCountedAtItsStage) {
    const SmallSolid solid = boxes_solid({box(1, 15)});
    constexpr int depth = 2;
    Words run(solid, blocks_needed(solid, depth));
    Labelling job;
    ASSERT_EQ(run.begin(job, solid, depth, WindingRule::nonzero, nullptr), Status::ok);
    while (job.step(1000)) {
    }
    std::uint64_t accepted = 0;
    std::uint64_t rejected = 0;
    std::vector<std::pair<Block, std::uint32_t>> blocks = {{{root_octant.corner, 0}, solid.face_count()}};
    while (!blocks.empty()) {
        const auto [block, asked] = blocks.back();
        blocks.pop_back();
        std::uint32_t met = 0;
        for (const auto& face : solid.faces()) met += rectangle_meets(face[0], block) ? 1U : 0U;
        accepted += met;
        rejected += asked - met;
        if (met == 0 || block.level == 3 * depth) continue;
        for (const unsigned high : {0U, 1U}) blocks.push_back({block.half(high), met});
    }
    for (int stage = 0; stage < stage_count; ++stage) {
        accepted -= job.stages().accepted[stage];
        rejected -= job.stages().rejected[stage];
    }
    EXPECT_EQ(accepted, 0U);
    EXPECT_EQ(rejected, 0U);
}

} // namespace

} // namespace osem::tests
