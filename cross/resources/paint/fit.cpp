// Trees that fit: the finest conversion, and the best of so many nodes.
#include "paint/paint.hpp"
#include "sphere.hpp"

namespace osem::cross {

namespace {

constexpr Sphere sphere(Point{{480000, 540000, 500000}}, 310000);

StaticNodePool<1000> narrow_pool;
Fitting fitting;
Pruning pruning;
Appraisal appraisal;
std::uint32_t faces[Sphere::triangle_count];

void measure_fitting(LeafRule leaves) {
    const CheckedSolid solid = CheckedSolid::vouched(sphere.solid());
    ConvertOptions options;
    options.depth = 6;
    options.leaves = leaves;
    Status status = Status::unfinished;
    measured("Fitting::begin",
             [&] { status = fitting.begin(solid, options, faces, Sphere::triangle_count, narrow_pool); });
    expect(status == Status::ok);
    measured("Fitting::step", [&] {
        while (fitting.step(1000)) {
        }
    });
    expect(fitting.writing() && fitting.depth() < options.depth);
    measured("Fitting::finish", [&] { status = fitting.finish().built.status; });
    expect(status == Status::ok && narrow_pool.used() != 0);
    narrow_pool.roll_back(0);
    options.depth = 2;
    measured("fit", [&] {
        const FitOutcome outcome = fit(fitting, solid, options, faces, Sphere::triangle_count, narrow_pool);
        use(outcome);
    });
    narrow_pool.roll_back(0);
}

void measure_pruning(const Octree& tree) {
    measured("Appraisal::begin", [&] { appraisal.begin(tree.pool, tree.top, 0, 1); });
    measured("Appraisal::step", [&] {
        while (appraisal.step()) {
        }
    });
    expect(appraisal.kept() != 0);

    const std::uint32_t budget = 100;
    measured("Pruning::begin", [&] { pruning.begin(tree, budget, &narrow_pool); });
    measured("Pruning::step", [&] {
        while (pruning.step(1000)) {
        }
    });
    Status status = Status::unfinished;
    measured("Pruning::finish", [&] { status = pruning.finish().built.status; });
    expect(status == Status::ok && narrow_pool.used() != 0 && narrow_pool.used() <= budget);
    narrow_pool.roll_back(0);
    measured("prune", [&] {
        const PruneOutcome outcome = prune(pruning, tree, budget, nullptr);
        use(outcome);
    });
}

} // namespace

void paint_fit(const PaintTrees& trees) {
    measure_fitting(LeafRule::conservative);
    measure_fitting(LeafRule::centre);
    measure_pruning(trees.a);
}

} // namespace osem::cross
