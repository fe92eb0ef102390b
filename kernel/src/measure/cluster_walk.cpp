#include "osem/cluster_walk.hpp"

#include "measure/leaf_blocks.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// A cluster's parts, and the placements of the root. Along each axis a part lies on the low side, on the high
// side or in the middle plane; the root lies between its two borders, or one of them is looked at.
constexpr unsigned parts = 27;
struct PartTable {
    std::uint8_t middle[parts]; // axes along which the part is in the middle plane
    std::uint8_t high[parts];   // axes along which it is on the high side
};

// unreachable: at run time, as the compiler makes the table.
constexpr PartTable make_parts() {
    PartTable table = {};
    for (unsigned part = 0; part < parts; ++part) {
        unsigned digits = part;
        for (unsigned axis = 0; axis < 3; ++axis, digits /= 3) {
            const unsigned bit = 1U << axis;
            if (digits % 3 == 2) table.middle[part] = static_cast<std::uint8_t>(table.middle[part] | bit);
            if (digits % 3 == 1) table.high[part] = static_cast<std::uint8_t>(table.high[part] | bit);
        }
    }
    return table;
}

constexpr PartTable table = make_parts();
constexpr unsigned root_itself = parts - 1; // in the middle along every axis

// The subsets of a set of axes, as a mask.
constexpr std::uint8_t subsets[8] = {0x01, 0x03, 0x05, 0x0f, 0x11, 0x33, 0x55, 0xff};

// Stands for the top node, which is in no pool: no node has this index.
constexpr NodeIndex top_index = static_cast<NodeIndex>(~NodeIndex{0});

} // namespace

void ClusterWalk::begin(const Octree& tree, unsigned most_axes, bool border, const LeafBlocks& blocks) {
    pool_ = tree.pool;
    top_ = tree.top;
    blocks_ = blocks;
    visited_ = 0;
    most_axes_ = static_cast<std::uint8_t>(most_axes);
    roots_ = parts;
    border_ = border;
    level_ = -1;
}

bool ClusterWalk::fits(const Frame& frame) const {
    const std::uint8_t middle = table.middle[frame.next - 1];
    return (middle & frame.axes) == frame.axes && count_bits(middle) <= most_axes_;
}

bool ClusterWalk::ahead() {
    for (; level_ >= 0; --level_) {
        Frame& frame = frames_[level_];
        while (frame.next > 0 && !fits(frame)) --frame.next;
        if (frame.next > 0) return true;
    }
    while (roots_ > 0) {
        const std::uint8_t middle = table.middle[roots_ - 1];
        const unsigned axes = 3 - count_bits(middle);
        if (axes <= most_axes_ && (axes == 0 || border_)) return true;
        --roots_;
    }
    return false;
}

bool ClusterWalk::visit() {
    ++visited_;
    found_ = level_ + 1;
    Frame& to = frames_[found_];
    if (level_ < 0) {
        place_root(--roots_);
    } else {
        Frame& from = frames_[level_];
        const unsigned part = --from.next;
        const unsigned middle = table.middle[part];
        const unsigned divided = middle & ~unsigned{from.axes};
        to.axes = static_cast<std::uint8_t>(middle);
        to.may = 0;
        to.must = 0;
        for (unsigned slot = 0; slot <= middle; ++slot) {
            if ((slot & ~middle) != 0) continue;
            // An octant on the low side of the piece has its high children there.
            const unsigned child = (~slot & from.axes) | (slot & divided) | table.high[part];
            fill(from, slot & from.axes, child, to, slot);
        }
    }
    if ((~to.may & to.must) == 0) return true;
    to.next = parts;
    level_ = found_;
    return false;
}

// Of the slots around a part of the root's border one is the root; the others are white.
void ClusterWalk::place_root(unsigned part) {
    Frame& to = frames_[0];
    const unsigned axes = 7U & ~unsigned{table.middle[part]};
    const unsigned slot = axes & ~unsigned{table.high[part]};
    to.axes = static_cast<std::uint8_t>(axes);
    to.may = 0;
    to.must = 0;
    for (std::uint32_t& place : to.places) place = 0;
    if (!top_.is_uniform()) {
        assign_colour(to.may, to.must, slot, Colour::grey);
        to.nodes[slot] = top_index;
        return;
    }
    assign_colour(to.may, to.must, slot, top_.colour(0));
    if (blocks_.words != nullptr) to.places[slot] = leaf_place(top_, blocks_.colours, 0, 0);
}

void ClusterWalk::fill(const Frame& from, unsigned from_slot, unsigned child, Frame& to,
                       unsigned slot) const {
    const unsigned may = (from.may >> from_slot) & 1U;
    const unsigned must = (from.must >> from_slot) & 1U;
    const std::uint32_t block = from.places[from_slot];
    if (may != 0 || must == 0) { // a leaf stays itself
        to.may = static_cast<std::uint8_t>(to.may | (may << slot));
        to.must = static_cast<std::uint8_t>(to.must | (must << slot));
        to.places[slot] = block;
        return;
    }
    const NodeIndex index = from.nodes[from_slot];
    const Node& node = index == top_index ? top_ : pool_->at(index);
    const bool placed = blocks_.words != nullptr;
    assign_colour(to.may, to.must, slot, node.colour(child));
    if (node.colour(child) != Colour::grey) {
        to.places[slot] = placed ? leaf_place(node, blocks_.colours, block, child) : 0;
        return;
    }
    const unsigned before = node.grey() & ((1U << child) - 1U);
    to.nodes[slot] = static_cast<NodeIndex>(node.first() + count_bits(static_cast<std::uint8_t>(before)));
    to.places[slot] = placed ? child_block(node, blocks_, block, child) : 0;
}

Cluster ClusterWalk::cluster() const {
    const Frame& frame = frames_[found_];
    return Cluster{frame.axes,
                   static_cast<std::uint8_t>(found_),
                   roots_ < root_itself,
                   subsets[frame.axes],
                   frame.may,
                   frame.must,
                   frame.places};
}

} // namespace osem
