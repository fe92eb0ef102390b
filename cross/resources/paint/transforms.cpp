// Trees moved, turned, scaled, cut and made coarser.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

Translation translation;
Reorientation reorientation;
Coarsening coarsening;

// Moved by an odd vector, so that octants down to side 1 are gathered from eight each: only begun, for the
// result would be large.
void measure_odd_translation(const Octree& tree) {
    Placement placement;
    placement.by = {{-12345, 777, 1}};
    placement.cut_at_root = true;
    Status status = Status::unfinished;
    measured("Translation::begin", [&] { status = translation.begin(tree, placement, pool, true); });
    expect(status == Status::ok);
    bool more = false;
    measured("Translation::step", [&] { more = translation.step(20000); });
    std::uint64_t volume = 0;
    measured("Translation::decided_volume", [&] { volume = translation.decided_volume(); });
    measured("Translation::finish", [&] { status = translation.finish().status; });
    expect(more && volume != 0 && status == Status::unfinished);
}

void measure_translation(const Octree& tree) {
    const std::int32_t by = root_side / 64;
    Placement placement;
    placement.by = {{by, -by, by}};
    placement.depth = 5;
    placement.mixed_as_boundary = true;
    placement.cut_at_root = true;
    TreeOutcome outcome = {};
    measured("Translation::begin", [&] { translation.begin(tree, placement, pool); });
    measured("Translation::step", [&] {
        while (translation.step(1000)) {
        }
    });
    measured("Translation::finish", [&] { outcome = translation.finish(); });
    expect(outcome.status == Status::ok);
    placement.depth = 0;
    placement.cut_at_root = false;
    measured("translate", [&] { outcome = translate(translation, tree, placement, pool); });
    expect(outcome.status == Status::ok || outcome.status == Status::part_leaves_root);
    const CellBox box = {{{by, 0, by}}, {{root_side / 2, root_side, root_side - by}}};
    measured("crop", [&] { outcome = crop(translation, tree, box, pool); });
    expect(outcome.status == Status::ok);
}

void measure_reorientation(const Octree& tree) {
    const Symmetry symmetry = Symmetry::nth(29);
    Status status = Status::unfinished;
    measured("Reorientation::begin", [&] { status = reorientation.begin(tree, symmetry, pool, true); });
    expect(status == Status::ok);
    measured("Reorientation::step", [&] { reorientation.step(1000); });
    std::uint64_t volume = 0;
    measured("Reorientation::decided_volume", [&] { volume = reorientation.decided_volume(); });
    measured("Reorientation::finish", [&] { status = reorientation.finish().status; });
    expect(volume != 0 && status == Status::unfinished);
    measured("reorient", [&] { status = reorient(reorientation, tree, symmetry, pool).status; });
    expect(status == Status::ok);
}

void measure_coarsening(const Octree& tree) {
    Status status = Status::unfinished;
    measured("Coarsening::begin", [&] { status = coarsening.begin(tree, 4, Coarse::majority, pool, true); });
    expect(status == Status::ok);
    measured("Coarsening::step", [&] { coarsening.step(100); });
    std::uint64_t volume = 0;
    measured("Coarsening::decided_volume", [&] { volume = coarsening.decided_volume(); });
    measured("Coarsening::finish", [&] { status = coarsening.finish().status; });
    expect(volume != 0 && status == Status::unfinished);
    OpenOctants open;
    open.level = max_depth - 1;
    measured("OpenOctants::decided_volume", [&] {
        const std::uint64_t decided = open.decided_volume();
        use(decided);
    });
    measured("coarsen", [&] { status = coarsen(coarsening, tree, 4, Coarse::majority, pool).status; });
    expect(status == Status::ok);
}

void measure_scaling(const Octree& tree) {
    const Octant octant = {{{root_side / 8, 0, root_side / 2}}, 3};
    TreeOutcome outcome = {};
    measured("enlarged", [&] { outcome = enlarged(tree, octant); });
    expect(outcome.status == Status::ok);
    measured("reduced", [&] { outcome = reduced(tree, octant, pool); });
    expect(outcome.status == Status::ok);
}

} // namespace

void paint_transforms(const PaintTrees& trees) {
    const std::uint32_t mark = pool.used();
    measure_odd_translation(trees.a);
    measure_translation(trees.a);
    pool.roll_back(mark);
    measure_reorientation(trees.a);
    pool.roll_back(mark);
    measure_coarsening(trees.a);
    measure_scaling(trees.a);
    pool.roll_back(mark);
}

} // namespace osem::cross
