#include "osem/transform.hpp"

#include "query/cell_box.hpp"
#include "query/children_in.hpp"
#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

// The children of an octant that have no cell outside of a box.
std::uint8_t children_within(const Octant& octant, const CellBox& box) {
    const std::int32_t half = octant.side() / 2;
    unsigned children = 0xff;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t middle = octant.corner.at[axis] + half;
        const std::int32_t low = box.low.at[axis] - middle; // from the octant's middle
        const std::int32_t high = box.high.at[axis] - middle;
        if (low > -half || high < 0) children &= ~unsigned{low_children[axis]};
        if (low > 0 || high < half) children &= low_children[axis];
    }
    return static_cast<std::uint8_t>(children);
}

// Moved further than the root is wide, or exactly so far: either way everything is gone.
std::int32_t clamped(std::int32_t distance) {
    return distance > root_side ? root_side : distance < -root_side ? -root_side : distance;
}

Node child_of(const NodePool& pool, const Node& node, unsigned child) {
    const Colour colour = node.colour(child);
    return colour == Colour::grey ? pool.child(node, child) : Node::uniform(colour);
}

// Whether all are leaves of one colour.
bool one_colour(const Node (&nodes)[8]) {
    if (!nodes[0].is_uniform()) return false;
    for (const Node& node : nodes) {
        if (node.may != nodes[0].may || node.must != nodes[0].must) return false;
    }
    return true;
}

} // namespace

Status Translation::begin(const Octree& tree, const Placement& placement, NodePool& pool, bool count_only) {
    builder_.reset();
    open_.level = -1;
    visited_ = 0;
    searching_ = false;
    leaves_root_ = false;
    if (tree.pool != &pool) return Status::pools_differ;
    const Status fault = fault_of(placement.keep);
    if (fault != Status::ok) return fault;
    if (placement.depth > max_depth) return Status::depth_out_of_range;
    const int exact = placed_depth(tree.depth, placement);
    const bool coarse = placement.depth != 0 && placement.depth < exact;
    if (coarse && !placement.mixed_as_boundary) return Status::depth_too_coarse;
    limit_ = coarse ? placement.depth : static_cast<std::uint8_t>(exact);
    pool_ = &pool;
    tree_ = tree;
    placement_ = placement;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t by = clamped(placement.by.at[axis]);
        placement_.by.at[axis] = by;
        stays_.low.at[axis] = by < 0 ? -by : 0;
        stays_.high.at[axis] = by > 0 ? root_side - by : root_side;
    }
    builder_.begin(&pool, count_only);
    if (placement.cut_at_root) {
        start();
    } else {
        searching_ = true;
    }
    return Status::ok;
}

bool Translation::step(std::uint32_t nodes) {
    while (builder_.building()) {
        if (!searching_ && open_.left[open_.level] == 0) {
            leave();
            continue;
        }
        if (nodes == 0) return true;
        --nodes;
        if (searching_) {
            search();
            continue;
        }
        const unsigned child = lowest(open_.left[open_.level]);
        open_.left[open_.level] = without_lowest(open_.left[open_.level]);
        enter(child);
    }
    return false;
}

std::uint64_t Translation::decided_volume() const {
    if (builder_.finished()) return root_volume;
    return searching_ ? 0 : open_.decided_volume();
}

TreeOutcome Translation::finish() {
    if (leaves_root_) {
        leaves_root_ = false;
        return {Status::part_leaves_root, 0, 0, tree_};
    }
    searching_ = false;
    return builder_.finish(limit_);
}

// Visits the next of the operand's nodes that have cells both inside and outside of what stays in the root.
void Translation::search() {
    if (open_.level < 0) {
        octant_ = root_octant;
        frames_[0].from[0] = tree_.top;
    } else {
        const unsigned child = lowest(open_.left[open_.level]);
        open_.left[open_.level] = without_lowest(open_.left[open_.level]);
        frames_[open_.level + 1].from[0] = pool_->child(frames_[open_.level].from[0], child);
        octant_ = octant_.child(child);
    }
    ++visited_;
    const Node& node = frames_[++open_.level].from[0];
    const unsigned within = children_within(octant_, stays_);
    const unsigned gone = ~unsigned{children_in(octant_, stays_, 0)};
    // A grey octant holds some leaf that is not white: it would be a white leaf otherwise.
    const unsigned leaving = (node.may & ~within) | (node.grey() & gone);
    if (leaving != 0) {
        searching_ = false;
        leaves_root_ = true;
        open_.level = -1;
        builder_.abandon();
        return;
    }
    open_.left[open_.level] = static_cast<std::uint8_t>(node.grey() & ~within);
    while (open_.left[open_.level] == 0) {
        if (open_.level-- == 0) {
            start();
            return;
        }
        octant_ = octant_.parent();
    }
}

