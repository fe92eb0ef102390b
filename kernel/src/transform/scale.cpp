#include "osem/transform.hpp"

namespace osem {

namespace {

// Which child, of the octant of a level that holds it, a point lies in.
unsigned child_at(const Point& point, int level) {
    const std::int32_t half = root_side >> (level + 1);
    unsigned child = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if ((point.at[axis] & half) != 0) child |= 1U << axis;
    }
    return child;
}

TreeOutcome refused(Status status, const Octree& tree) { return {status, 0, 0, tree}; }

} // namespace

TreeOutcome enlarged(const Octree& tree, const Octant& octant) {
    if (!is_octant(octant)) return refused(Status::octant_invalid, tree);
    const int depth = tree.depth - octant.level;
    Octree result = {tree.pool, tree.top, static_cast<std::uint8_t>(depth < 1 ? 1 : depth)};
    for (int level = 0; level < octant.level && !result.top.is_uniform(); ++level) {
        const unsigned child = child_at(octant.corner, level);
        const Colour colour = result.top.colour(child);
        result.top = colour == Colour::grey ? tree.pool->child(result.top, child) : Node::uniform(colour);
    }
    return {Status::ok, 0, 0, result};
}

TreeOutcome reduced(const Octree& tree, const Octant& octant, NodePool& pool) {
    if (!is_octant(octant)) return refused(Status::octant_invalid, tree);
    if (tree.depth + octant.level > max_depth) return refused(Status::depth_out_of_range, tree);
    if (tree.pool != &pool) return refused(Status::pools_differ, tree);
    const std::uint32_t mark = pool.used();
    const auto depth = static_cast<std::uint8_t>(tree.depth + octant.level);
    TreeOutcome outcome = {Status::ok, 0, 0, Octree{&pool, tree.top, depth}};
    Node& node = outcome.tree.top;
    for (int level = octant.level - 1; level >= 0; --level) {
        const unsigned bit = 1U << child_at(octant.corner, level);
        if (node.is_uniform()) { // a leaf, which takes no node
            node = Node::of(static_cast<std::uint8_t>(node.may & bit),
                            static_cast<std::uint8_t>(node.must & bit), 0);
            continue;
        }
        NodeIndex first = 0;
        ++outcome.nodes_needed;
        if (outcome.status == Status::ok) outcome.status = pool.append(&node, 1, first);
        node = Node::of(0, static_cast<std::uint8_t>(bit), first);
    }
    if (outcome.status != Status::ok) {
        pool.roll_back(mark);
        outcome.nodes_missing = outcome.nodes_needed - (pool.capacity() - mark);
    }
    return outcome;
}

} // namespace osem
