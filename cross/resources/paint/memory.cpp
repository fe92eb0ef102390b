// Pool, builder and compaction.
#include "paint/paint.hpp"

namespace osem::cross {

namespace {

TreeBuilder builder;
std::uint32_t marks[compact_scratch(40000)];

void measure_pool() {
    constexpr Node nodes[8] = {};
    NodeIndex first = 0;
    const std::uint32_t mark = pool.used();
    measured("NodePool::append", [&] { use(pool.append(nodes, 8, first)); });
    measured("NodePool::roll_back", [&] { pool.roll_back(mark); });
}

void measure_builder() {
    measured("TreeBuilder::begin", [&] { builder.begin(&pool); });
    measured("TreeBuilder::open", [&] { builder.open(1); });
    measured("TreeBuilder::grandchildren",
             [&] { builder.grandchildren(0x0f00000000000000, 0x0100000000000000); });
    measured("TreeBuilder::leaves", [&] { builder.leaves(0x55, 0x05); });
    measured("TreeBuilder::leaf", [&] { builder.leaf(6, Colour::black); });
    builder.open(3);
    builder.leaf(2, Colour::black);
    builder.close();
    measured("TreeBuilder::eight_leaves", [&] { builder.eight_leaves(5, 0x0f, 0x01); });
    measured("TreeBuilder::subtree", [&] { builder.subtree(4, 0x00ff0f0000000000, 0x00ff010000000000); });
    measured("TreeBuilder::subtree_of_512", [&] {
        constexpr std::uint64_t may[8] = {0, 0x00ff0f0000000000};
        constexpr std::uint64_t must[8] = {0, 0x00ff010000000000};
        builder.subtree_of_512(7, may, must);
    });
    measured("TreeBuilder::graft", [&] { builder.graft(5, Node::of(0x0f, 0x01, 0)); });
    const Node unlike = Node::of(0x00, 0x28, 0);
    measured("TreeBuilder::close", [&] {
        builder.close(&unlike, &unlike);
        builder.close();
    });
    measured("TreeBuilder::finish", [&] {
        const TreeOutcome outcome = builder.finish(6);
        use(outcome);
    });
    builder.begin(&pool);
    measured("TreeBuilder::abandon", [&] { builder.abandon(); });
}

void measure_compaction(const Octree& a, const Octree& b) {
    Octree trees[2] = {a, b};
    Status status = Status::unfinished;
    measured("compact", [&] { status = compact(pool, trees, 2, marks, compact_scratch(40000)); });
    expect(status == Status::ok);
}

} // namespace

void paint_memory(const PaintTrees& trees) {
    measure_pool();
    measure_builder();
    measure_compaction(trees.a, trees.b);
}

} // namespace osem::cross
