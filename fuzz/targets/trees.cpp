// Sequences of operations on trees of one pool, each tree beside a dense grid: Booleans, transforms, pruning,
// compaction, roll-back, and questions. Pools start small, so operations run out of room in between; jobs are
// given up and begun again.
#include <algorithm>
#include <vector>

#include "osem/boolean.hpp"
#include "osem/fit.hpp"
#include "osem/transform.hpp"
#include "support/any_grid.hpp"
#include "support/forest.hpp"
#include "support/losses.hpp"
#include "support/questions.hpp"
#include "support/target.hpp"
#include "support/transforms.hpp"

namespace osem::fuzz {

namespace {

constexpr int most_depth = 4; ///< of the grids: cells are looked at one by one
constexpr std::size_t most_trees = 5;

struct Jobs {
    Combination combination;
    Translation translation;
    Reorientation reorientation;
    Coarsening coarsening;
    Pruning pruning;
};

/// Runs a job to its end; at times it is begun and given up before, and its nodes counted.
template <class Job, class Begin>
TreeOutcome run(Job& job, Choices& choices, const Begin& begin) {
    std::uint32_t counted = 0;
    const std::uint32_t kind = choices.below(8);
    if (kind == 0) {
        EXPECT_EQ(begin(job, true), Status::ok);
        step_through(job, choices);
        const TreeOutcome outcome = job.finish();
        if (outcome.status != Status::ok) return outcome;
        counted = outcome.nodes_needed;
    }
    if (kind == 1) {
        EXPECT_EQ(begin(job, false), Status::ok);
        job.step(choices.byte());
    }
    EXPECT_EQ(begin(job, false), Status::ok);
    step_through(job, choices);
    const TreeOutcome outcome = job.finish();
    if (kind == 0 && outcome.status == Status::ok) {
        EXPECT_EQ(outcome.nodes_needed, counted);
    }
    return outcome;
}

void plant(Forest& forest, Choices& choices) {
    const tests::DenseGrid grid = any_grid(1 + static_cast<int>(choices.below(most_depth)), choices);
    const bool by_cells = choices.below(8) == 0;
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        return by_cells ? tests::plant_by_cells(grid, &pool) : tests::plant(grid, &pool);
    });
    forest.add(outcome.tree, grid);
}

void combine_two(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    const std::size_t b = forest.any(choices);
    const auto op = static_cast<Operator>(choices.below(4));
    const bool at_once = choices.below(4) == 0;
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        if (at_once) return combine(jobs.combination, op, forest[a].tree, forest[b].tree, pool);
        return run(jobs.combination, choices, [&](Combination& job, bool count) {
            return job.begin(op, forest[a].tree, forest[b].tree, pool, count);
        });
    });
    const tests::DenseGrid expected = tests::combined(op, forest[a].grid, forest[b].grid);
    EXPECT_EQ(outcome.tree.depth, std::max(forest[a].tree.depth, forest[b].tree.depth));
    forest.add(outcome.tree, expected);
}

void complement_one(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    const TreeOutcome outcome =
        forest.build([&](NodePool& pool) { return complement(jobs.combination, forest[a].tree, pool); });
    forest.add(outcome.tree, tests::complemented(forest[a].grid));
}

Placement any_placement(Choices& choices) {
    constexpr std::int32_t unit = root_side >> most_depth;
    Placement placement;
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint8_t by = choices.byte();
        placement.by.at[axis] = by < 128 ? 0 : (by % 39 - 19) * unit;
        if (choices.below(4) != 0) continue;
        const std::int32_t from = choices.between(0, 15);
        placement.keep.low.at[axis] = from * unit;
        placement.keep.high.at[axis] = choices.between(from + 1, 16) * unit;
    }
    placement.cut_at_root = choices.flag();
    placement.mixed_as_boundary = choices.flag();
    placement.depth = static_cast<std::uint8_t>(choices.below(4) != 0 ? 0 : choices.below(22));
    return placement;
}

