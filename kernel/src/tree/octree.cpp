#include "osem/octree.hpp"

#include "tree/masks.hpp"

namespace osem {

NodeWalk::NodeWalk(const Octree& tree) : pool_(tree.pool), octant_(root_octant) {
    frames_[0] = Frame{tree.top, tree.top.grey()};
}

void NodeWalk::next() {
    while (frames_[level_].left == 0) {
        if (level_ == 0) {
            done_ = true;
            return;
        }
        --level_;
        octant_ = octant_.parent();
    }
    Frame& frame = frames_[level_];
    const unsigned child = lowest(frame.left);
    frame.left = without_lowest(frame.left);
    const Node& node = pool_->child(frame.node, child);
    octant_ = octant_.child(child);
    frames_[++level_] = Frame{node, node.grey()};
}

void NodeWalk::skip() {
    frames_[level_].left = 0;
    next();
}

LeafWalk::LeafWalk(const Octree& tree) : pool_(tree.pool), octant_(root_octant) {
    frames_[0] = Frame{tree.top, 0};
}

bool LeafWalk::next(Leaf& leaf) {
    if (level_ == 0 && frames_[0].child == 0 && frames_[0].node.is_uniform()) {
        leaf = Leaf{root_octant, frames_[0].node.colour(0)};
        frames_[0].child = 8;
        return true;
    }
    for (;;) {
        Frame& frame = frames_[level_];
        if (frame.child == 8) {
            if (level_ == 0) return false;
            --level_;
            octant_ = octant_.parent();
            continue;
        }
        const unsigned child = frame.child++;
        const Octant octant = octant_.child(child);
        const Colour colour = frame.node.colour(child);
        if (colour != Colour::grey) {
            leaf = Leaf{octant, colour};
            return true;
        }
        octant_ = octant;
        frames_[++level_] = Frame{pool_->child(frame.node, child), 0};
    }
}

Measures measure(const Octree& tree) {
    Measures m = {};
    if (tree.top.is_uniform()) {
        const Colour colour = tree.top.colour(0);
        m.nodes = 1;
        (colour == Colour::white   ? m.white_leaves
         : colour == Colour::black ? m.black_leaves
                                   : m.boundary_leaves) = 1;
        m.inner_volume = colour == Colour::black ? root_volume : 0;
        m.outer_volume = colour == Colour::white ? 0 : root_volume;
        return m;
    }
    for (NodeWalk walk(tree); !walk.done(); walk.next()) {
        const Node& node = walk.node();
        const unsigned black = count_bits(blacks(node));
        const unsigned boundary = count_bits(boundaries(node));
        const std::uint64_t cells = volume_at(walk.octant().level + 1);
        m.nodes += 1;
        m.white_leaves += count_bits(whites(node));
        m.black_leaves += black;
        m.boundary_leaves += boundary;
        m.inner_volume += black * cells;
        m.outer_volume += (black + boundary) * cells;
    }
    return m;
}

std::uint64_t digest(const Octree& tree) {
    // FNV-1a, 64 bits (Fowler, Noll, Vo).
    constexpr std::uint64_t prime = 0x100000001b3U;
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (NodeWalk walk(tree); !walk.done(); walk.next()) {
        hash = (hash ^ walk.node().may) * prime;
        hash = (hash ^ walk.node().must) * prime;
    }
    return hash;
}

bool same_leaves(const Octree& a, const Octree& b) {
    NodeWalk in_a(a);
    NodeWalk in_b(b);
    while (!in_a.done()) { // as far as the nodes are equal, both walks take the same way
        const Node& node_a = in_a.node();
        const Node& node_b = in_b.node();
        if (node_a.may != node_b.may || node_a.must != node_b.must) return false;
        const bool shared = a.pool == b.pool && node_a.first() == node_b.first();
        shared ? in_a.skip() : in_a.next();
        shared ? in_b.skip() : in_b.next();
    }
    return true;
}

} // namespace osem
