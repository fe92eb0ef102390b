// What is asked of a tree.
#include "paint/paint.hpp"

namespace osem::cross {

void paint_queries(const PaintTrees& trees) {
    const Octree& tree = trees.a;
    measured("leaf_at", [&] {
        for (std::int32_t x = 0; x < root_side; x += 10007) {
            const PointOutcome outcome = leaf_at(tree, {{x, x, x}});
            use(outcome);
        }
    });
    measured("colours_in", [&] {
        for (std::int32_t x = 0; x < root_side - 70000; x += 10007) {
            const BoxOutcome outcome = colours_in(tree, {{{x, x, 0}}, {{x + 70000, x + 1, root_side}}});
            use(outcome);
        }
    });
}

} // namespace osem::cross