void place(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    const Placement placement = any_placement(choices);
    const int exact = placed_depth(forest[a].tree.depth, placement);
    Status expected = Status::ok;
    if (placement.depth != 0 && placement.depth < exact && !placement.mixed_as_boundary) {
        expected = Status::depth_too_coarse;
    }
    if (placement.depth > max_depth) expected = Status::depth_out_of_range;
    if (expected != Status::ok) {
        EXPECT_EQ(jobs.translation.begin(forest[a].tree, placement, *forest.pool()), expected);
        return;
    }
    tests::DenseGrid grid =
        tests::placed(forest[a].grid, placement, tests::exact_depth(forest[a].grid, placement));
    const bool refused = !placement.cut_at_root && tests::leaves_root(forest[a].grid, placement.by);
    const bool at_once = choices.below(4) == 0;
    const TreeOutcome outcome = forest.build(
        [&](NodePool& pool) {
            if (at_once) return translate(jobs.translation, forest[a].tree, placement, pool);
            return run(jobs.translation, choices, [&](Translation& job, bool count) {
                return job.begin(forest[a].tree, placement, pool, count);
            });
        },
        refused ? Status::part_leaves_root : Status::ok);
    EXPECT_EQ(outcome.status, refused ? Status::part_leaves_root : Status::ok);
    if (refused) return;
    if (placement.depth != 0) grid = tests::coarse(grid, placement.depth, Coarse::certified);
    forest.add(outcome.tree, grid);
}

/// The colour of the cells of an octant after a move, those that come from outside of the root being white.
Colour moved_colour(const tests::DenseGrid& grid, const Point& by, const Point& corner, std::int32_t side) {
    std::int64_t first[3] = {};
    std::int64_t last[3] = {};
    const std::int64_t cells = std::int64_t{1} << grid.depth();
    bool has_outside = false;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t low = std::int64_t{corner.at[axis]} - by.at[axis];
        const std::int64_t high = low + side;
        has_outside = has_outside || low < 0 || high > root_side;
        first[axis] = std::max(low, std::int64_t{0}) / grid.cell_side();
        last[axis] = std::min((high - 1) / grid.cell_side(), cells - 1);
        if (high <= 0 || low >= root_side) return Colour::white;
    }
    unsigned colours = has_outside ? 1U : 0U;
    Point p = {};
    for (std::int64_t z = first[2]; z <= last[2]; ++z) {
        for (std::int64_t y = first[1]; y <= last[1]; ++y) {
            for (std::int64_t x = first[0]; x <= last[0]; ++x) {
                p.at[0] = static_cast<std::int32_t>(x) * grid.cell_side();
                p.at[1] = static_cast<std::int32_t>(y) * grid.cell_side();
                p.at[2] = static_cast<std::int32_t>(z) * grid.cell_side();
                colours |= 1U << static_cast<unsigned>(grid.at(p));
            }
        }
    }
    return colours == 1U ? Colour::white : colours == 8U ? Colour::black : Colour::boundary;
}

/// A vector of any fineness, at a depth at which that leaves octants of several colours.
void place_finely(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    Placement placement;
    for (std::int32_t& at : placement.by.at)
        at = static_cast<std::int32_t>(choices.word()) >> choices.below(32);
    placement.cut_at_root = true;
    placement.mixed_as_boundary = true;
    placement.depth = static_cast<std::uint8_t>(1 + choices.below(3));
    const tests::DenseGrid expected =
        tests::make_grid(placement.depth, [&](const Point& corner, std::int32_t side) {
            return moved_colour(forest[a].grid, placement.by, corner, side);
        });
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        return run(jobs.translation, choices, [&](Translation& job, bool count) {
            return job.begin(forest[a].tree, placement, pool, count);
        });
    });
    forest.add(outcome.tree, expected);
}

void crop_one(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    const CellBox box = any_placement(choices).keep;
    Placement placement;
    placement.keep = box;
    const tests::DenseGrid grid =
        tests::placed(forest[a].grid, placement, tests::exact_depth(forest[a].grid, placement));
    const TreeOutcome outcome =
        forest.build([&](NodePool& pool) { return crop(jobs.translation, forest[a].tree, box, pool); });
    forest.add(outcome.tree, grid);
}

void expect_group(const Symmetry& a, const Symmetry& b, const Point& p) {
    EXPECT_TRUE(a.is_valid());
    EXPECT_EQ((a * b).point(p), a.point(b.point(p)));
    EXPECT_EQ((a * b).cell(p), a.cell(b.cell(p)));
    EXPECT_TRUE(a * a.inverse() == Symmetry::identity() && a.inverse() * a == Symmetry::identity());
    EXPECT_EQ((a * b).is_rotation(), a.is_rotation() == b.is_rotation());
}

