// Walks, measures and comparison.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

void measure_walks(const Octree& tree) {
    measured("NodeWalk::NodeWalk", [&] {
        const NodeWalk walk(tree);
        use(walk);
    });
    NodeWalk nodes(tree);
    measured("NodeWalk::next", [&] {
        for (int i = 0; i < 1000 && !nodes.done(); ++i) nodes.next();
    });
    measured("NodeWalk::skip", [&] { nodes.skip(); });
    measured("LeafWalk::LeafWalk", [&] {
        const LeafWalk walk(tree);
        use(walk);
    });
    LeafWalk leaves(tree);
    Leaf leaf = {};
    measured("LeafWalk::next", [&] {
        while (leaves.next(leaf)) {
        }
    });
}

void measure_measures(const Octree& a, const Octree& b) {
    measured("measure", [&] {
        const Measures measures = measure(a);
        use(measures);
    });
    std::uint64_t hash = 0;
    measured("digest", [&] { hash = digest(a); });
    bool same = true;
    measured("same_leaves", [&] { same = same_leaves(a, a) && same_leaves(a, b); });
    expect(hash != 0 && !same);
}

} // namespace

void paint_trees(const PaintTrees& trees) {
    measure_walks(trees.a);
    measure_measures(trees.a, trees.b);
}

} // namespace osem::cross
