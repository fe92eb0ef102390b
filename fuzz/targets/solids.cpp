// Solids, whole, nearly closed and broken: check against a model of it, and every conversion against the
// exact tree, node for node, by steps of any size, in pools and scratch of any size.
#include <algorithm>
#include <memory>
#include <vector>

#include "osem/bintree.hpp"
#include "osem/convert.hpp"
#include "osem/face_walk.hpp"
#include "osem/fit.hpp"
#include "osem/grid_convert.hpp"
#include "osem/query.hpp"
#include "osem/transform.hpp"
#include "support/any_solid.hpp"
#include "support/building.hpp"
#include "support/check_model.hpp"
#include "support/exact_tree.hpp"
#include "support/target.hpp"

namespace osem::fuzz {

namespace {

using Words = std::vector<std::uint32_t>;

/// How large a tree may be: more would take too long.
struct Limits {
    std::uint32_t levels; ///< below the window
    std::uint32_t octants;
};
constexpr Limits exact_limits = {5, 2500};  ///< where every octant is looked at by exact geometry
constexpr Limits plain_limits = {7, 12000}; ///< where the conversions are compared with one another

/// The same tree, at the same places of the pool.
void expect_same_nodes(const BuiltTree& a, const BuiltTree& b) {
    EXPECT_TRUE(a.outcome.tree.top == b.outcome.tree.top || a.before != b.before);
    EXPECT_EQ(a.outcome.nodes_needed, b.outcome.nodes_needed);
    EXPECT_EQ(a.outcome.tree.depth, b.outcome.tree.depth);
    EXPECT_TRUE(same_leaves(a.outcome.tree, b.outcome.tree));
    if (a.before == b.before) {
        EXPECT_TRUE(a.pool->used_nodes() == b.pool->used_nodes());
    }
}

/// Options under which the tree is small enough, the finest up to the one chosen.
bool choose_options(const CheckedSolid& solid, const Octant& window, const Limits& limits, Choices& choices,
                    ConvertOptions& options) {
    options.leaves = choices.below(3) == 0 ? LeafRule::centre : LeafRule::conservative;
    options.winding = static_cast<WindingRule>(choices.below(3));
    options.depth = std::min(window.level + 1 + static_cast<int>(choices.below(limits.levels)),
                             greatest_depth(options.leaves));
    Words faces(convert_scratch(solid.view()));
    for (; options.depth >= 1; --options.depth) {
        Conversion job;
        EXPECT_EQ(job.begin(solid, options, faces.data(), convert_scratch(solid.view()), nullptr),
                  Status::ok);
        if (!job.step(limits.octants)) return true;
    }
    return false;
}

BuiltTree by_octants(const CheckedSolid& solid, const ConvertOptions& options, Choices& choices) {
    Words faces(convert_scratch(solid.view()));
    const std::uint32_t size = convert_scratch(solid.view());
    Conversion job;
    return built(choices, [&](NodePool* pool) {
        EXPECT_EQ(job.begin(solid, options, faces.data(), size, pool), Status::ok);
        step_through(job, choices);
        return job.finish();
    });
}

BuiltTree by_grids(const CheckedSolid& solid, const ConvertOptions& options, const GridOptions& grids,
                   Choices& choices) {
    const int levels = options.depth - grids.octant.level;
    const auto enough = static_cast<std::uint32_t>(grid_scratch(solid.view(), levels, grids.last_levels));
    const std::uint32_t faces = solid.view().face_count;
    std::uint32_t size = choices.flag() ? enough : faces + choices.below(enough - faces + 1);
    GridConversion job;
    return built(choices, [&](NodePool* pool) {
        for (;; size = enough) {
            const std::uint32_t used = pool->used();
            Words scratch(size);
            Status status = job.begin(solid, options, scratch.data(), size, pool, grids);
            if (status == Status::ok) {
                step_through(job, choices);
                const TreeOutcome outcome = job.finish();
                EXPECT_LE(job.scratch_used(), enough);
                if (outcome.status != Status::scratch_too_small) return outcome;
                status = outcome.status;
            }
            EXPECT_EQ(status, Status::scratch_too_small);
            EXPECT_LT(size, enough);
            EXPECT_EQ(pool->used(), used);
        }
    });
}

BuiltTree by_labelling(const CheckedSolid& solid, const ConvertOptions& options, Choices& choices) {
    Words faces(convert_scratch(solid.view()));
    const std::uint32_t size = convert_scratch(solid.view());
    Labelling job;
    const auto run = [&](Words& blocks, NodePool* pool) {
        const auto count = static_cast<std::uint32_t>(blocks.size());
        if (choices.below(4) == 0) {
            return convert_by_labelling(job, solid, options.depth, options.winding, faces.data(), size,
                                        blocks.data(), count, pool);
        }
        EXPECT_EQ(
            job.begin(solid, options.depth, options.winding, faces.data(), size, blocks.data(), count, pool),
            Status::ok);
        step_through(job, choices);
        return job.finish();
    };
    Words blocks;
    const std::uint32_t needed = run(blocks, nullptr).blocks_needed;
    EXPECT_GT(needed, 0U);
    blocks.resize(choices.below(needed)); // too few
    EXPECT_EQ(run(blocks, nullptr).built.status, Status::scratch_too_small);
    blocks.resize(needed);
    return built(choices, [&](NodePool* pool) { return run(blocks, pool).built; });
}

/// The child that holds a smaller octant.
unsigned towards(const Octant& smaller, const Octant& octant) {
    unsigned child = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (smaller.corner.at[axis] >= octant.corner.at[axis] + octant.side() / 2) child |= 1U << axis;
    }
    return child;
}

/// A part of the root converted by itself is the subtree there.
void test_part(const CheckedSolid& solid, const ConvertOptions& options, const Octree& tree,
               const Octant& window, Choices& choices) {
    GridOptions grids;
    grids.last_levels = 1 + static_cast<int>(choices.below(most_grid_levels));
    const bool to_window = choices.below(4) != 0;
    while (grids.octant.level + 1 < options.depth &&
           (to_window ? grids.octant.level < window.level : choices.below(4) != 0)) {
        grids.octant = grids.octant.child(to_window ? towards(window, grids.octant) : choices.below(8));
    }
    const BuiltTree part = by_grids(solid, options, grids, choices);
    const TreeOutcome expected = enlarged(tree, grids.octant);
    EXPECT_EQ(expected.status, Status::ok);
    EXPECT_TRUE(same_leaves(part.outcome.tree, expected.tree));
    EXPECT_EQ(part.outcome.tree.depth, options.depth - grids.octant.level);
}

void test_fitting(const CheckedSolid& solid, const ConvertOptions& options, Choices& choices) {
    Words faces(convert_scratch(solid.view()));
    const std::uint32_t size = convert_scratch(solid.view());
    tests::HeapPool pool(any_room(choices));
    ConvertOptions finest = options;
    for (; finest.depth > 1; --finest.depth) {
        Conversion job;
        if (convert(job, solid, finest, faces.data(), size, nullptr).nodes_needed <= pool->capacity()) break;
    }
    Fitting job;
    EXPECT_EQ(job.begin(solid, options, faces.data(), size, *pool), Status::ok);
    if (choices.below(4) == 0 && job.step(choices.byte())) {
        EXPECT_EQ(job.finish().built.status, Status::unfinished);
        EXPECT_EQ(pool->used(), 0U);
        EXPECT_EQ(job.begin(solid, options, faces.data(), size, *pool), Status::ok);
    }
    step_through(job, choices);
    FitOutcome outcome = job.finish();
    if (choices.below(4) == 0) {
        pool->roll_back(0);
        outcome = fit(job, solid, options, faces.data(), size, *pool);
    }
    ASSERT_EQ(outcome.built.status, Status::ok);
    EXPECT_EQ(outcome.built.tree.depth, finest.depth);
    EXPECT_EQ(pool->used(), outcome.built.nodes_needed);
    const BuiltTree expected = by_octants(solid, finest, choices);
    EXPECT_TRUE(same_leaves(outcome.built.tree, expected.outcome.tree));
}

/// Conversions given up somewhere leave the pool as it was, and the job as good as new.
void test_giving_up(const CheckedSolid& solid, const ConvertOptions& options, Choices& choices) {
    Words faces(grid_scratch(solid.view(), options.depth));
    const auto size = static_cast<std::uint32_t>(faces.size());
    tests::HeapPool pool(any_room(choices));
    const tests::PoolImage image(pool);
    const std::uint32_t steps = choices.byte();
    Conversion octants;
    EXPECT_EQ(octants.begin(solid, options, faces.data(), size, &*pool), Status::ok);
    if (octants.step(steps)) {
        EXPECT_NE(octants.finish().status, Status::ok);
    }
    GridConversion grids;
    pool->roll_back(0);
    EXPECT_EQ(grids.begin(solid, options, faces.data(), size, &*pool), Status::ok);
    if (grids.step(steps % 8)) {
        EXPECT_NE(grids.finish().status, Status::ok);
        EXPECT_TRUE(image.same_nodes(pool));
    }
}

/// The faces that meet an octant, and winding numbers of reference points, asked of the walk itself.
void test_face_walk(const CheckedSolid& solid, const ExactSolid& exact, const Octant& window,
                    Choices& choices) {
    Words list(convert_scratch(solid.view()));
    std::vector<std::size_t> faces(exact.face_count());
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = i;
    FaceWalk walk;
    walk.begin(solid, list.data());
    Octant octant = root_octant;
    FaceFrame frame = {};
    std::uint32_t met = walk.face_count();
    std::int32_t winding = walk.winding_of_root();
    const int levels = std::min(window.level + 4, max_depth - 1);
    for (int level = 0; level < levels; ++level) {
        met = walk.select(octant, met);
        faces = exact.meeting(faces, octant);
        EXPECT_EQ(met, faces.size());
        for (std::uint32_t i = 0; i < met; ++i) EXPECT_EQ(std::count(faces.begin(), faces.end(), list[i]), 1);
        EXPECT_EQ(winding, exact.winding(perturbed(octant.corner)));
        EXPECT_EQ(walk.winding_at_centre(octant, met, winding), exact.winding(centre(octant, true)));
        frame.open(met, winding);
        const unsigned child = level < window.level ? towards(window, octant) : choices.below(8);
        winding = walk.winding_of_child(frame, octant, child);
        octant = octant.child(child);
    }
}

void test_conversions(const CheckedSolid& solid, const Octant& window, Choices& choices) {
    ConvertOptions options;
    const bool is_exact = choices.below(4) != 0;
    if (!choose_options(solid, window, is_exact ? exact_limits : plain_limits, choices, options)) return;
    const ExactSolid exact(solid.view());
    const BuiltTree octants = by_octants(solid, options, choices);
    if (is_exact) {
        EXPECT_EQ(digest(octants.outcome.tree), tests::expected_digest(exact_masks(exact, options)));
    }
    EXPECT_EQ(octants.outcome.tree.depth, options.depth);
    GridOptions grids;
    grids.last_levels = 1 + static_cast<int>(choices.below(most_grid_levels));
    expect_same_nodes(octants, by_grids(solid, options, grids, choices));
    if (options.leaves == LeafRule::conservative) {
        expect_same_nodes(octants, by_labelling(solid, options, choices));
    }
    test_part(solid, options, octants.outcome.tree, window, choices);
    test_giving_up(solid, options, choices);
    switch (choices.below(4)) {
    case 0:
        return test_fitting(solid, options, choices);
    case 1:
        return test_face_walk(solid, exact, window, choices);
    default:
        return;
    }
}

bool is_all_triangles(const tests::SmallSolid& solid) {
    for (const auto& rings : solid.faces()) {
        if (rings.size() != 1 || rings[0].size() != 3) return false;
    }
    return true;
}

} // namespace

void run(Choices& choices) {
    const std::uint32_t form = choices.below(8);
    const osem::Octant window = any_window(choices);
    const osem::tests::SmallSolid solid = any_solid(window, choices);
    SolidArrays arrays = arrays_of(solid, (form & 1U) != 0);
    if ((form & 2U) != 0 && is_all_triangles(solid)) arrays = as_mesh(arrays);
    if ((form & 4U) != 0) damage(arrays, choices);
    const osem::CheckOutcome outcome = checked_as_expected(arrays.view());
    if (outcome.status == osem::Status::ok) test_conversions(outcome.solid, window, choices);
}

} // namespace osem::fuzz