void turn(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    Symmetry symmetry = Symmetry::nth(choices.below(48));
    expect_group(symmetry, Symmetry::nth(choices.below(48)), any_cell(most_depth, choices));
    if (choices.below(16) == 0) {
        symmetry = {{choices.byte(), symmetry.from[1], symmetry.from[2]}, choices.byte()};
        if (!symmetry.is_valid()) {
            EXPECT_EQ(jobs.reorientation.begin(forest[a].tree, symmetry, *forest.pool()),
                      Status::symmetry_invalid);
            return;
        }
    }
    const bool at_once = choices.below(4) == 0;
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        if (at_once) return reorient(jobs.reorientation, forest[a].tree, symmetry, pool);
        return run(jobs.reorientation, choices, [&](Reorientation& job, bool count) {
            return job.begin(forest[a].tree, symmetry, pool, count);
        });
    });
    forest.add(outcome.tree, tests::reoriented(forest[a].grid, symmetry));
}

void coarsen_one(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    const auto depth = static_cast<int>(choices.below(6));
    const auto mode = static_cast<Coarse>(choices.below(4));
    if (depth == 0) {
        EXPECT_EQ(jobs.coarsening.begin(forest[a].tree, depth, mode, *forest.pool()),
                  Status::depth_out_of_range);
        return;
    }
    const bool at_once = choices.below(4) == 0;
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        if (at_once) return coarsen(jobs.coarsening, forest[a].tree, depth, mode, pool);
        return run(jobs.coarsening, choices, [&](Coarsening& job, bool count) {
            return job.begin(forest[a].tree, depth, mode, pool, count);
        });
    });
    forest.add(outcome.tree, tests::coarse(forest[a].grid, depth, mode));
}

Octant any_part(Choices& choices) {
    Octant octant = root_octant;
    for (std::uint32_t down = choices.below(4); down > 0; --down) octant = octant.child(choices.below(8));
    return octant;
}

void enlarge(Forest& forest, Choices& choices) {
    const std::size_t a = forest.any(choices);
    Octant octant = any_part(choices);
    if (choices.below(16) == 0) octant.corner.at[choices.below(3)] += choices.between(-3, 3);
    const TreeOutcome outcome = enlarged(forest[a].tree, octant);
    EXPECT_EQ(outcome.status, is_octant(octant) ? Status::ok : Status::octant_invalid);
    if (outcome.status == Status::ok) forest.add(outcome.tree, tests::enlarged_grid(forest[a].grid, octant));
}

/// Into an octant, and out of it again.
void reduce(Forest& forest, Choices& choices) {
    const std::size_t a = forest.any(choices);
    Octant octant = any_part(choices);
    for (std::uint32_t down = choices.below(4) == 0 ? choices.below(18) : 0; down > 0; --down) {
        octant = octant.child(choices.below(8));
    }
    const bool too_deep = forest[a].tree.depth + octant.level > max_depth;
    const TreeOutcome outcome =
        forest.build([&](NodePool& pool) { return reduced(forest[a].tree, octant, pool); },
                     too_deep ? Status::depth_out_of_range : Status::ok);
    EXPECT_EQ(outcome.status == Status::ok, !too_deep);
    if (too_deep) return;
    EXPECT_EQ(measure(outcome.tree).inner_volume, forest[a].grid.volume(Colour::black) >> (3 * octant.level));
    EXPECT_TRUE(same_leaves(enlarged(outcome.tree, octant).tree, forest[a].tree));
    if (forest[a].grid.depth() + octant.level <= most_depth) {
        forest.add(outcome.tree, tests::reduced_grid(forest[a].grid, octant));
    }
}

