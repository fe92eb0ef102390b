// Scenarios of the bintree, and of what fits a number of nodes.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

// Where the blocks outgrow the words they are only counted.
std::uint64_t labelled_blocks() {
    Digest digest;
    std::uint32_t faces[32];
    std::uint32_t words[128];
    for (int depth = 1; depth <= 4; ++depth) {
        pool.roll_back(0);
        auto& job = fresh<Labelling>();
        const LabellingOutcome outcome =
            convert_by_labelling(job, CheckedSolid::vouched(nested_shells()), depth, WindingRule::odd, faces,
                                 32, words, 128, &pool);
        add(digest, outcome.built);
        digest.add(outcome.blocks_needed);
        digest.add(outcome.components);
        digest.add(job.blocks_visited());
        digest.add(job.pairs_visited());
    }
    return digest.value();
}

std::uint64_t finest_fits() {
    Digest digest;
    std::uint32_t faces[32];
    constexpr std::uint32_t rooms[] = {0, 9, 60, 400, pool_capacity};
    for (const std::uint32_t room : rooms) {
        pool.roll_back(0);
        ConvertOptions options;
        options.depth = 6;
        NodeIndex first = 0;
        const Node filler = Node::of(0x12, 0x12, 0);
        while (pool.used() + room < pool_capacity) static_cast<void>(pool.append(&filler, 1, first));
        const FitOutcome outcome =
            fit(fresh<Fitting>(), CheckedSolid::vouched(octahedron()), options, faces, 32, pool);
        add(digest, outcome.built);
        digest.add(outcome.octants_visited);
    }
    return digest.value();
}

std::uint64_t pruned_trees() {
    Digest digest;
    ConvertOptions options;
    options.depth = 4;
    pool.roll_back(0);
    const Octree tree = converted(plate(), options).tree;
    const std::uint32_t all = pool.used();
    for (std::uint32_t budget = 0; budget <= all; budget += 13) {
        pool.roll_back(all);
        auto& job = fresh<Pruning>();
        const PruneOutcome outcome = prune(job, tree, budget, &pool);
        add(digest, outcome.built);
        digest.add(outcome.inner_lost);
        digest.add(outcome.outer_gained);
        digest.add(outcome.above_optimum);
        digest.add(job.nodes_visited());
    }
    return digest.value();
}

} // namespace osem::cross
