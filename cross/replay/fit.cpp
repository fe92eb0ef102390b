// Conversions by labelling, conversions at the finest depth that fits, and trees coarsened to a budget.
#include "osem/fit.hpp"
#include "osem/bintree.hpp"

#include "planted_tree.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

// A job's question, up to the tree.
struct Question {
    ConvertOptions options;
    std::uint32_t room;
    std::uint8_t depth; ///< of the result
    TreeTruth truth;
};

Question read_question(Reader& reader) {
    Question question = {};
    question.options = read_options(reader);
    question.room = reader.u32();
    question.depth = reader.u8();
    question.truth = read_tree_truth(reader);
    return question;
}

void compare_built(Reader& reader, Report& report, const Question& question, const TreeOutcome& built,
                   const NodePool& pool) {
    if (!report.expect("status", static_cast<int>(Status::ok), static_cast<int>(built.status))) {
        skip_tree(reader, question.truth);
        return;
    }
    report.expect("depth", question.depth, built.tree.depth);
    report.expect("nodes needed", question.truth.pool_nodes(), built.nodes_needed);
    report.expect("nodes used", question.truth.pool_nodes(), pool.used());
    compare_tree(reader, report, question.truth, built.tree, question.options.leaves);
}

void give_up(Reader& reader, Report& report, const Question& question) {
    report.too_large();
    skip_tree(reader, question.truth);
}

LabellingOutcome labelled(Labelling& job, const Solid& solid, const ConvertOptions& options,
                          std::uint32_t* faces, std::uint32_t* blocks, std::uint32_t size, NodePool* pool) {
    return convert_by_labelling(job, CheckedSolid::vouched(solid), options.depth, options.winding, faces,
                                convert_scratch(solid), blocks, size, pool);
}

// The blocks are counted first.
void replay_labelling(Reader& reader, Arena& arena, Report& report, const Solid& solid) {
    const Question question = read_question(reader);
    const ArenaScope scope(arena);
    Node* const memory = take_nodes(arena, question.room);
    auto* const job = arena.take<Labelling>(1);
    auto* const faces = arena.take<std::uint32_t>(convert_scratch(solid));
    if (memory == nullptr || job == nullptr || faces == nullptr) return give_up(reader, report, question);
    const LabellingOutcome counted = labelled(*job, solid, question.options, faces, nullptr, 0, nullptr);
    auto* const blocks = arena.take<std::uint32_t>(counted.blocks_needed);
    if (blocks == nullptr) return give_up(reader, report, question);
    report.begin_case();
    NodePool pool(memory, question.room);
    const LabellingOutcome outcome =
        labelled(*job, solid, question.options, faces, blocks, counted.blocks_needed, &pool);
    report.expect("blocks", counted.blocks_needed, outcome.blocks_needed);
    compare_built(reader, report, question, outcome.built, pool);
}

void replay_fitting(Reader& reader, Arena& arena, Report& report, const Solid& solid) {
    const Question question = read_question(reader);
    const ArenaScope scope(arena);
    Node* const memory = take_nodes(arena, question.room);
    auto* const job = arena.take<Fitting>(1);
    auto* const faces = arena.take<std::uint32_t>(convert_scratch(solid));
    if (memory == nullptr || job == nullptr || faces == nullptr) return give_up(reader, report, question);
    report.begin_case();
    NodePool pool(memory, question.room);
    const FitOutcome outcome =
        fit(*job, CheckedSolid::vouched(solid), question.options, faces, convert_scratch(solid), pool);
    compare_built(reader, report, question, outcome.built, pool);
}

bool replay_solid(Reader& reader, Arena& arena, Report& report) {
    Solid solid = {};
    if (!read_solid(reader, arena, solid)) return false;
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        const auto replay = reader.u8() == job_labelling ? replay_labelling : replay_fitting;
        replay(reader, arena, report, solid);
    }
    return true;
}

// Every leaf of the one tree lies in a leaf of the other one, or holds such leaves: so looking from the
// corners of both trees' leaves compares all cells.
void compare_certified(Report& report, const Octree& before, const Octree& after) {
    Leaf leaf = {};
    for (LeafWalk walk(before); walk.next(leaf);) {
        const Colour colour = leaf_at(after, leaf.octant.corner).leaf.colour;
        const bool certified = colour == leaf.colour || colour == Colour::boundary;
        report.expect("a leaf keeps its colour or is boundary", 1, certified ? 1 : 0);
    }
    for (LeafWalk walk(after); walk.next(leaf);) {
        const Colour colour = leaf_at(before, leaf.octant.corner).leaf.colour;
        const bool certified = colour == leaf.colour || leaf.colour == Colour::boundary;
        report.expect("a leaf has the colour that it had or is boundary", 1, certified ? 1 : 0);
    }
}

struct Volumes {
    std::uint64_t inner;
    std::uint64_t outer;
};

void compare_losses(Report& report, const Volumes& before, const PruneOutcome& outcome, std::uint64_t least) {
    const Measures after = measure(outcome.built.tree);
    const std::uint64_t lost = outcome.inner_lost + outcome.outer_gained;
    report.expect("inner volume lost", static_cast<std::int64_t>(before.inner - after.inner_volume),
                  static_cast<std::int64_t>(outcome.inner_lost));
    report.expect("outer volume gained", static_cast<std::int64_t>(after.outer_volume - before.outer),
                  static_cast<std::int64_t>(outcome.outer_gained));
    if (least == 0) {
        report.expect("the optimum is said to be met", 0,
                      static_cast<std::int64_t>(lost + outcome.above_optimum));
    }
    report.expect("no less lost than the least", 1, lost >= least ? 1 : 0);
    report.expect("the least within the bound", 1, lost - least <= outcome.above_optimum ? 1 : 0);
}

void replay_pruning(Reader& reader, Arena& arena, Report& report, const Octree& tree,
                    const Volumes& volumes) {
    const std::uint32_t budget = reader.u32();
    const std::uint64_t least = reader.u64();
    const ArenaScope scope(arena);
    Node* const memory = take_nodes(arena, budget);
    auto* const job = arena.take<Pruning>(1);
    if (memory == nullptr || job == nullptr) return report.too_large();
    report.begin_case();
    NodePool pool(memory, budget);
    const PruneOutcome outcome = prune(*job, tree, budget, &pool);
    if (!report.expect("status", static_cast<int>(Status::ok), static_cast<int>(outcome.built.status))) {
        return;
    }
    report.expect("nodes used", outcome.built.nodes_needed, pool.used());
    compare_certified(report, tree, outcome.built.tree);
    compare_losses(report, volumes, outcome, least);
}

bool replay_prunings(Reader& reader, Arena& arena, Report& report) {
    const PlantedTree planted(reader, arena);
    if (!planted.fits()) return false;
    Volumes volumes = {};
    volumes.inner = reader.u64();
    volumes.outer = reader.u64();
    for (std::uint8_t left = reader.u8(); left > 0; --left) {
        replay_pruning(reader, arena, report, planted.tree(), volumes);
    }
    return true;
}

} // namespace

bool replay_fit(Reader& reader, Arena& arena, Report& report) {
    const bool is_solid = reader.u8() == operand_solid;
    return is_solid ? replay_solid(reader, arena, report) : replay_prunings(reader, arena, report);
}

} // namespace osem::cross