// Puts the operand octants, of the root's size, under the root: the operand itself and white around it.
void Translation::start() {
    searching_ = false;
    octant_ = root_octant;
    for (unsigned j = 0; j < 8; ++j) {
        bool is_tree = true;
        for (unsigned axis = 0; axis < 3; ++axis) {
            // The root lies over the interval from -by on, which begins in the operand or left of it.
            const std::int32_t first = -placement_.by.at[axis];
            const std::int32_t at = (first < 0            ? -1
                                     : first == root_side ? 1
                                                          : 0) +
                                    static_cast<std::int32_t>((j >> axis) & 1U);
            if (at != 0) is_tree = false;
        }
        frames_[0].from[j] = is_tree ? tree_.top : Node::uniform(Colour::white);
    }
    open_.level = 0;
    visit();
}

// Whether the operand's octants of a side come to lie on those of the result.
bool Translation::aligned(std::int32_t side) const {
    const std::uint32_t below = static_cast<std::uint32_t>(side) - 1;
    return ((static_cast<std::uint32_t>(placement_.by.at[0]) |
             static_cast<std::uint32_t>(placement_.by.at[1]) |
             static_cast<std::uint32_t>(placement_.by.at[2])) &
            below) == 0;
}

// The operand octants under a child. Seen in half sides, the open octant begins `shift` into its own first
// operand octant, and so does its child on the high side one further; what it ends in counts only if it
// begins between two of them.
void Translation::gather(unsigned child, Node (&from)[8]) const {
    const std::int32_t half = octant_.side() / 2;
    for (unsigned j = 0; j < 8; ++j) {
        unsigned parent = 0;
        unsigned part = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const std::int32_t begins = -placement_.by.at[axis];
            const unsigned shift = (begins & half) != 0 ? 1 : 0;
            const unsigned second = (begins & (half - 1)) != 0 ? (j >> axis) & 1U : 0;
            const unsigned at = shift + ((child >> axis) & 1U) + second;
            parent |= (at >> 1) << axis;
            part |= (at & 1U) << axis;
        }
        from[j] = child_of(*pool_, frames_[open_.level].from[parent], part);
    }
}

void Translation::enter(unsigned child) {
    gather(child, frames_[open_.level + 1].from);
    octant_ = octant_.child(child);
    if (++open_.level < limit_) {
        builder_.open(child);
    } else if (open_.level == limit_) {
        seen_ = 0;
    }
    visit();
}

void Translation::visit() {
    ++visited_;
    open_.left[open_.level] = 0;
    const unsigned meeting = children_in(octant_, placement_.keep, 0);
    const unsigned within = children_within(octant_, placement_.keep);
    for (unsigned child = 0; child < 8; ++child) {
        if (!contains(meeting, child)) {
            found(child, Colour::white);
        } else {
            settle(child, contains(within, child));
        }
    }
    // One colour more, or boundary, makes the octant looked into boundary: nothing in it matters any more.
    const bool mixed = (seen_ & (seen_ - 1U)) != 0 || seen_ == colour_bit(Colour::boundary);
    for (int level = limit_; mixed && level <= open_.level; ++level) open_.left[level] = 0;
}

// Settles a child, or leaves it to be entered. `within`: no border of `keep` passes through it.
void Translation::settle(unsigned child, bool within) {
    const int level = open_.level + 1; // the child's
    const bool shares = within && aligned(octant_.side() / 2);
    Node from[8];
    gather(child, from);
    const Colour colour = from[0].colour(0);
    if (one_colour(from) && (within || colour == Colour::white)) {
        found(child, colour);
    } else if (shares && level >= limit_) {
        found(child, Colour::boundary); // grey below the depth asked for
    } else if (shares && tree_.depth <= limit_) {
        builder_.graft(child, from[0]);
    } else {
        open_.left[open_.level] = static_cast<std::uint8_t>(open_.left[open_.level] | (1U << child));
    }
}

void Translation::found(unsigned child, Colour colour) {
    if (open_.level < limit_) {
        builder_.leaf(child, colour);
    } else {
        seen_ = static_cast<std::uint8_t>(seen_ | colour_bit(colour));
    }
}

void Translation::leave() {
    if (open_.level < limit_) {
        builder_.close(aligned(octant_.side()) ? &frames_[open_.level].from[0] : nullptr);
    } else if (open_.level == limit_) {
        const Colour colour = seen_ == colour_bit(Colour::white)   ? Colour::white
                              : seen_ == colour_bit(Colour::black) ? Colour::black
                                                                   : Colour::boundary;
        const std::int32_t side = octant_.side();
        unsigned child = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            if ((octant_.corner.at[axis] & side) != 0) child |= 1U << axis;
        }
        builder_.leaf(child, colour);
    }
    if (open_.level-- > 0) octant_ = octant_.parent();
}

TreeOutcome translate(Translation& job, const Octree& tree, const Placement& placement, NodePool& pool) {
    const Status status = job.begin(tree, placement, pool);
    if (status != Status::ok) return {status, 0, 0, tree};
    run_to_end(job);
    return job.finish();
}

TreeOutcome crop(Translation& job, const Octree& tree, const CellBox& box, NodePool& pool) {
    Placement placement;
    placement.keep = box;
    return translate(job, tree, placement, pool);
}

} // namespace osem
