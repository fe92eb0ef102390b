// Scenarios of conversion.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

void add(Digest& digest, const StageCounts& counts) {
    for (int stage = 0; stage < stage_count; ++stage) {
        digest.add(counts.rejected[stage]);
        digest.add(counts.accepted[stage]);
    }
}

// The tree at each depth that the pool holds, each on its own, up to one that it does not.
void add_depths(Digest& digest, const Solid& solid, LeafRule leaves, int greatest_depth) {
    ConvertOptions options;
    options.leaves = leaves;
    for (options.depth = 1; options.depth <= greatest_depth; ++options.depth) {
        pool.roll_back(0);
        add(digest, converted(solid, options));
        add(digest, conversion.stages());
        digest.add(conversion.octants_visited());
    }
}

// A grid conversion with its scratch, which is less than for certain would be enough.
struct GridRun {
    GridConversion job;
    std::uint32_t words[320];

    TreeOutcome convert(const Solid& solid, const ConvertOptions& options, int last_levels) {
        return osem::convert(job, CheckedSolid::vouched(solid), options, words, 320, &pool, {last_levels});
    }
};

// Of the trees, or of how these trees were made: that may change while they stay the same.
enum class OfGrids { trees, work };

void add(Digest& digest, OfGrids what, const TreeOutcome& outcome, const GridConversion& job) {
    if (what == OfGrids::trees) return add(digest, outcome);
    digest.add(job.grids_visited());
    digest.add(job.scratch_used());
}

void add_grid_depths(Digest& digest, OfGrids what, const Solid& solid, const ConvertOptions& deepest) {
    auto& run = fresh<GridRun>();
    ConvertOptions options = deepest;
    for (options.depth = 1; options.depth <= deepest.depth; ++options.depth) {
        pool.roll_back(0);
        add(digest, what, run.convert(solid, options, 1 + options.depth % 2), run.job);
    }
}

// In line, as the least of the parts has little stack.
[[gnu::always_inline]] inline std::uint64_t digest_of_grids(OfGrids what) {
    Digest digest;
    for (const auto leaves : {LeafRule::conservative, LeafRule::centre}) {
        add_grid_depths(digest, what, plate(), ConvertOptions{5, leaves});
        add_grid_depths(digest, what, octahedron(), ConvertOptions{6, leaves});
        for (const auto winding : {WindingRule::nonzero, WindingRule::odd, WindingRule::positive}) {
            add_grid_depths(digest, what, nested_shells(), ConvertOptions{4, leaves, winding});
        }
        const int deepest = leaves == LeafRule::centre ? max_depth - 1 : max_depth;
        const Solid soup = tetrahedra(11, Point{{root_side - 6, 0, root_side / 2 - 3}}, 6);
        auto& run = fresh<GridRun>();
        pool.roll_back(0);
        add(digest, what, run.convert(soup, {deepest, leaves}, 2), run.job);
    }
    return digest.value();
}

} // namespace

std::uint64_t plate_conservative() {
    Digest digest;
    add_depths(digest, plate(), LeafRule::conservative, 5);
    return digest.value();
}

std::uint64_t plate_centre() {
    Digest digest;
    add_depths(digest, plate(), LeafRule::centre, 5);
    return digest.value();
}

std::uint64_t octahedron_deep() {
    Digest digest;
    add_depths(digest, octahedron(), LeafRule::conservative, 6);
    add_depths(digest, octahedron(), LeafRule::centre, 6);
    return digest.value();
}

std::uint64_t shells_by_winding() {
    Digest digest;
    for (const auto leaves : {LeafRule::conservative, LeafRule::centre}) {
        for (const auto winding : {WindingRule::nonzero, WindingRule::odd, WindingRule::positive}) {
            pool.roll_back(0);
            ConvertOptions options;
            options.depth = 4;
            options.leaves = leaves;
            options.winding = winding;
            add(digest, converted(nested_shells(), options));
        }
    }
    return digest.value();
}

std::uint64_t soups() {
    Digest digest;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        for (const auto winding : {WindingRule::nonzero, WindingRule::odd, WindingRule::positive}) {
            pool.roll_back(0);
            ConvertOptions options;
            options.depth = 4;
            options.leaves = seed % 2 == 0 ? LeafRule::centre : LeafRule::conservative;
            options.winding = winding;
            const Point low = {{0, 0, 0}};
            add(digest, converted(tetrahedra(seed, low, root_side), options));
        }
    }
    return digest.value();
}

// Solids a few units wide, at the ends of the root and in its middle, down to leaves of side 1 and 2.
std::uint64_t unit_leaves() {
    Digest digest;
    std::uint32_t seed = 100;
    for (const std::int32_t at : {std::int32_t{0}, root_side - 6, root_side / 2 - 3}) {
        for (const auto leaves : {LeafRule::conservative, LeafRule::centre}) {
            pool.roll_back(0);
            ConvertOptions options;
            options.leaves = leaves;
            options.depth = leaves == LeafRule::centre ? max_depth - 1 : max_depth;
            add(digest, converted(tetrahedra(++seed, Point{{at, at, root_side - 6 - at}}, 6), options));
        }
    }
    return digest.value();
}

std::uint64_t small_steps() {
    Digest digest;
    const Solid solid = octahedron();
    std::uint32_t faces[8];
    ConvertOptions options;
    options.depth = 4;
    for (const std::uint32_t budget : {1U, 2U, 7U, 100U}) {
        pool.roll_back(0);
        digest.add(conversion.begin(CheckedSolid::vouched(solid), options, faces, 8, &pool));
        bool more = true;
        while (more) {
            more = conversion.step(budget);
            digest.add(more);
            digest.add(conversion.decided_volume());
            digest.add(conversion.octants_visited());
        }
        add(digest, conversion.finish());
    }
    return digest.value();
}

std::uint64_t small_pools() {
    Digest digest;
    const Solid solid = nested_shells();
    ConvertOptions options;
    options.depth = 3;
    Node memory[40];
    for (std::uint32_t capacity = 1; capacity <= 40; ++capacity) {
        NodePool small(memory, capacity);
        add(digest, converted(solid, options, &small));
        digest.add(small.used());
        digest.add(small.peak());
        digest.add(small.refused());
    }
    digest.add(converted(solid, options, nullptr).nodes_needed); // a counting pass
    return digest.value();
}

std::uint64_t conversions_by_grids() { return digest_of_grids(OfGrids::trees); }
std::uint64_t work_of_grids() { return digest_of_grids(OfGrids::work); }

} // namespace osem::cross
