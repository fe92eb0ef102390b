#include "osem/tree_builder.hpp"

#include "tree/counts.hpp"
#include "tree/guesses.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// Stands for the index of a group that was only counted: it equals that of no group in a pool.
constexpr NodeIndex counted_only = static_cast<NodeIndex>(~NodeIndex{0});

// The children, of eight leaves each, whose leaves are not all alike: each other one is one leaf.
constexpr std::uint8_t divided_children(std::uint64_t may, std::uint64_t must) {
    constexpr std::uint64_t lower_bits = 0x7f7f7f7f7f7f7f7f;
    const std::uint64_t changes = ((may ^ may >> 1) | (must ^ must >> 1)) & lower_bits;
    return lowest_of_bytes((changes + lower_bits) >> 7); // a byte with any comes to its highest bit
}

Node node_of_eight(std::uint64_t may, std::uint64_t must, unsigned child) {
    return Node::of(children_of(may, child), children_of(must, child), 0);
}

// As node.is_uniform(). The masks of boundary leaves are not asked for as one number in memory: where they
// have just been written one by one, some parts are slow to read that.
constexpr bool is_uniform(const Node& node) {
    return node.may == node.must ? node.is_uniform() : ((node.may ^ 0xffU) | node.must) == 0;
}

} // namespace

void TreeBuilder::begin(NodePool* pool, bool count_only) {
    abandon();
    pool_ = pool;
    mark_ = pool != nullptr ? pool->used() : 0;
    needed_ = 0;
    level_ = 0;
    building_ = true;
    closed_ = false;
    writing_ = pool != nullptr && !count_only;
    exhausted_ = false;
    top_ = Node::uniform(Colour::white);
    levels_[0].may = 0;
    levels_[0].must = 0;
}

void TreeBuilder::open(unsigned child) {
    OSEM_ASSERT(building_ && level_ + 1 < max_depth && child < 8);
    Level& level = levels_[++level_];
    level.may = 0;
    level.must = 0;
    level.child = static_cast<std::uint8_t>(child);
}

void TreeBuilder::leaves(std::uint8_t may, std::uint8_t must) {
    OSEM_ASSERT((must & ~may) == 0);
    levels_[level_].may = may;
    levels_[level_].must = must;
}

void TreeBuilder::leaf(unsigned child, Colour colour) {
    OSEM_ASSERT(child < 8 && colour != Colour::grey);
    Level& level = levels_[level_];
    assign_colour(level.may, level.must, child, colour);
}

void TreeBuilder::graft(unsigned child, const Node& node) {
    OSEM_ASSERT(child < 8);
    Level& level = levels_[level_];
    assign_colour(level.may, level.must, child, Colour::grey);
    level.pending[child] = node;
}

bool TreeBuilder::equals_group(const Level& level, std::uint8_t grey, const Node* like) const {
    if (like == nullptr || like->grey() != grey) return false;
    for (std::uint8_t left = grey; left != 0; left = without_lowest(left)) {
        const unsigned child = lowest(left);
        if (pool_->child(*like, child) != level.pending[child]) return false;
    }
    return true;
}

Node* TreeBuilder::extend(std::uint32_t count, NodeIndex& first) {
    needed_ = counted(needed_, count);
    first = counted_only;
    if (!writing_) return nullptr;
    Node* const group = pool_->extend(count, first);
    if (group == nullptr) {
        pool_->roll_back(mark_);
        writing_ = false;
        exhausted_ = true;
    }
    return group;
}

void TreeBuilder::write_group(const Level& level, std::uint8_t grey, NodeIndex& first) {
    Node* group = extend(count_bits(grey), first);
    if (group == nullptr) return;
    for (std::uint8_t left = grey; left != 0; left = without_lowest(left)) {
        *group++ = level.pending[lowest(left)];
    }
}

void TreeBuilder::grandchildren(std::uint64_t may, std::uint64_t must, std::uint64_t to_open) {
    OSEM_ASSERT(level_ + 1 < max_depth && (must & ~may) == 0);
    const std::uint8_t divided = divided_children(may, must);
    const auto uniform = static_cast<std::uint8_t>(~divided);
    leaves(lowest_of_bytes(may) & uniform, lowest_of_bytes(must) & uniform);
    for (std::uint8_t left = divided; left != 0; left = without_lowest(left)) {
        const unsigned child = lowest(left);
        if (children_of(to_open, child) == 0) graft(child, node_of_eight(may, must, child));
    }
}

void TreeBuilder::eight_leaves(unsigned child, std::uint8_t may, std::uint8_t must) {
    OSEM_ASSERT(building_ && level_ + 1 < max_depth && child < 8 && (must & ~may) == 0);
    set_child(child, Node::of(may, must, 0));
}

void TreeBuilder::subtree(unsigned child, std::uint64_t may, std::uint64_t must) {
    OSEM_ASSERT(building_ && level_ + 2 < max_depth && child < 8 && (must & ~may) == 0);
    const std::uint8_t grey = divided_children(may, must);
    const auto uniform = static_cast<std::uint8_t>(~grey);
    NodeIndex first = 0;
    const std::uint32_t count = count_bits(grey);
    Node* group = count == 0 ? nullptr : extend(count, first);
    if (group == nullptr) {
        // all alike, or counted
    } else if (guesses_cost_much && pool_->capacity() - first >= 8) {
        // How many there are is no good guess: each child is written, the next one over it if it is a leaf.
        for (unsigned each = 0; each < 8; ++each) {
            *group = node_of_eight(may, must, each);
            group += grey >> each & 1U;
        }
    } else {
        for (std::uint8_t left = grey; left != 0; left = without_lowest(left)) {
            *group++ = node_of_eight(may, must, lowest(left));
        }
    }
    set_child(child,
              Node::of(lowest_of_bytes(may) & uniform, (lowest_of_bytes(must) & uniform) | grey, first));
}

void TreeBuilder::close(const Node* like, const Node* or_like) {
    Level& level = levels_[level_];
    const std::uint8_t grey = static_cast<std::uint8_t>(~level.may & level.must);
    NodeIndex first = 0;
    if (grey != 0) {
        if (equals_group(level, grey, like)) {
            first = like->first();
        } else if (equals_group(level, grey, or_like)) {
            first = or_like->first();
        } else {
            write_group(level, grey, first);
        }
    }
    const Node node = Node::of(level.may, level.must, first);
    if (level_ == 0) {
        top_ = node;
        building_ = false;
        closed_ = true;
        return;
    }
    --level_;
    set_child(level.child, node);
}

void TreeBuilder::set_child(unsigned child, const Node& node) {
    if (is_uniform(node)) {
        leaf(child, node.colour(0));
    } else {
        graft(child, node);
    }
}

TreeOutcome TreeBuilder::finish(int depth) {
    TreeOutcome outcome = {exhausted_ ? Status::pool_exhausted : Status::ok, needed_, 0,
                           Octree{pool_, top_, static_cast<std::uint8_t>(depth)}};
    if (!closed_) {
        if (!exhausted_) outcome.status = Status::unfinished;
        abandon();
    } else if (exhausted_) {
        outcome.nodes_missing = needed_ - (pool_->capacity() - mark_);
    }
    writing_ = false; // the nodes are the tree's now
    return outcome;
}

void TreeBuilder::abandon() {
    if (writing_) pool_->roll_back(mark_);
    writing_ = false;
    building_ = false;
    closed_ = false;
    exhausted_ = false;
}

} // namespace osem
