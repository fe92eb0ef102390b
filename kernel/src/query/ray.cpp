#include "osem/ray.hpp"

namespace osem {

namespace {

constexpr bool in_reach(const Point& point) {
    for (const std::int32_t coordinate : point.at) {
        if (coordinate < -segment_reach || coordinate > segment_reach) return false;
    }
    return true;
}

} // namespace

Segment ray(const Point& from, const Point& direction) {
    Segment segment = {from, from};
    Point step = direction;
    if (step == Point{{0, 0, 0}}) return segment;
    for (;;) {
        Point to = from;
        for (unsigned axis = 0; axis < 3; ++axis) to.at[axis] += step.at[axis];
        if (!in_reach(to)) return segment;
        segment.to = to;
        for (std::int32_t& component : step.at) component *= 2; // below 2^31: the step led to within reach
    }
}

SegmentWalk::SegmentWalk(const Octree& tree, const Segment& segment)
    : pool_(tree.pool), top_(tree.top), status_(Status::coordinate_out_of_range) {
    if (!in_reach(segment.from) || !in_reach(segment.to)) return;
    status_ = Status::ok;
    state_ = State::before_root;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t from = segment.from.at[axis];
        const std::int32_t difference = segment.to.at[axis] - from;
        const bool mirrored = difference < 0;
        if (mirrored) mirror_ = static_cast<std::uint8_t>(mirror_ | (1U << axis));
        length_[axis] = mirrored ? -difference : difference;
        start_[axis] = mirrored ? root_side - from : from;
        // The moved start lies a little above the lattice plane; in the mirror a little below.
        start_cell_[axis] = mirrored ? start_[axis] - 1 : start_[axis];
        // Of planes met at one parameter an ascending segment, moved by e^(axis + 1) beyond the start, meets
        // its own earlier, the more so the lower the axis; a descending one later.
        rank_[axis] = static_cast<std::uint8_t>(mirrored ? 5 - axis : axis);
    }
}

// Numerators and lengths are at most 2^30 in size, products 2^60.
bool SegmentWalk::before(const Plane& a, const Plane& b) const {
    const std::int64_t of_a = std::int64_t{a.numerator} * length_[b.axis];
    const std::int64_t of_b = std::int64_t{b.numerator} * length_[a.axis];
    return of_a < of_b || (of_a == of_b && rank_[a.axis] < rank_[b.axis]);
}

// Goes to where the segment is first in the root: its start, or the last of the root's near faces that it
// crosses, if none of the far ones comes before. False when it is never in the root.
bool SegmentWalk::enter_root() {
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        at_[axis] = start_cell_[axis];
        if (start_cell_[axis] >= root_side || end_cell(axis) < 0) return false;
        if (start_cell_[axis] >= 0) continue;
        const Plane near = {-start_[axis], axis};
        if (begins_ || before(entry_, near)) entry_ = near;
        begins_ = false;
    }
    if (!begins_) {
        for (std::uint8_t axis = 0; axis < 3; ++axis) {
            if (length_[axis] != 0) at_[axis] = 0;
            const Plane far = {root_side - start_[axis], axis};
            if (end_cell(axis) >= root_side && before(far, entry_)) return false;
        }
    }
    ++visited_;
    if (top_.is_uniform()) {
        take_leaf(0, top_.colour(0));
    } else {
        enter_leaf(0, begins_ ? 1 : root_side);
    }
    return true;
}

// Goes down from the node of a level to the leaf entered. Of the corner `at_` the bits from `known` up are
// known already; along the axis just crossed, and along those of no length, all of them.
void SegmentWalk::enter_leaf(unsigned level, std::int32_t known) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (length_[axis] != 0) at_[axis] &= -known;
    }
    const Node* node = level == 0 ? &top_ : path_[level];
    for (;;) {
        const std::int32_t half = (root_side >> level) / 2;
        unsigned child = 0;
        for (std::uint8_t axis = 0; axis < 3; ++axis) {
            if (half < known && axis != entry_.axis && length_[axis] != 0) {
                const Plane middle = {at_[axis] + half - start_[axis], axis};
                if (before(middle, entry_)) at_[axis] += half;
            }
            if ((at_[axis] & half) != 0) child |= 1U << axis;
        }
        child ^= mirror_;
        ++level;
        const Colour colour = node->colour(child);
        if (colour != Colour::grey) return take_leaf(level, colour);
        node = &pool_->child(*node, child);
        path_[level] = node;
        ++visited_;
    }
}

// Notes the leaf reached, and the first of its far faces that the segment crosses.
void SegmentWalk::take_leaf(unsigned level, Colour colour) {
    level_ = static_cast<std::uint8_t>(level);
    colour_ = colour;
    ends_ = true;
    const std::int32_t side = root_side >> level;
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        if (length_[axis] == 0) continue;
        at_[axis] &= -side;
        const Plane face = {at_[axis] + side - start_[axis], axis};
        if (ends_ || before(face, exit_)) exit_ = face;
        ends_ = false;
    }
    if (!ends_) ends_ = at_[exit_.axis] + side > end_cell(exit_.axis);
}

// Crosses the face of exit into the leaf behind it; false when that is the end of the root.
bool SegmentWalk::cross() {
    const std::int32_t side = root_side >> level_;
    const std::int32_t old = at_[exit_.axis];
    at_[exit_.axis] = old + side;
    if (old + side == root_side) return false;
    entry_ = exit_;
    begins_ = false;
    unsigned level = level_;
    while (((old ^ (old + side)) >> (lattice_bits - level)) != 0) --level; // up to the octant that holds both
    enter_leaf(level, side);
    return true;
}

bool SegmentWalk::next(Passage& passage) {
    if (state_ == State::done) return false;
    const bool found = state_ == State::before_root ? enter_root() : !ends_ && cross();
    state_ = found ? State::in_leaf : State::done;
    if (!found) return false;
    passage.leaf = {octant(), colour_};
    passage.entry = begins_ ? Parameter{0, 1} : parameter(entry_);
    passage.exit = ends_ ? Parameter{1, 1} : parameter(exit_);
    passage.begins = begins_;
    passage.ends = ends_;
    passage.entered_axis = static_cast<Axis>(entry_.axis);
    passage.left_axis = static_cast<Axis>(exit_.axis);
    return true;
}

Octant SegmentWalk::octant() const {
    Octant octant = {Point{{0, 0, 0}}, level_};
    const std::int32_t side = octant.side();
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t at = at_[axis] & -side;
        octant.corner.at[axis] = ((mirror_ >> axis) & 1U) != 0 ? root_side - side - at : at;
    }
    return octant;
}

bool SegmentWalk::next_crossing(Crossing& crossing) {
    Passage passage;
    for (Colour before = colour_; next(passage); before = colour_) {
        if (passage.begins || colour_ == before) continue;
        crossing = {passage.entry, passage.entered_axis, before, colour_, passage.leaf};
        return true;
    }
    if (ends_ || colour_ == Colour::white) return false; // it has not left the root, or from white
    crossing = {parameter(exit_), static_cast<Axis>(exit_.axis), colour_, Colour::white,
                Leaf{root_octant, Colour::white}};
    colour_ = Colour::white;
    return true;
}

HitOutcome first_hit(const Octree& tree, const Segment& segment, std::uint8_t colours) {
    HitOutcome outcome = {};
    SegmentWalk walk(tree, segment);
    outcome.status = walk.status();
    while (!outcome.hit && walk.next(outcome.passage)) {
        outcome.hit = (colours & colour_bit(outcome.passage.leaf.colour)) != 0;
    }
    outcome.visited = walk.visited();
    return outcome;
}

} // namespace osem
