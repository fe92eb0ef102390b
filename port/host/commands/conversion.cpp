#include "commands/conversion.hpp"

#include <algorithm>
#include <new>

#include "commands/estimate.hpp"
#include "commands/stopwatch.hpp"
#include "mesh/bad_input.hpp"
#include "osem/bintree.hpp"
#include "osem/fit.hpp"
#include "osem/grid_convert.hpp"

namespace osem::host {

namespace {

using Words = std::vector<std::uint32_t>;

std::uint32_t size_of(const Words& words) { return static_cast<std::uint32_t>(words.size()); }

const TreeOutcome& built(const TreeOutcome& outcome) { return outcome; }
const TreeOutcome& built(const LabellingOutcome& outcome) { return outcome.built; }

// What came of the pass that made a tree.
template <class Outcome>
struct Build {
    std::unique_ptr<HostPool> pool;
    Outcome outcome;
    double seconds;
};

// Runs a pass in a pool that is mostly large enough. If it is not, the pass has counted the nodes all the
// same, and another one has exactly the memory it needs.
template <class Run>
auto build(const CheckedSolid& solid, int depth, Run run) {
    const auto timed = [&run](std::unique_ptr<HostPool> pool) {
        const Stopwatch watch;
        auto outcome = run(pool->pool());
        return Build<decltype(outcome)>{std::move(pool), outcome, watch.seconds()};
    };
    auto first = timed(roomy_pool(estimate(solid.view(), depth).nodes()));
    if (built(first.outcome).status != Status::pool_exhausted) return first;
    return timed(std::make_unique<HostPool>(built(first.outcome).nodes_needed));
}

std::uint64_t bytes(std::size_t job, std::uint64_t words, std::uint64_t nodes) {
    return job + 4 * words + sizeof(Node) * nodes;
}

LabellingOutcome run_pass(Labelling& job, const CheckedSolid& solid, const ConvertOptions& options,
                          Words& faces, Words& blocks, NodePool* pool, Progress& progress) {
    require_converted(job.begin(solid, options.depth, options.winding, faces.data(), size_of(faces),
                                blocks.data(), size_of(blocks), pool));
    while (job.step(64)) progress.show(pool == nullptr ? 0 : 1, 2);
    return job.finish();
}

// A conversion that takes one array of scratch.
template <class Job>
auto build_by(Job& job, const CheckedSolid& solid, const ConvertOptions& options, Words& scratch,
              Progress& progress) {
    return build(solid, options.depth, [&](NodePool& pool) {
        require_converted(job.begin(solid, options, scratch.data(), size_of(scratch), &pool));
        drive(job, progress, 0, 1);
        return job.finish();
    });
}

} // namespace

void require_converted(Status status) {
    if (status != Status::ok) throw BadInput(describe(status));
}

std::size_t grid_words(const Solid& solid, int depth) {
    const std::uint64_t words = grid_scratch(solid, depth);
    if (words > UINT32_MAX) throw BadInput("too many faces for grids; --technique divide takes less memory");
    return static_cast<std::size_t>(words);
}

std::unique_ptr<HostPool> roomy_pool(std::uint64_t nodes) {
    try {
        return std::make_unique<HostPool>(std::min<std::uint64_t>(nodes, NodePool::max_capacity));
    } catch (const std::bad_alloc&) {
        return std::make_unique<HostPool>(0);
    }
}

Converted convert_by_grids(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<GridConversion>();
    Words scratch(grid_words(solid.view(), options.depth));
    auto made = build_by(*job, solid, options, scratch, progress);
    require_converted(made.outcome.status);
    return {std::move(made.pool),
            made.outcome.tree,
            made.seconds,
            StageCounts{},
            job->grids_visited(),
            bytes(sizeof(GridConversion), job->scratch_used(), made.outcome.nodes_needed),
            {{"scratch_words", job->scratch_used()}}};
}

Converted divide(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<Conversion>();
    Words faces(convert_scratch(solid.view()));
    auto made = build_by(*job, solid, options, faces, progress);
    require_converted(made.outcome.status);
    return {std::move(made.pool),
            made.outcome.tree,
            made.seconds,
            job->stages(),
            job->octants_visited(),
            bytes(sizeof(Conversion), faces.size(), made.outcome.nodes_needed),
            {}};
}

Converted divide_to_fit(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t nodes,
                        Progress& progress) {
    const auto job = std::make_unique<Fitting>();
    Words faces(convert_scratch(solid.view()));
    auto pool = std::make_unique<HostPool>(nodes);
    require_converted(job->begin(solid, options, faces.data(), size_of(faces), pool->pool()));
    Stopwatch watch;
    bool writing = false;
    while (job->step(64)) {
        if (job->writing() && !writing) watch = Stopwatch();
        writing = job->writing();
        const auto passes = static_cast<std::uint64_t>(options.depth) + 1;
        progress.show(writing ? passes - 1 : static_cast<std::uint64_t>(options.depth - job->depth()),
                      passes);
    }
    const double seconds = watch.seconds();
    const FitOutcome outcome = job->finish();
    require_converted(outcome.built.status);
    return {std::move(pool),
            outcome.built.tree,
            seconds,
            job->stages(),
            job->octants_visited(),
            bytes(sizeof(Fitting), faces.size(), nodes),
            {{"octants_in_all_passes", outcome.octants_visited}}};
}

// The first pass counts the blocks.
Converted label(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<Labelling>();
    Words faces(convert_scratch(solid.view()));
    Words blocks;
    blocks.resize(run_pass(*job, solid, options, faces, blocks, nullptr, progress).blocks_needed);
    auto made = build(solid, options.depth, [&](NodePool& pool) {
        return run_pass(*job, solid, options, faces, blocks, &pool, progress);
    });
    const LabellingOutcome& outcome = made.outcome;
    require_converted(outcome.built.status);
    return {std::move(made.pool),
            outcome.built.tree,
            made.seconds,
            job->stages(),
            job->blocks_visited(),
            bytes(sizeof(Labelling), faces.size() + blocks.size(), outcome.built.nodes_needed),
            {{"pairs", job->pairs_visited()},
             {"components", outcome.components},
             {"block_words", outcome.blocks_needed}}};
}

} // namespace osem::host
