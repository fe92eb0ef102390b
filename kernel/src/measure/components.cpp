#include "osem/components.hpp"

#include "measure/leaf_blocks.hpp"
#include "tree/disjoint_sets.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// A leaf's word holds another place of its set, and later the number of its component, told apart by a bit.
// So places are below 2^31.
constexpr std::uint32_t numbered = std::uint32_t{1} << 31;

bool on_border(const Octant& octant) {
    bool touches = false;
    for (const std::int32_t low : octant.corner.at) {
        touches = touches || low == 0 || low + octant.side() == root_side;
    }
    return touches;
}

void add_leaf(Component& component, const Octant& octant) {
    const bool first = component.leaves == 0;
    component.volume += volume_at(octant.level);
    component.leaves += 1;
    component.touches_border = component.touches_border || on_border(octant);
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t low = octant.corner.at[axis];
        const std::int32_t high = low + octant.side();
        std::int32_t& box_low = component.box.low.at[axis];
        std::int32_t& box_high = component.box.high.at[axis];
        if (first || low < box_low) box_low = low;
        if (first || high > box_high) box_high = high;
    }
}

} // namespace

void ComponentLabelling::BlockWalk::begin_writing(const Octree& tree, std::uint8_t colours,
                                                  std::uint32_t* words, std::uint32_t size) {
    pool_ = tree.pool;
    words_ = words;
    size_ = size;
    blocks_ = LeafBlocks{words, colours};
    end_ = 0;
    nodes_ = 0;
    level_ = -1;
    open_block(tree.top);
}

void ComponentLabelling::BlockWalk::open_block(const Node& node) {
    const unsigned leaves = count_bits(counted_children(node, blocks_.colours));
    const auto start = static_cast<std::uint32_t>(end_);
    end_ += 1 + leaves;
    ++nodes_;
    frames_[++level_] = Frame{start, 0, node, node.grey()};
    if (end_ > size_) return;
    for (std::uint32_t place = start + 1; place < end_; ++place) words_[place] = place;
}

bool ComponentLabelling::BlockWalk::write() {
    while (frames_[level_].child == 0) {
        const std::uint32_t start = frames_[level_].block;
        if (end_ <= size_) words_[start] = static_cast<std::uint32_t>(end_) - start;
        if (--level_ < 0) return false;
    }
    Frame& frame = frames_[level_];
    const unsigned child = lowest(frame.child);
    frame.child = without_lowest(frame.child);
    open_block(pool_->child(frame.node, child));
    return true;
}

void ComponentLabelling::BlockWalk::begin_reading(const Octree& tree, const LeafBlocks& blocks) {
    pool_ = tree.pool;
    blocks_ = blocks;
    octant_ = root_octant;
    level_ = -1;
    enter(tree.top, 0);
}

void ComponentLabelling::BlockWalk::enter(const Node& node, std::uint32_t block) {
    const unsigned leaves = count_bits(counted_children(node, blocks_.colours));
    frames_[++level_] = Frame{block + 1 + leaves, block + 1, node, 0};
}

bool ComponentLabelling::BlockWalk::read(Leaf& leaf, std::uint32_t& place) {
    for (;;) {
        Frame& frame = frames_[level_];
        if (frame.child == 8) {
            if (level_ == 0) return false;
            --level_;
            octant_ = octant_.parent();
            continue;
        }
        const unsigned child = frame.child++;
        const Colour colour = frame.node.colour(child);
        if (colour == Colour::grey) {
            const std::uint32_t block = frame.block;
            frame.block += blocks_.words[block];
            octant_ = octant_.child(child);
            enter(pool_->child(frame.node, child), block);
        } else if (contains(counted_children(frame.node, blocks_.colours), child)) {
            leaf = Leaf{frame.node.is_uniform() ? root_octant : octant_.child(child), colour};
            place = frame.leaf++;
            return true;
        }
    }
}

void ComponentLabelling::begin(const Octree& tree, std::uint8_t colours, Connectivity connectivity,
                               std::uint32_t* scratch, std::uint32_t scratch_size) {
    tree_ = tree;
    words_ = scratch;
    size_ = scratch_size < numbered ? scratch_size : numbered - 1;
    colours_ = colours;
    pass_ = Pass::write;
    passed_ = 0;
    leaves_ = 0;
    outside_ = 0;
    components_ = 0;
    walk_.begin_writing(tree_, colours, scratch, size_);
    clusters_.begin(tree_, static_cast<unsigned>(connectivity), (colours & colour_bit(Colour::white)) != 0,
                    blocks());
}

