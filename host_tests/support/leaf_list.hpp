// The leaves of a tree as a list, and a tree of one deep leaf.
#ifndef OSEM_SUPPORT_LEAF_LIST_HPP
#define OSEM_SUPPORT_LEAF_LIST_HPP

#include <random>
#include <vector>

#include "osem/octree.hpp"
#include "osem/tree_builder.hpp"

namespace osem::tests {

inline bool operator==(const Octant& a, const Octant& b) {
    return a.corner == b.corner && a.level == b.level;
}

inline bool same_leaf(const Leaf& a, const Leaf& b) { return a.octant == b.octant && a.colour == b.colour; }

inline std::vector<Leaf> leaves_of(const Octree& tree) {
    std::vector<Leaf> leaves;
    Leaf leaf = {};
    for (LeafWalk walk(tree); walk.next(leaf);) leaves.push_back(leaf);
    return leaves;
}

/// A white tree but for one leaf, at the end of a random path of `depth` levels. The pool needs that many
/// nodes.
inline Octree lone_leaf(int depth, Colour colour, std::mt19937& random, NodePool& pool, Leaf& leaf) {
    TreeBuilder builder;
    builder.begin(&pool);
    leaf = {root_octant, colour};
    for (int level = 1; level <= depth; ++level) {
        const auto child = static_cast<unsigned>(random() % 8);
        level < depth ? builder.open(child) : builder.leaf(child, colour);
        leaf.octant = leaf.octant.child(child);
    }
    for (int level = 0; level < depth; ++level) builder.close();
    return builder.finish(static_cast<std::uint8_t>(depth)).tree;
}

} // namespace osem::tests

#endif
