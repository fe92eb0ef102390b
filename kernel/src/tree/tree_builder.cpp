#include "osem/tree_builder.hpp"

#include <cstddef>

#include "tree/counts.hpp"
#include "tree/guesses.hpp"
#include "tree/masks.hpp"
#include "tree/unaligned.hpp"

namespace osem {

namespace {

// Stands for the index of a group that was only counted: it equals that of no group in a pool.
constexpr NodeIndex counted_only = static_cast<NodeIndex>(~NodeIndex{0});

// Parts of 64 leaves, eight of them, have no more nodes.
constexpr std::uint32_t most_of_parts = 8 * 8 + 8;

// The children, of eight leaves each, whose leaves are not all alike: 1 in their bytes. Each other one is one
// leaf.
constexpr std::uint64_t bytes_divided(std::uint64_t may, std::uint64_t must) {
    constexpr std::uint64_t lower_bits = 0x7f7f7f7f7f7f7f7f;
    const std::uint64_t changes = ((may ^ may >> 1) | (must ^ must >> 1)) & lower_bits;
    return (changes + lower_bits) >> 7 & 0x0101010101010101; // a byte with any comes to its highest bit
}
constexpr std::uint8_t divided_children(std::uint64_t may, std::uint64_t must) {
    return lowest_of_bytes(bytes_divided(may, must));
}

// A node of eight leaves in one store, which may reach over the next one as well. That is written next, or is
// free: of eight parts the last store is to node 63 of the 72 that there is room for. Bytes of masks come
// first in a node, and of its index none is set.
void write_eight(unsigned char* node, std::uint8_t may, std::uint8_t must) {
    static_assert(offsetof(Node, may) == 0 && offsetof(Node, must) == 1, "the order of put_word");
    static_assert(!guesses_cost_much ||
                      (sizeof(RegisterWord) >= sizeof(Node) && sizeof(RegisterWord) <= 2 * sizeof(Node)),
                  "it is a node, or two");
    put_word(node, may | RegisterWord{must} << 8);
}

Node node_of_eight(std::uint64_t may, std::uint64_t must, unsigned child) {
    return Node::of(children_of(may, child), children_of(must, child), 0);
}

// As Node::is_uniform, of masks that are not put together to a node first: what has just been written byte by
// byte is slow to read as one number. Asked so everywhere it would take more flash.
constexpr bool is_uniform(std::uint8_t may, std::uint8_t must) {
    return must == may ? may == 0 || may == 0xff : may == 0xff && must == 0;
}

// Whether 64 leaves are not all alike: differ from the first one.
constexpr bool is_divided(std::uint64_t may, std::uint64_t must) {
    return ((may ^ (0 - (may & 1U))) | (must ^ (0 - (must & 1U)))) != 0;
}

// The masks of an octant of 64 leaves.
struct Masks {
    std::uint8_t may;
    std::uint8_t must;

