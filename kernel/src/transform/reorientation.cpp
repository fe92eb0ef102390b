#include "osem/transform.hpp"

#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

// A mask of children as it lies in the image.
std::uint8_t image_of(const Symmetry& symmetry, std::uint8_t mask) {
    unsigned image = 0;
    for (std::uint8_t left = mask; left != 0; left = without_lowest(left)) {
        image |= 1U << symmetry.child(lowest(left));
    }
    return static_cast<std::uint8_t>(image);
}

} // namespace

Status Reorientation::begin(const Octree& tree, const Symmetry& symmetry, NodePool& pool, bool count_only) {
    builder_.reset();
    open_.level = -1;
    visited_ = 0;
    if (tree.pool != &pool) return Status::pools_differ;
    if (!symmetry.is_valid()) return Status::symmetry_invalid;
    pool_ = &pool;
    symmetry_ = symmetry;
    depth_ = tree.depth;
    builder_.begin(&pool, count_only);
    enter(tree.top, 0);
    return Status::ok;
}

bool Reorientation::step(std::uint32_t nodes) {
    while (builder_.building()) {
        std::uint8_t& left = open_.left[open_.level];
        if (left == 0) {
            builder_.close(&nodes_[open_.level]);
            --open_.level;
            continue;
        }
        if (nodes == 0) return true;
        --nodes;
        const unsigned child = lowest(left);
        left = without_lowest(left);
        enter(pool_->child(nodes_[open_.level], child), symmetry_.child(child));
    }
    return false;
}

std::uint64_t Reorientation::decided_volume() const {
    return builder_.finished() ? root_volume : open_.decided_volume();
}

TreeOutcome Reorientation::finish() { return builder_.finish(depth_); }

void Reorientation::enter(const Node& node, unsigned child) {
    ++visited_;
    if (++open_.level > 0) builder_.open(child);
    const std::uint8_t grey = node.grey();
    nodes_[open_.level] = node;
    open_.left[open_.level] = grey;
    builder_.leaves(image_of(symmetry_, node.may), image_of(symmetry_, blacks(node)));
}

TreeOutcome reorient(Reorientation& job, const Octree& tree, const Symmetry& symmetry, NodePool& pool) {
    const Status status = job.begin(tree, symmetry, pool);
    if (status != Status::ok) return {status, 0, 0, tree};
    run_to_end(job);
    return job.finish();
}

} // namespace osem
