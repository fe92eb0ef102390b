// Booleans on pairs of converted solids.
#include "osem/boolean.hpp"

#include "records.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

struct Operand {
    Octree tree;
    LeafRule rule;
    Status status;
};

// Reads a solid and converts it into the pool; its arrays are given back. False when they do not fit.
bool read_operand(Reader& reader, Arena& arena, NodePool& pool, Operand& operand) {
    const ArenaScope scope(arena);
    const ConvertOptions options = read_options(reader);
    Solid solid = {};
    if (!read_solid(reader, arena, solid)) return false;
    auto* faces = arena.take<std::uint32_t>(convert_scratch(solid));
    auto* job = faces == nullptr ? nullptr : arena.take<Conversion>(1);
    if (job == nullptr) return false;
    const TreeOutcome outcome =
        convert(*job, CheckedSolid::vouched(solid), options, faces, convert_scratch(solid), &pool);
    operand = Operand{outcome.tree, options.leaves, outcome.status};
    return true;
}

struct Pair {
    Operand a;
    Operand b;
};

// A tree by an operation of the record, only counted or built.
TreeOutcome combined(Combination& job, std::uint8_t operation, const Pair& pair, NodePool& pool, bool count) {
    const Octree all = Octree::uniform(pool, Colour::black);
    const bool complemented = operation == operation_complement;
    const Operator op = complemented ? Operator::subtract : static_cast<Operator>(operation);
    const Octree& left = complemented ? all : pair.a.tree;
    const Octree& right = complemented ? pair.a.tree : pair.b.tree;
    const Status status = job.begin(op, left, right, pool, count);
    if (status != Status::ok) return {status, 0, 0, all};
    while (job.step(UINT32_MAX)) {
    }
    return job.finish();
}

TreeOutcome built(Arena& arena, Report& report, std::uint8_t operation, const Pair& pair, NodePool& pool) {
    const ArenaScope scope(arena);
    auto& job = *arena.take<Combination>(1);
    const std::uint32_t mark = pool.used();
    const TreeOutcome counted = combined(job, operation, pair, pool, true);
    const TreeOutcome outcome = operation == operation_complement
                                    ? complement(job, pair.a.tree, pool)
                                    : combined(job, operation, pair, pool, false);
    report.expect("nodes counted", counted.nodes_needed, outcome.nodes_needed);
    report.expect("nodes used", counted.nodes_needed, pool.used() - mark);
    return outcome;
}

// The stream of a combined tree reaches shared nodes several times; the reader counts what it would write.
void replay_stream(Arena& arena, Report& report, const TreeTruth& truth, const Octree& tree, LeafRule rule) {
    const ArenaScope scope(arena);
    const StreamOutcome outcome = copied(tree, rule, *arena.take<StreamReader>(1), nullptr);
    report.expect("status of the stream", static_cast<int>(Status::ok),
                  static_cast<int>(outcome.built.status));
    report.expect("nodes of the stream", truth.pool_nodes(), outcome.built.nodes_needed);
}

void replay_row(Reader& reader, Arena& arena, Report& report, const Pair& pair, NodePool& pool) {
    report.begin_case();
    const std::uint8_t operation = reader.u8();
    const TreeTruth truth = read_tree_truth(reader);
    const std::uint32_t mark = pool.used();
    const Status operands = pair.a.status == Status::ok ? pair.b.status : pair.a.status;
    if (!report.expect("status of an operand", static_cast<int>(Status::ok), static_cast<int>(operands))) {
        skip_tree(reader, truth);
        return;
    }
    const TreeOutcome outcome = built(arena, report, operation, pair, pool);
    if (!report.expect("status of the operation", static_cast<int>(Status::ok),
                       static_cast<int>(outcome.status))) {
        skip_tree(reader, truth);
        return;
    }
    compare_tree(reader, report, truth, outcome.tree, pair.a.rule);
    replay_stream(arena, report, truth, outcome.tree, pair.a.rule);
    pool.roll_back(mark);
}

template <class Job>
bool has_room_for(Arena& arena) {
    const ArenaScope scope(arena);
    return arena.take<Job>(1) != nullptr;
}

} // namespace

bool replay_boolean(Reader& reader, Arena& arena, Report& report) {
    const std::uint32_t nodes = reader.u32();
    Node* memory = take_nodes(arena, nodes);
    if (memory == nullptr || !has_room_for<Combination>(arena) || !has_room_for<StreamReader>(arena)) {
        return false;
    }
    NodePool pool(memory, nodes);
    Pair pair = {};
    if (!read_operand(reader, arena, pool, pair.a)) return false;
    if (!read_operand(reader, arena, pool, pair.b)) return false;
    for (std::uint8_t rows = reader.u8(); rows > 0; --rows) replay_row(reader, arena, report, pair, pool);
    return true;
}

} // namespace osem::cross