bool ComponentLabelling::step(std::uint32_t units) {
    for (; units > 0 && pass_ != Pass::none && pass_ != Pass::done; --units) advance();
    return pass_ != Pass::none && pass_ != Pass::done;
}

void ComponentLabelling::advance() {
    if (pass_ == Pass::write) {
        ++passed_;
        if (!walk_.write()) start_uniting();
    } else if (pass_ == Pass::unite) {
        if (clusters_.visit()) unite_cluster();
        if (!clusters_.ahead()) start_numbering();
    } else {
        Leaf leaf = {};
        std::uint32_t place = 0;
        ++passed_;
        static_cast<void>(walk_.read(leaf, place)); // there is one for each of leaves_
        number_leaf(place);
        if (--leaves_ == 0) pass_ = Pass::done;
    }
}

void ComponentLabelling::start_uniting() {
    leaves_ = walk_.words_needed() - walk_.nodes();
    pass_ = Pass::done;
    if (walk_.words_needed() > size_ || leaves_ == 0) return;
    static_cast<void>(clusters_.ahead()); // as it is: there is the root itself
    pass_ = Pass::unite;
}

void ComponentLabelling::start_numbering() {
    pass_ = Pass::number;
    walk_.begin_reading(tree_, blocks());
}

void ComponentLabelling::unite_cluster() {
    const Cluster cluster = clusters_.cluster();
    std::uint32_t first = 0;
    for (std::uint8_t left = cluster.slots; left != 0; left = without_lowest(left)) {
        const std::uint32_t place = cluster.places[lowest(left)];
        if (place == 0 || place == first) continue;
        if (first == 0) {
            first = place;
        } else {
            unite_sets(words_, first, place);
        }
    }
    if (first == 0 || !cluster.border) return;
    if (outside_ == 0) {
        outside_ = first;
    } else {
        unite_sets(words_, outside_, first);
    }
}

// Every set's first leaf in Morton order gives the leader its number and takes it; whoever comes later finds
// it at the leader or at a leaf on the way.
void ComponentLabelling::number_leaf(std::uint32_t place) {
    std::uint32_t leader = place;
    while ((words_[leader] & numbered) == 0 && words_[leader] != leader) leader = words_[leader];
    if ((words_[leader] & numbered) == 0) words_[leader] = numbered | components_++;
    words_[place] = words_[leader];
}

ComponentOutcome ComponentLabelling::finish() const {
    ComponentOutcome outcome = {Status::unfinished, 0, 0};
    if (pass_ != Pass::done) return outcome;
    outcome.scratch_needed = walk_.words_needed();
    outcome.status = outcome.scratch_needed > size_ ? Status::scratch_too_small : Status::ok;
    outcome.components = components_;
    return outcome;
}

std::uint32_t ComponentLabelling::fill(Component* components, std::uint32_t capacity) const {
    const std::uint32_t count = components_ < capacity ? components_ : capacity;
    for (std::uint32_t i = 0; i < count; ++i) components[i] = Component{};
    BlockWalk walk;
    walk.begin_reading(tree_, blocks());
    Leaf leaf = {};
    for (std::uint32_t place = 0; walk.read(leaf, place);) {
        const std::uint32_t component = words_[place] & ~numbered;
        if (component < count) add_leaf(components[component], leaf.octant);
    }
    return count;
}

std::uint32_t ComponentLabelling::component_of(const Point& cell) const {
    for (const std::int32_t coordinate : cell.at) {
        if (coordinate < 0 || coordinate >= root_side) return no_component;
    }
    const Node* node = &tree_.top;
    std::uint32_t block = 0;
    for (std::int32_t half = root_side / 2;; half /= 2) {
        unsigned child = 0;
        for (unsigned axis = 0; axis < 3 && !node->is_uniform(); ++axis) {
            if ((cell.at[axis] & half) != 0) child |= 1U << axis;
        }
        if (node->colour(child) != Colour::grey) {
            const std::uint32_t place = leaf_place(*node, colours_, block, child);
            return place == 0 ? no_component : words_[place] & ~numbered;
        }
        block = child_block(*node, blocks(), block, child);
        node = &tree_.pool->child(*node, child);
    }
}

} // namespace osem
