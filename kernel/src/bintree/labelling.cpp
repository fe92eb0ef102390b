#include "osem/bintree.hpp"

#include "bintree/words.hpp"
#include "classify/box.hpp"
#include "classify/crossing.hpp"
#include "tree/counts.hpp"
#include "tree/disjoint_sets.hpp"

namespace osem {

namespace {

Box box_of(const Block& block) {
    Box box = {block.corner, block.corner};
    for (int axis = 0; axis < 3; ++axis) box.hi.at[axis] += block.side(axis);
    return box;
}

bool lies_in_plane(const Solid& solid, std::uint32_t face, Axis axis, std::int32_t plane) {
    const std::uint32_t end = solid.first_corner(solid.end_ring(face));
    for (std::uint32_t i = solid.first_corner(solid.first_ring(face)); i < end; ++i) {
        if (solid.vertices[solid.corners[i]].at[axis] != plane) return false;
    }
    return true;
}

} // namespace

Status Labelling::begin(const CheckedSolid& solid, int depth, WindingRule winding, std::uint32_t* faces,
                        std::uint32_t face_size, std::uint32_t* blocks, std::uint32_t block_size,
                        NodePool* pool) {
    builder_.reset();
    needed_ = 0;
    components_ = 0;
    visited_ = 0;
    pairs_ = 0;
    stages_ = StageCounts{};
    phase_ = Phase::done;
    if (depth < 1 || depth > max_depth) return Status::depth_out_of_range;
    if (face_size < convert_scratch(solid.view())) return Status::scratch_too_small;
    solid_ = solid;
    depth_ = depth;
    winding_ = winding;
    list_ = faces;
    for (std::uint32_t face = 0; face < solid.view().face_count; ++face) list_[face] = face;
    blocks_ = blocks;
    block_size_ = block_size < most_blocks ? block_size : most_blocks;
    count_ = 0;
    first_met_ = 0;
    at_ = 0;
    block_ = Block{root_octant.corner, 0};
    phase_ = Phase::marking;
    builder_.begin(pool);
    return Status::ok;
}

bool Labelling::step(std::uint32_t steps) {
    for (; steps > 0 && phase_ >= Phase::marking; --steps) {
        switch (phase_) {
        case Phase::marking:
            mark();
            break;
        case Phase::linking:
            link();
            break;
        default:
            fold();
        }
    }
    return phase_ >= Phase::marking;
}

// Blocks past the end of the scratch are only counted.
void Labelling::append(std::uint32_t word) {
    if (count_ < block_size_) blocks_[count_] = word;
    count_ = counted(count_, 1);
    if (needed_ < count_) needed_ = count_;
}

void Labelling::mark() {
    ++visited_;
    const std::uint32_t faces =
        select_faces(solid_.view(), box_of(block_), list_,
                     block_.level == 0 ? solid_.view().face_count : frames_[block_.level - 1].faces, stages_);
    met_ = faces != 0;
    if (!met_) {
        append(count_); // a component by itself so far
    } else if (block_.level == 3 * depth_) {
        append(met_block);
    } else {
        frames_[block_.level] = Frame{faces, count_};
        append(met_block); // until the second half's place is known
        block_ = block_.half(0);
        return;
    }
    leave();
}

// Goes on to the second half of the block above, or closes it: two boundary leaves become one, other halves
// are linked in the plane between them.
void Labelling::leave() {
    while (block_.level != 0) {
        const std::uint32_t bit = block_.level - 1U;
        if (!block_.is_high()) {
            if (fits()) blocks_[frames_[bit].index] = count_;
            first_met_ = (first_met_ & ~(std::uint64_t{1} << bit)) | (std::uint64_t{met_} << bit);
            block_ = block_.parent().half(1);
            return;
        }
        block_ = block_.parent();
        met_ = met_ && ((first_met_ >> bit) & 1U) != 0;
        if (met_) {
            if (fits()) blocks_[frames_[bit].index] = met_block;
            count_ -= 2; // past the greatest count it no longer matters: they do not fit
        } else if (fits()) {
            start_linking();
            return;
        }
    }
    phase_ = fits() ? Phase::folding : Phase::done;
}

// Brings the faces that lie in the plane between the halves to the front of the block's list.
void Labelling::start_linking() {
    const Frame& frame = frames_[block_.level];
    const Axis axis = block_.axis();
    const std::int32_t plane = block_.corner.at[axis] + block_.half_side();
    walls_ = 0;
    for (std::uint32_t i = 0; i < frame.faces; ++i) {
        const std::uint32_t face = list_[i];
        if (!lies_in_plane(solid_.view(), face, axis, plane)) continue;
        list_[i] = list_[walls_];
        list_[walls_++] = face;
    }
    link_[0] = Link{frame.index + 1, blocks_[frame.index], block_.half(0)};
    links_ = 1;
    phase_ = Phase::linking;
}

// Takes a pair of blocks on either side of the plane: both are leaves and linked, or their halves along the
// plane are paired, a leaf standing for its own halves.
void Labelling::link() {
    if (links_ == 0) {
        phase_ = Phase::marking;
        leave();
        return;
    }
    ++pairs_;
    const Link link = link_[--links_];
    const std::uint32_t low = blocks_[link.low];
    const std::uint32_t high = blocks_[link.high];
    if (low == met_block || high == met_block) return;
    const bool low_halved = is_halved(link.low, low);
    const bool high_halved = is_halved(link.high, high);
    if (!low_halved && !high_halved) {
        if (change_across(link.block) == 0) unite_sets(blocks_, link.low, link.high);
        return;
    }
    const Link first = {low_halved ? link.low + 1 : link.low, high_halved ? link.high + 1 : link.high,
                        link.block.half(0)};
    const Link second = {low_halved ? low : link.low, high_halved ? high : link.high, link.block.half(1)};
    if (link.block.axis() == block_.axis()) {
        link_[links_++] = Link{second.low, first.high, second.block}; // those that touch the plane
    } else {
        link_[links_++] = second;
        link_[links_++] = first;
    }
}

// How the winding number changes across the plane, from a block below it to one above: on a path of one unit
// which stays in the two, so that only faces in the plane can be crossed.
std::int32_t Labelling::change_across(const Block& below) const {
    const Axis axis = block_.axis();
    Point from = below.corner;
    from.at[axis] = block_.corner.at[axis] + block_.half_side() - 1;
    std::int32_t change = 0;
    for (std::uint32_t i = 0; i < walls_; ++i) change += crossing(solid_.view(), list_[i], from, axis, 1);
    return change;
}

} // namespace osem
