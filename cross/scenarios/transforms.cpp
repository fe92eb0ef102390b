// Scenarios of trees moved, turned, scaled, cut and made coarser.
#include <initializer_list>

#include "scenarios.hpp"
#include "solids.hpp"

namespace osem::cross {

namespace {

// A result, which then leaves the pool again.
void add(Digest& digest, const TreeOutcome& outcome, std::uint32_t mark) {
    add(digest, outcome);
    pool.roll_back(mark);
}

Octree small_tree(LeafRule leaves) {
    ConvertOptions options;
    options.depth = 3;
    options.leaves = leaves;
    return converted(octahedron(), options).tree;
}

} // namespace

// In small steps, of which an odd vector would take without end at full depth: those results are given up.
std::uint64_t placed_trees() {
    Digest digest;
    const Octree tree = small_tree(LeafRule::conservative);
    const std::uint32_t mark = pool.used();
    for (const Point& by :
         {Point{{root_side / 8, 0, -root_side / 4}}, Point{{-root_side / 16, root_side / 8, 0}},
          Point{{root_side / 64, 1 - root_side / 2, 3}}, Point{{-1, 0, 0}}}) {
        for (const int depth : {0, 2, 4}) {
            for (const bool cut : {false, true}) {
                Placement placement;
                placement.by = by;
                placement.depth = static_cast<std::uint8_t>(depth);
                placement.cut_at_root = cut;
                placement.mixed_as_boundary = depth != 0;
                auto& job = fresh<Translation>();
                digest.add(job.begin(tree, placement, pool));
                for (int left = 300; left > 0 && job.step(5); --left) digest.add(job.decided_volume());
                digest.add(job.nodes_visited());
                add(digest, job.finish(), mark);
            }
        }
    }
    return digest.value();
}

std::uint64_t cropped_trees() {
    Digest digest;
    const Octree tree = small_tree(LeafRule::centre);
    const std::uint32_t mark = pool.used();
    Random random(5);
    for (int i = 0; i < 12; ++i) {
        CellBox box = {};
        const std::int32_t grain = root_side / (i < 8 ? 16 : 64);
        for (int axis = 0; axis < 3; ++axis) {
            box.low.at[axis] = random.below(root_side / 2 / grain) * grain;
            box.high.at[axis] = box.low.at[axis] + (1 + random.below(root_side / 2 / grain)) * grain;
        }
        auto& job = fresh<Translation>();
        add(digest, crop(job, tree, box, pool), mark);
        digest.add(job.nodes_visited());
    }
    return digest.value();
}

std::uint64_t symmetric_trees() {
    Digest digest;
    ConvertOptions options;
    options.depth = 4;
    const Octree tree = converted(plate(), options).tree;
    const std::uint32_t mark = pool.used();
    for (unsigned n = 0; n < 48; ++n) {
        const Symmetry symmetry = Symmetry::nth(n);
        auto& job = fresh<Reorientation>();
        digest.add(job.begin(tree, symmetry, pool));
        while (job.step(11)) digest.add(job.decided_volume());
        digest.add(symmetry.is_rotation());
        digest.add(symmetry.inverse() * symmetry == Symmetry::identity());
        add(digest, job.finish(), mark);
    }
    return digest.value();
}

std::uint64_t coarser_trees() {
    Digest digest;
    ConvertOptions options;
    options.depth = 4;
    const Octree tree = converted(plate(), options).tree;
    const std::uint32_t mark = pool.used();
    for (const auto mode : {Coarse::certified, Coarse::inner, Coarse::outer, Coarse::majority}) {
        for (int depth = 0; depth <= 5; ++depth) {
            auto& job = fresh<Coarsening>();
            const Status begun = job.begin(tree, depth, mode, pool);
            digest.add(begun);
            if (begun != Status::ok) continue;
            while (job.step(3)) digest.add(job.decided_volume());
            digest.add(job.nodes_visited());
            add(digest, job.finish(), mark);
        }
    }
    return digest.value();
}

std::uint64_t scaled_trees() {
    Digest digest;
    const Octree tree = small_tree(LeafRule::conservative);
    const std::uint32_t mark = pool.used();
    constexpr std::int32_t places[] = {0, root_side / 2, root_side - 1};
    for (int level = 0; level <= 20; ++level) {
        const auto of_level = static_cast<std::uint8_t>(level);
        for (const std::int32_t at : places) {
            const std::int32_t corner = at & -(root_side >> level);
            const Octant octant = {{{corner, 0, corner}}, of_level};
            add(digest, enlarged(tree, octant), mark);
            add(digest, reduced(tree, octant, pool), mark);
        }
    }
    add(digest, enlarged(tree, {{{1, 0, 0}}, 3}), mark);
    return digest.value();
}

} // namespace osem::cross
