// Whole conversions, and solids that check must refuse.
#include "osem/grid_convert.hpp"

#include "records.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

std::uint32_t place_of(const CheckOutcome& outcome) {
    switch (outcome.status) {
    case Status::face_not_planar:
        return outcome.face;
    case Status::coordinate_off_lattice:
        return outcome.vertex;
    case Status::index_out_of_range:
        return outcome.corner;
    case Status::ring_too_short:
        return outcome.ring;
    default:
        return 0;
    }
}

// The record's first case. False when the scratch does not fit; else `found` is what check said.
bool replay_check(Reader& reader, Arena& arena, Report& report, const Solid& solid, Status& found) {
    const auto status = static_cast<Status>(reader.u8());
    const std::uint32_t place = reader.u32();
    ArenaScope scope(arena);
    Edge* edges = arena.take<Edge>(check_scratch(solid));
    if (edges == nullptr) return false;
    const CheckOutcome outcome = check(solid, edges, check_scratch(solid));
    report.begin_case();
    report.expect("status of check", static_cast<int>(status), static_cast<int>(outcome.status));
    report.expect("place of the refusal", place, place_of(outcome));
    found = outcome.status;
    return true;
}

// Whether the tree and its copy, with what makes them, fit one after the other.
bool fits(Arena& arena, const Solid& solid, std::uint32_t nodes) {
    const ArenaScope scope(arena);
    if (take_nodes(arena, nodes) == nullptr) return false;
    {
        const ArenaScope conversion(arena);
        if (arena.take<std::uint32_t>(convert_scratch(solid)) == nullptr) return false;
        if (arena.take<Conversion>(1) == nullptr) return false;
    }
    return take_nodes(arena, nodes) != nullptr && arena.take<StreamReader>(1) != nullptr;
}

// A counting pass, then into a pool that holds exactly the nodes that the truth has.
TreeOutcome converted(Arena& arena, Report& report, const Solid& solid, const ConvertOptions& options,
                      NodePool& pool) {
    const ArenaScope scope(arena);
    const std::uint32_t faces = convert_scratch(solid);
    auto* list = arena.take<std::uint32_t>(faces);
    auto& job = *arena.take<Conversion>(1);
    const CheckedSolid checked = CheckedSolid::vouched(solid);
    const TreeOutcome counted = convert(job, checked, options, list, faces, nullptr);
    report.expect("nodes counted", pool.capacity(), counted.nodes_needed);
    const TreeOutcome outcome = convert(job, checked, options, list, faces, &pool);
    report.expect("nodes needed", pool.capacity(), outcome.nodes_needed);
    report.expect("nodes used", pool.capacity(), pool.used());
    return outcome;
}

void replay_round_trip(Arena& arena, Report& report, const Octree& tree, LeafRule rule) {
    const ArenaScope scope(arena);
    const std::uint32_t nodes = tree.pool->used();
    NodePool pool(take_nodes(arena, nodes), nodes);
    auto& copy = *arena.take<StreamReader>(1);
    const StreamOutcome outcome = copied(tree, rule, copy, &pool);
    if (!report.expect("status of the stream read back", static_cast<int>(Status::ok),
                       static_cast<int>(outcome.built.status))) {
        return;
    }
    report.expect("same leaves as the stream", 1, same_leaves(tree, outcome.built.tree) ? 1 : 0);
}

// By grids, where there is room for them, the tree is the same. The last grids are as large as there is room
// for, up to each size in turn.
void replay_by_grids(Arena& arena, Report& report, const Solid& solid, const ConvertOptions& options,
                     const Octree& same) {
    const ArenaScope scope(arena);
    const std::uint32_t nodes = same.pool->used();
    Node* const memory = take_nodes(arena, nodes);
    auto* const job = arena.take<GridConversion>(1);
    std::uint32_t* scratch = nullptr;
    std::uint32_t words = 0;
    int last_levels = static_cast<int>(nodes % most_grid_levels) + 2;
    while (scratch == nullptr && --last_levels > 0) {
        words = static_cast<std::uint32_t>(grid_scratch(solid, options.depth, last_levels));
        scratch = arena.take<std::uint32_t>(words);
    }
    if (memory == nullptr || job == nullptr || scratch == nullptr) return;
    NodePool pool(memory, nodes);
    const TreeOutcome outcome =
        convert(*job, CheckedSolid::vouched(solid), options, scratch, words, &pool, {last_levels});
    if (!report.expect("status by grids", static_cast<int>(Status::ok), static_cast<int>(outcome.status))) {
        return;
    }
    report.expect("nodes by grids", nodes, pool.used());
    report.expect("same leaves by grids", 1, same_leaves(same, outcome.tree) ? 1 : 0);
}

void replay_job(Reader& reader, Arena& arena, Report& report, const Solid& solid, Status checked) {
    const ConvertOptions options = read_options(reader);
    const TreeTruth truth = read_tree_truth(reader);
    if (!fits(arena, solid, truth.pool_nodes())) {
        report.too_large();
        skip_tree(reader, truth);
        return;
    }
    report.begin_case();
    if (!report.expect("status of check", static_cast<int>(Status::ok), static_cast<int>(checked))) {
        skip_tree(reader, truth);
        return;
    }
    const ArenaScope scope(arena);
    NodePool pool(take_nodes(arena, truth.pool_nodes()), truth.pool_nodes());
    const TreeOutcome outcome = converted(arena, report, solid, options, pool);
    if (!report.expect("status of convert", static_cast<int>(Status::ok), static_cast<int>(outcome.status))) {
        skip_tree(reader, truth);
        return;
    }
    compare_tree(reader, report, truth, outcome.tree, options.leaves);
    replay_round_trip(arena, report, outcome.tree, options.leaves);
    replay_by_grids(arena, report, solid, options, outcome.tree);
}

} // namespace

bool replay_conversion(Reader& reader, Arena& arena, Report& report) {
    Solid solid = {};
    Status checked = Status::ok;
    if (!read_solid(reader, arena, solid)) return false;
    if (!replay_check(reader, arena, report, solid, checked)) return false;
    for (std::uint8_t jobs = reader.u8(); jobs > 0; --jobs) replay_job(reader, arena, report, solid, checked);
    return true;
}

} // namespace osem::cross
