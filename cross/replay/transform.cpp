// Trees moved, turned, made coarser and scaled.
#include "osem/transform.hpp"

#include "planted_tree.hpp"
#include "topics.hpp"

namespace osem::cross {

namespace {

// The jobs, one at a time in the same memory, and what they work on.
struct Work {
    Arena& arena;
    NodePool& pool;
    const Octree& tree;
};

// Counted first, then built.
template <class Job, class... Arguments>
TreeOutcome run(const Work& work, Report& report, const Arguments&... arguments) {
    const ArenaScope scope(work.arena);
    auto& job = *work.arena.take<Job>(1);
    const Status status = job.begin(work.tree, arguments..., work.pool, true);
    if (status != Status::ok) return {status, 0, 0, work.tree};
    while (job.step(100)) {
    }
    const TreeOutcome counted = job.finish();
    job.begin(work.tree, arguments..., work.pool);
    while (job.step(7)) {
    }
    const TreeOutcome built = job.finish();
    report.expect("nodes counted", built.nodes_needed, counted.nodes_needed);
    return built;
}

Octant read_octant(Reader& reader) {
    const Point corner = reader.point();
    return Octant{corner, reader.u8()};
}

Placement read_placement(Reader& reader) {
    Placement placement;
    placement.by = reader.point();
    placement.keep.low = reader.point();
    placement.keep.high = reader.point();
    placement.cut_at_root = reader.u8() != 0;
    placement.depth = reader.u8();
    placement.mixed_as_boundary = reader.u8() != 0;
    return placement;
}

Symmetry read_symmetry(Reader& reader) {
    Symmetry symmetry = Symmetry::identity();
    for (std::uint8_t& from : symmetry.from) from = reader.u8();
    symmetry.flips = reader.u8();
    return symmetry;
}

TreeOutcome transformed(Reader& reader, Report& report, const Work& work) {
    switch (static_cast<Transform>(reader.u8())) {
    case Transform::place:
        return run<Translation>(work, report, read_placement(reader));
    case Transform::reorient:
        return run<Reorientation>(work, report, read_symmetry(reader));
    case Transform::coarsen: {
        const int depth = reader.u8();
        return run<Coarsening>(work, report, depth, static_cast<Coarse>(reader.u8()));
    }
    case Transform::enlarge:
        return enlarged(work.tree, read_octant(reader));
    case Transform::reduce:
        return reduced(work.tree, read_octant(reader), work.pool);
    }
    return {Status::unfinished, 0, 0, work.tree};
}

void replay_case(Reader& reader, Report& report, const Work& work) {
    report.begin_case();
    const std::uint32_t mark = work.pool.used();
    const TreeOutcome outcome = transformed(reader, report, work);
    const auto status = static_cast<Status>(reader.u8());
    report.expect("status", static_cast<int>(status), static_cast<int>(outcome.status));
    const std::uint32_t taken = outcome.status == Status::ok ? outcome.nodes_needed : 0;
    report.expect("nodes used", taken, work.pool.used() - mark);
    if (status == Status::ok) {
        compare_leaves(reader, report, outcome.status == Status::ok ? outcome.tree : work.tree);
    }
    work.pool.roll_back(mark);
}

} // namespace

bool replay_transform(Reader& reader, Arena& arena, Report& report) {
    const std::uint32_t most = reader.u32();
    PlantedTree planted(reader, arena, most);
    if (!planted.fits()) return false;
    {
        const ArenaScope scope(arena);
        static_assert(sizeof(Translation) >= sizeof(Reorientation) &&
                          sizeof(Translation) >= sizeof(Coarsening),
                      "where the largest job fits, the others do");
        if (arena.take<Translation>(1) == nullptr) return false;
    }
    const Work work = {arena, planted.pool(), planted.tree()};
    for (std::uint8_t left = reader.u8(); left > 0; --left) replay_case(reader, report, work);
    return true;
}

} // namespace osem::cross