void prune_one(Forest& forest, Jobs& jobs, Choices& choices) {
    const std::size_t a = forest.any(choices);
    if (measure(forest[a].tree).nodes > 150) return; // the model takes the square of it
    const tests::Losses least = tests::least_losses(forest[a].grid);
    const std::uint32_t budget = choices.below(160);
    const bool at_once = choices.below(4) == 0;
    PruneOutcome pruned = {};
    const TreeOutcome outcome = forest.build([&](NodePool& pool) {
        if (at_once) {
            pruned = prune(jobs.pruning, forest[a].tree, budget, &pool);
            return pruned.built;
        }
        jobs.pruning.begin(forest[a].tree, budget, &pool);
        step_through(jobs.pruning, choices);
        pruned = jobs.pruning.finish();
        return pruned.built;
    });
    EXPECT_LE(outcome.nodes_needed, budget);
    tests::DenseGrid result(forest[a].grid.depth());
    std::uint64_t inner = 0;
    std::uint64_t outer = 0;
    for (std::size_t cell = 0; cell < result.size(); ++cell) {
        result[cell] = leaf_at(outcome.tree, result.corner(cell)).leaf.colour;
        const Colour was = forest[a].grid[cell];
        if (result[cell] == was) continue;
        EXPECT_EQ(result[cell], Colour::boundary);
        (was == Colour::black ? inner : outer) += volume_at(result.depth());
    }
    EXPECT_EQ(pruned.inner_lost, inner);
    EXPECT_EQ(pruned.outer_gained, outer);
    const std::uint64_t best = least[std::min<std::size_t>(budget, least.size() - 1)];
    EXPECT_GE(inner + outer, best);
    EXPECT_LE(inner + outer - best, pruned.above_optimum);
    forest.add(outcome.tree, result);
}

/// The same nodes in a pool that is never written to.
void test_read_only(Forest& forest, std::size_t i) {
    const std::vector<Node> nodes = forest.pool().used_nodes();
    NodePool pool = NodePool::over(nodes.data(), static_cast<std::uint32_t>(nodes.size()));
    Octree tree = forest[i].tree;
    tree.pool = &pool;
    EXPECT_EQ(digest(tree), tests::expected_digest(forest[i].grid));
    EXPECT_TRUE(same_leaves(tree, forest[i].tree));
    const Node node = Node::of(1, 2, 0);
    NodeIndex first = 0;
    EXPECT_EQ(pool.append(&node, 1, first), Status::pool_exhausted);
    pool.roll_back(0);
    EXPECT_EQ(pool.used(), nodes.size());
    std::vector<std::uint32_t> scratch(compact_scratch(pool.used()));
    const Status status = compact(pool, &tree, 1, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
    EXPECT_EQ(status, nodes.empty() ? Status::ok : Status::pool_read_only);
}

void ask(Forest& forest, Choices& choices) {
    const std::size_t asked = forest.any(choices);
    const Forest::Entry& entry = forest[asked];
    switch (choices.below(12)) {
    case 0:
        return ask_point(entry, choices);
    case 1:
        return ask_box(entry, choices);
    case 2:
        return ask_segment(entry, choices);
    case 3:
        return ask_neighbour(entry, choices);
    case 4:
        return ask_nearest(entry, choices);
    case 5:
        return ask_collision(entry, forest[forest.any(choices)], choices);
    case 6:
        return ask_slice(entry, choices);
    case 7:
        return ask_measures(entry);
    case 8:
        return ask_moments(entry);
    case 9:
        return ask_surface(entry, choices);
    case 10:
        return test_read_only(forest, asked);
    default:
        return ask_components(entry, choices);
    }
}

void change(Forest& forest, Jobs& jobs, Choices& choices) {
    switch (choices.below(12)) {
    case 0:
        return plant(forest, choices);
    case 1:
    case 2:
        return combine_two(forest, jobs, choices);
    case 3:
        return complement_one(forest, jobs, choices);
    case 4:
        return place(forest, jobs, choices);
    case 5:
        return place_finely(forest, jobs, choices);
    case 6:
        return turn(forest, jobs, choices);
    case 7:
        return coarsen_one(forest, jobs, choices);
    case 8:
        return enlarge(forest, choices);
    case 9:
        return reduce(forest, choices);
    case 10:
        return prune_one(forest, jobs, choices);
    default:
        return crop_one(forest, jobs, choices);
    }
}

void tidy(Forest& forest, Choices& choices) {
    if (choices.flag()) return forest.roll_back_to(forest.any(choices));
    if (forest.size() > 1) forest.drop(forest.any(choices));
    forest.compact(choices);
}

} // namespace

void run(Choices& choices) {
    Jobs jobs;
    Forest forest(any_room(choices));
    plant(forest, choices);
    plant(forest, choices);
    for (int operations = 0; operations < 24 && !choices.done(); ++operations) {
        const std::uint32_t kind = choices.below(8);
        if (kind == 0 || forest.size() > most_trees) {
            tidy(forest, choices);
        } else if (kind < 5) {
            change(forest, jobs, choices);
        } else {
            ask(forest, choices);
        }
    }
    forest.expect_trees_whole();
}

} // namespace osem::fuzz
