#include "commands/conversion.hpp"

#include <algorithm>
#include <new>

#include "commands/estimate.hpp"
#include "commands/stopwatch.hpp"
#include "mesh/bad_input.hpp"
#include "osem/fit.hpp"
#include "osem/grid_convert.hpp"

namespace osem::host {

namespace {

using Words = std::vector<std::uint32_t>;

std::uint32_t size_of(const Words& words) { return static_cast<std::uint32_t>(words.size()); }

// Runs a pass, or two where the likely size was too low, and keeps the pool, the tree and the seconds.
template <class Run>
auto build(Converted& made, const CheckedSolid& solid, int depth, Run run) {
    made.pool = roomy_pool(estimate(solid.view(), depth).nodes());
    const auto outcome = run_with_room(made.pool, [&made, &run](NodePool& pool) {
        const Stopwatch watch;
        auto found = run(pool);
        made.seconds = watch.seconds();
        return found;
    });
    require_converted(tree_of(outcome).status);
    made.tree = tree_of(outcome).tree;
    return outcome;
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

// A conversion that takes one array of scratch. Returns the nodes.
template <class Job>
std::uint32_t build_by(Job& job, Converted& made, const CheckedSolid& solid, const ConvertOptions& options,
                       Words& scratch, Progress& progress) {
    const TreeOutcome outcome = build(made, solid, options.depth, [&](NodePool& pool) {
        require_converted(job.begin(solid, options, scratch.data(), size_of(scratch), &pool));
        drive(job, progress, 0, 1);
        return job.finish();
    });
    return outcome.nodes_needed;
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
    Converted made = {};
    const std::uint32_t nodes = build_by(*job, made, solid, options, scratch, progress);
    made.visited = job->grids_visited();
    made.memory = bytes(sizeof(GridConversion), job->scratch_used(), nodes);
    made.counts = {{"scratch_words", job->scratch_used()}};
    return made;
}

Converted divide(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<Conversion>();
    Words faces(convert_scratch(solid.view()));
    Converted made = {};
    const std::uint32_t nodes = build_by(*job, made, solid, options, faces, progress);
    made.stages = job->stages();
    made.visited = job->octants_visited();
    made.memory = bytes(sizeof(Conversion), faces.size(), nodes);
    return made;
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
    Converted made = {};
    const LabellingOutcome outcome = build(made, solid, options.depth, [&](NodePool& pool) {
        return run_pass(*job, solid, options, faces, blocks, &pool, progress);
    });
    made.stages = job->stages();
    made.visited = job->blocks_visited();
    made.memory = bytes(sizeof(Labelling), faces.size() + blocks.size(), outcome.built.nodes_needed);
    made.counts = {{"pairs", job->pairs_visited()},
                   {"components", outcome.components},
                   {"block_words", outcome.blocks_needed}};
    return made;
}

} // namespace osem::host
