#include "osem/boolean.hpp"

#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

std::uint8_t mask(int bits) { return static_cast<std::uint8_t>(bits); }

// What can be said of the eight children at once, a bit a child.
struct Settlement {
    std::uint8_t may; // leaves of the result
    std::uint8_t must;
    std::uint8_t share_a; // children whose subtree in a is the result's
    std::uint8_t share_b;
    std::uint8_t descend; // children to be entered
};

// A grey child beside a leaf: where the leaf dominates it decides alone, where it is neutral the other's
// subtree is the result. `may` and `must` are right wherever both are leaves or one dominates.
Settlement settle_by(const Node& a, const Node& b, int may, int must, int dominated, int neutral_a,
                     int neutral_b) {
    const int grey = a.grey() | b.grey();
    Settlement s;
    s.share_a = mask(a.grey() & neutral_b);
    s.share_b = mask(b.grey() & neutral_a);
    s.descend = mask(grey & ~(dominated | s.share_a | s.share_b));
    const int leaves = ~grey | dominated;
    s.may = mask(may & leaves);
    s.must = mask(must & leaves);
    return s;
}

// Kleene's three-valued connectives on (may, must). A grey child has the bits (0, 1), with which the
// connectives come out right beside a leaf that dominates: black in a union, white in an intersection,
// boundary in an exclusive or.
Settlement settle(Operator op, const Node& a, const Node& b) {
    if (op == Operator::unite) {
        const int dominated = blacks(a) | blacks(b);
        return settle_by(a, b, a.may | b.may, a.must | b.must, dominated, whites(a), whites(b));
    }
    if (op == Operator::exclusive_or) {
        const int dominated = boundaries(a) | boundaries(b);
        const int must = (a.must & ~b.may) | (~a.may & b.must);
        const int may = ~((a.must & b.must) | (~a.may & ~b.may));
        return settle_by(a, b, may, must, dominated, whites(a), whites(b));
    }
    const int dominated = whites(a) | whites(b);
    return settle_by(a, b, a.may & b.may, a.must & b.must, dominated, blacks(a), blacks(b));
}

// Swapping and inverting the masks complements every leaf and leaves grey grey.
Node complemented(const Node& node) { return Node::of(mask(~node.must), mask(~node.may), node.first()); }

// What a leaf stands for where the other operand has a node, by its colour.
constexpr Node uniform_nodes[] = {Node::uniform(Colour::white), Node::uniform(Colour::boundary), Node{},
                                  Node::uniform(Colour::black)};

} // namespace

Status Combination::begin(Operator op, const Octree& a, const Octree& b, NodePool& pool, bool count_only) {
    builder_.reset();
    visited_ = 0;
    if (a.pool != &pool || b.pool != &pool) return Status::pools_differ;
    pool_ = &pool;
    op_ = op;
    complement_b_ = op == Operator::subtract; // a minus b is a and not b
    depth_ = a.depth > b.depth ? a.depth : b.depth;
    level_ = 0;
    visited_ = 1;
    builder_.begin(&pool, count_only);
    enter(a.top, b.top);
    return Status::ok;
}

bool Combination::step(std::uint32_t nodes) {
    while (builder_.building()) {
        Frame& frame = frames_[level_];
        if (frame.left == 0) {
            builder_.close(&frame.a, complement_b_ ? nullptr : &frame.b);
            --level_;
            continue;
        }
        const unsigned child = lowest(frame.left);
        const Node& a = child_of(frame.a, child);
        const Node& b = child_of(frame.b, child);
        if (is_common(a, b)) {
            builder_.graft(child, a);
        } else if (nodes == 0) {
            return true;
        } else {
            --nodes;
            ++visited_;
            combine_children(a, b, child);
        }
        frame.left = without_lowest(frame.left);
    }
    return false;
}

TreeOutcome Combination::finish() { return builder_.finish(depth_); }

std::uint64_t Combination::decided_volume() const {
    if (!builder_.building()) return builder_.finished() ? root_volume : 0;
    std::uint64_t decided = 0;
    for (int level = 0; level <= level_; ++level) {
        const unsigned entered = level < level_ ? 1 : 0;
        decided += (8 - count_bits(frames_[level].left) - entered) * volume_at(level + 1);
    }
    return decided;
}

void Combination::combine_children(const Node& a, const Node& b, unsigned child) {
    if (a.grey() == 0 && b.grey() == 0) {
        const Settlement s = settle(op_, a, complement_b_ ? complemented(b) : b);
        return builder_.eight_leaves(child, s.may, s.must);
    }
    builder_.open(child);
    ++level_;
    enter(a, b);
}

void Combination::enter(const Node& a, const Node& b) {
    Settlement s = settle(op_, a, complement_b_ ? complemented(b) : b);
    if (complement_b_) { // b's subtrees are not those of the result: its complement is written anew
        s.descend = mask(s.descend | s.share_b);
        s.share_b = 0;
    }
    builder_.leaves(s.may, s.must);
    for (std::uint8_t left = s.share_a; left != 0; left = without_lowest(left)) {
        builder_.graft(lowest(left), pool_->child(a, lowest(left)));
    }
    for (std::uint8_t left = s.share_b; left != 0; left = without_lowest(left)) {
        builder_.graft(lowest(left), pool_->child(b, lowest(left)));
    }
    frames_[level_] = Frame{a, b, s.descend};
}

// One subtree combined with itself is itself, for the two operators that are idempotent.
bool Combination::is_common(const Node& a, const Node& b) const {
    return (op_ == Operator::unite || op_ == Operator::intersect) && a == b;
}

const Node& Combination::child_of(const Node& node, unsigned child) const {
    const Colour colour = node.colour(child);
    return colour == Colour::grey ? pool_->child(node, child) : uniform_nodes[static_cast<unsigned>(colour)];
}

TreeOutcome combine(Combination& job, Operator op, const Octree& a, const Octree& b, NodePool& pool) {
    const Status status = job.begin(op, a, b, pool);
    if (status != Status::ok) return {status, 0, 0, a};
    run_to_end(job);
    return job.finish();
}

TreeOutcome complement(Combination& job, const Octree& a, NodePool& pool) {
    return combine(job, Operator::subtract, Octree::uniform(pool, Colour::black), a, pool);
}

} // namespace osem
