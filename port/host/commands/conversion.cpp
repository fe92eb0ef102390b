#include "commands/conversion.hpp"

#include "commands/stopwatch.hpp"
#include "mesh/bad_input.hpp"
#include "osem/bintree.hpp"
#include "osem/fit.hpp"
#include "osem/grid_convert.hpp"

namespace osem::host {

namespace {

using Words = std::vector<std::uint32_t>;

std::uint32_t size_of(const Words& words) { return static_cast<std::uint32_t>(words.size()); }

template <class Job>
TreeOutcome run_pass(Job& job, const CheckedSolid& solid, const ConvertOptions& options, Words& scratch,
                     NodePool* pool, Progress& progress) {
    require_converted(job.begin(solid, options, scratch.data(), size_of(scratch), pool));
    drive(job, progress, pool == nullptr ? 0 : 1, 2);
    return job.finish();
}

std::uint64_t bytes(std::size_t job, std::uint64_t words, std::uint64_t nodes) {
    return job + 4 * words + sizeof(Node) * nodes;
}

LabellingOutcome run_pass(Labelling& job, const CheckedSolid& solid, const ConvertOptions& options,
                          Words& faces, Words& blocks, NodePool* pool, Progress& progress,
                          std::uint64_t pass) {
    require_converted(job.begin(solid, options.depth, options.winding, faces.data(), size_of(faces),
                                blocks.data(), size_of(blocks), pool));
    while (job.step(64)) progress.show(pass, 3);
    return job.finish();
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

Converted convert_by_grids(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<GridConversion>();
    Words scratch(grid_words(solid.view(), options.depth));
    const TreeOutcome counted = run_pass(*job, solid, options, scratch, nullptr, progress);
    auto pool = std::make_unique<HostPool>(counted.nodes_needed);
    const Stopwatch watch;
    const TreeOutcome outcome = run_pass(*job, solid, options, scratch, &pool->pool(), progress);
    const double seconds = watch.seconds();
    require_converted(outcome.status);
    return {std::move(pool),
            outcome.tree,
            seconds,
            StageCounts{},
            job->grids_visited(),
            bytes(sizeof(GridConversion), job->scratch_used(), counted.nodes_needed),
            {{"scratch_words", job->scratch_used()}}};
}

// Twice: the first pass only counts the nodes, so that the second has exactly the memory it needs.
Converted divide(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<Conversion>();
    Words faces(convert_scratch(solid.view()));
    const std::uint32_t nodes = run_pass(*job, solid, options, faces, nullptr, progress).nodes_needed;
    auto pool = std::make_unique<HostPool>(nodes);
    const Stopwatch watch;
    const TreeOutcome outcome = run_pass(*job, solid, options, faces, &pool->pool(), progress);
    const double seconds = watch.seconds();
    require_converted(outcome.status);
    return {std::move(pool),
            outcome.tree,
            seconds,
            job->stages(),
            job->octants_visited(),
            bytes(sizeof(Conversion), faces.size(), nodes),
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

// Three times: the first pass counts the blocks, the second the nodes.
Converted label(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress) {
    const auto job = std::make_unique<Labelling>();
    Words faces(convert_scratch(solid.view()));
    Words blocks;
    blocks.resize(run_pass(*job, solid, options, faces, blocks, nullptr, progress, 0).blocks_needed);
    const std::uint32_t nodes =
        run_pass(*job, solid, options, faces, blocks, nullptr, progress, 1).built.nodes_needed;
    auto pool = std::make_unique<HostPool>(nodes);
    const Stopwatch watch;
    const LabellingOutcome outcome =
        run_pass(*job, solid, options, faces, blocks, &pool->pool(), progress, 2);
    const double seconds = watch.seconds();
    require_converted(outcome.built.status);
    return {std::move(pool),
            outcome.built.tree,
            seconds,
            job->stages(),
            job->blocks_visited(),
            bytes(sizeof(Labelling), faces.size() + blocks.size(), nodes),
            {{"pairs", job->pairs_visited()},
             {"components", outcome.components},
             {"block_words", outcome.blocks_needed}}};
}

} // namespace osem::host
