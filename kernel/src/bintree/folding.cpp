#include "osem/bintree.hpp"

#include "bintree/words.hpp"
#include "classify/crossing.hpp"
#include "convert/inside.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

// Which child of its parent the octant of a level at a corner is; that of a block's corner when the block is
// made of several such octants.
unsigned child_at(const Point& corner, int level) {
    const std::int32_t side = root_side >> level;
    unsigned child = 0;
    for (unsigned axis = 0; axis < 3; ++axis) child |= (corner.at[axis] & side) != 0 ? 1U << axis : 0U;
    return child;
}

} // namespace

// Takes the next block in preorder.
void Labelling::fold() {
    const std::uint32_t word = blocks_[at_];
    if (is_halved(at_, word)) {
        ++at_;
        if (block_.level != 0 && halvings_of(block_.level) == 0) {
            builder_.open(child_at(block_.corner, third_of(block_.level)));
        }
        block_ = block_.half(0);
        return;
    }
    set_leaf(word == met_block ? Colour::boundary : colour_of_leaf());
    ++at_;
    while (block_.level != 0) {
        const bool is_second = block_.is_high();
        block_ = block_.parent();
        if (!is_second) {
            block_ = block_.half(1);
            return;
        }
        if (halvings_of(block_.level) == 0) builder_.close();
    }
    phase_ = Phase::done;
}

// A leaf of the bintree is one octant, or two or four of one parent.
void Labelling::set_leaf(Colour colour) {
    if (block_.level == 0) {
        const Node node = Node::uniform(colour);
        builder_.leaves(node.may, node.must);
        builder_.close();
        return;
    }
    constexpr unsigned halved_axes[3] = {7, 4, 6};
    const unsigned child = child_at(block_.corner, third_of(block_.level + 2));
    for (unsigned k = 0; k < 8; ++k) {
        if ((k & halved_axes[halvings_of(block_.level)]) == child) builder_.leaf(k, colour);
    }
}

// The first leaf of a component leads it and comes first; its word then holds the colour, and so do those of
// the leaves after it: a chain of places ends at a colour.
Colour Labelling::colour_of_leaf() {
    std::uint32_t leader = at_;
    while (blocks_[leader] < leader) leader = blocks_[leader];
    if (blocks_[leader] == leader) {
        ++components_;
        blocks_[leader] = is_component_inside() ? black_block : white_block;
    }
    blocks_[at_] = blocks_[leader];
    return blocks_[at_] == black_block ? Colour::black : Colour::white;
}

// From outside the root, where the winding number is 0, to the reference point of the component's first
// block.
bool Labelling::is_component_inside() const {
    const Point& to = block_.corner;
    const Point from = {{-1, to.y(), to.z()}};
    std::int32_t winding = 0;
    for (std::uint32_t face = 0; face < solid_.view().face_count; ++face) {
        winding += crossing(solid_.view(), face, from, axis_x, to.x() + 1);
    }
    return is_inside(winding_, winding);
}

LabellingOutcome Labelling::finish() {
    const bool all_marked = phase_ == Phase::folding || phase_ == Phase::done;
    LabellingOutcome outcome = {builder_.finish(depth_), needed_, components_};
    if (all_marked && !fits()) outcome.built.status = Status::scratch_too_small;
    phase_ = all_marked ? Phase::done : Phase::given_up;
    return outcome;
}

LabellingOutcome convert_by_labelling(Labelling& job, const CheckedSolid& solid, int depth,
                                      WindingRule winding, std::uint32_t* faces, std::uint32_t face_size,
                                      std::uint32_t* blocks, std::uint32_t block_size, NodePool* pool) {
    const Status status = job.begin(solid, depth, winding, faces, face_size, blocks, block_size, pool);
    if (status != Status::ok) return {{status, 0, 0, Octree{pool, Node::uniform(Colour::white), 1}}, 0, 0};
    run_to_end(job);
    return job.finish();
}

} // namespace osem
