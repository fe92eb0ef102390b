#include "osem/transform.hpp"

#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

struct Masks {
    std::uint8_t may;
    std::uint8_t must;
};

// The leaves among a node's children under a mode, grey children being white.
Masks leaves_of(const Node& node, Coarse mode) {
    const std::uint8_t black = blacks(node);
    if (mode == Coarse::certified) return {node.may, black};
    if (mode == Coarse::outer) return {node.may, node.may};
    return {black, black};
}

} // namespace

Status Coarsening::begin(const Octree& tree, int depth, Coarse mode, NodePool& pool, bool count_only) {
    builder_.reset();
    open_.level = -1;
    visited_ = 0;
    if (tree.pool != &pool) return Status::pools_differ;
    if (depth < 1 || depth > max_depth) return Status::depth_out_of_range;
    pool_ = &pool;
    mode_ = mode;
    depth_ = depth < tree.depth ? static_cast<std::uint8_t>(depth) : tree.depth;
    builder_.begin(&pool, count_only);
    enter(tree.top, 0);
    return Status::ok;
}

bool Coarsening::step(std::uint32_t nodes) {
    while (builder_.building()) {
        std::uint8_t& left = open_.left[open_.level];
        if (left == 0) {
            leave();
            continue;
        }
        if (nodes == 0) return true;
        --nodes;
        const unsigned child = lowest(left);
        left = without_lowest(left);
        enter(pool_->child(nodes_[open_.level], child), child);
    }
    return false;
}

std::uint64_t Coarsening::decided_volume() const {
    return builder_.finished() ? root_volume : open_.decided_volume();
}

TreeOutcome Coarsening::finish() { return builder_.finish(depth_); }

void Coarsening::enter(const Node& node, unsigned child) {
    ++visited_;
    const int level = ++open_.level;
    nodes_[level] = node;
    open_.left[level] = node.grey();
    if (level >= depth_) { // only cells are counted here
        if (level == depth_) {
            child_ = static_cast<std::uint8_t>(child);
            weight_ = 0;
        }
        weight_ += (2 * count_bits(blacks(node)) + count_bits(boundaries(node))) * volume_at(level + 1);
        return;
    }
    if (level > 0) builder_.open(child);
    Masks leaves = leaves_of(node, mode_);
    if (level + 1 == depth_ && mode_ != Coarse::majority) { // a grey octant is mixed: trees are canonical
        if (mode_ != Coarse::inner) leaves.may = static_cast<std::uint8_t>(leaves.may | node.grey());
        if (mode_ == Coarse::outer) leaves.must = static_cast<std::uint8_t>(leaves.must | node.grey());
        open_.left[level] = 0;
    }
    builder_.leaves(leaves.may, leaves.must);
}

void Coarsening::leave() {
    if (open_.level < depth_) {
        builder_.close(&nodes_[open_.level]);
    } else if (open_.level == depth_) {
        builder_.leaf(child_, weight_ > volume_at(depth_) ? Colour::black : Colour::white);
    }
    --open_.level;
}

TreeOutcome coarsen(Coarsening& job, const Octree& tree, int depth, Coarse mode, NodePool& pool) {
    const Status status = job.begin(tree, depth, mode, pool);
    if (status != Status::ok) return {status, 0, 0, tree};
    run_to_end(job);
    return job.finish();
}

} // namespace osem
