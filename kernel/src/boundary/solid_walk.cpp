#include "osem/boundary.hpp"

namespace osem {

void Boundary::Walk::begin(const Octree& tree, SolidPart part) {
    pool_ = tree.pool;
    part_ = part;
    octant_ = root_octant;
    level_ = 0;
    frames_[0] = Frame{tree.top, 0};
}

bool Boundary::Walk::is_solid(Colour colour) const {
    return colour == Colour::black || (colour == Colour::boundary && part_ == SolidPart::outer);
}

// A uniform top is taken as its eight children: their common sides are no boundary.
bool Boundary::Walk::next(Octant& leaf) {
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
        if (colour == Colour::grey) {
            octant_ = octant;
            frames_[++level_] = Frame{pool_->child(frame.node, child), 0};
        } else if (is_solid(colour)) {
            leaf = octant;
            return true;
        }
    }
}

std::int32_t Boundary::Walk::solid_side(const Point& p) const {
    std::uint32_t apart = 0; // bits in which p differs from the walk's octant
    std::uint32_t off = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const auto coordinate = static_cast<std::uint32_t>(p.at[axis]);
        off |= coordinate & ~std::uint32_t{root_side - 1};
        apart |= coordinate ^ static_cast<std::uint32_t>(octant_.corner.at[axis]);
    }
    if (off != 0) return 0;
    int level = level_;
    while (level > 0 && (apart >> (lattice_bits - level)) != 0) --level;
    const Node* node = &frames_[level].node;
    for (;;) {
        const int bit = lattice_bits - 1 - level;
        unsigned child = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            child |= ((static_cast<std::uint32_t>(p.at[axis]) >> bit) & 1U) << axis;
        }
        const Colour colour = node->colour(child);
        ++level;
        if (colour != Colour::grey) return is_solid(colour) ? root_side >> level : 0;
        node = &pool_->child(*node, child);
    }
}

std::uint64_t Boundary::Walk::volume() const {
    std::uint64_t behind = 0;
    for (int level = 0; level <= level_; ++level) {
        const unsigned entered = level < level_ ? 1U : 0U;
        behind += (frames_[level].child - entered) * volume_at(level + 1);
    }
    return behind;
}

} // namespace osem