    Masks(std::uint64_t all_may, std::uint64_t all_must, std::uint8_t grey)
        : may(static_cast<std::uint8_t>(lowest_of_bytes(all_may) & ~grey)),
          must(static_cast<std::uint8_t>((lowest_of_bytes(all_must) & ~grey) | grey)) {}
};

// Where nodes have been written.
struct Written {
    std::uint32_t first; ///< the last group's first one
    std::uint32_t end;
};

// Writes what is below some parts of 64 leaves, then their nodes. How many children are grey is no good
// guess: so of a part all eight are written, the next one over it if it is a leaf; and then eight parts.
template <bool is_boundary_free>
Written write_parts(Node* nodes, std::uint32_t end, std::uint8_t grey, const std::uint64_t (&all_may)[8],
                    const std::uint64_t (&all_must)[8]) {
    std::uint8_t part_may[8] = {}; // not as nodes, for the same reason
    std::uint8_t part_must[8] = {};
    NodeIndex part_first[8] = {};
    unsigned count = 0;
    auto* group = reinterpret_cast<unsigned char*>(nodes + end);
    for (std::uint8_t left = grey; left != 0; left = without_lowest(left), ++count) {
        const unsigned part = lowest(left);
        const std::uint64_t may = all_may[part];
        const std::uint64_t must = is_boundary_free ? may : all_must[part];
        const std::uint64_t divided = bytes_divided(may, must);
        // Where each child is written, counted in bytes.
        static_assert(8 * sizeof(Node) < 0x100, "it is a byte");
        const std::uint64_t places = divided * (sizeof(Node) * 0x0101010101010100);
        for (unsigned each = 0; each < 8; ++each) {
            write_eight(group + children_of(places, each), children_of(may, each), children_of(must, each));
        }
        const Masks masks(may, must, lowest_of_bytes(divided));
        const auto more = static_cast<std::uint32_t>(divided * 0x0101010101010101 >> 56);
        part_may[count] = masks.may;
        part_must[count] = masks.must;
        part_first[count] = more == 0 ? 0 : static_cast<NodeIndex>(end);
        end += more;
        group += sizeof(Node) * more;
    }
    Node* const parts = nodes + end;
    for (unsigned i = 0; i < 8; ++i) parts[i] = Node::of(part_may[i], part_must[i], part_first[i]);
    return {end, end + count};
}

} // namespace

void TreeBuilder::begin(NodePool* pool, bool count_only) {
    reset();
    pool_ = pool;
    mark_ = pool != nullptr ? pool->used() : 0;
    level_ = 0;
    building_ = true;
    writing_ = pool != nullptr && !count_only;
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
    set_child(child, may, must, 0);
}

void TreeBuilder::subtree(unsigned child, std::uint64_t may, std::uint64_t must) {
    OSEM_ASSERT(building_ && level_ + 2 < max_depth && child < 8 && (must & ~may) == 0);
    const std::uint8_t grey = divided_children(may, must);
    NodeIndex first = 0;
    Node* group = grey == 0 ? nullptr : extend(count_bits(grey), first);
    if (group != nullptr) {
        for (std::uint8_t left = grey; left != 0; left = without_lowest(left)) {
            *group++ = node_of_eight(may, must, lowest(left));
        }
    }
    const Masks masks(may, must, grey);
    set_child(child, masks.may, masks.must, first);
}

template <bool is_boundary_free>
void TreeBuilder::subtree_of_parts(unsigned child, const std::uint64_t (&may)[8],
                                   const std::uint64_t (&must)[8]) {
    OSEM_ASSERT(building_ && level_ + 3 < max_depth && child < 8);
    std::uint32_t divided = 0;
    std::uint32_t leaves_may = 0;
    std::uint32_t leaves_must = 0;
    for (unsigned part = 0; part < 8; ++part) {
        const std::uint64_t part_must = is_boundary_free ? may[part] : must[part];
        OSEM_ASSERT((part_must & ~may[part]) == 0);
        divided |= std::uint32_t{is_divided(may[part], part_must)} << part;
        leaves_may |= static_cast<std::uint32_t>(may[part] & 1U) << part;
        leaves_must |= static_cast<std::uint32_t>(part_must & 1U) << part;
    }
    const auto grey = static_cast<std::uint8_t>(divided);
    const auto uniform_may = static_cast<std::uint8_t>(leaves_may & ~divided);
    const auto uniform_must = static_cast<std::uint8_t>(leaves_must & ~divided);
    if (guesses_cost_much && grey != 0 && writing_ && pool_->capacity() - pool_->used() >= most_of_parts) {
        const Written written = write_parts<is_boundary_free>(pool_->memory_, pool_->used(), grey, may, must);
        NodeIndex first_of_all = 0; // they stand where extend gives room now, which there is
        extend(written.end - pool_->used(), first_of_all);
        return set_child(child, uniform_may, uniform_must | grey, static_cast<NodeIndex>(written.first));
    }
    open(child);
    leaves(uniform_may, uniform_must);
    for (std::uint8_t left = grey; left != 0; left = without_lowest(left)) {
        const unsigned part = lowest(left);
        subtree(part, may[part], must[part]);
    }
    close();
}

void TreeBuilder::subtree_of_512(unsigned child, const std::uint64_t (&may)[8],
                                 const std::uint64_t (&must)[8]) {
    if (guesses_cost_much && &may == &must) return subtree_of_parts<true>(child, may, must);
    subtree_of_parts<false>(child, may, must);
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
    if (level_ == 0) {
        top_ = Node::of(level.may, level.must, first);
        building_ = false;
        closed_ = true;
        return;
    }
    --level_;
    set_child(level.child, level.may, level.must, first);
}

void TreeBuilder::set_child(unsigned child, std::uint8_t may, std::uint8_t must, NodeIndex first) {
    if (is_uniform(may, must)) {
        leaf(child, static_cast<Colour>((may & 1U) | (must & 1U) << 1));
    } else {
        graft(child, Node::of(may, must, first));
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
