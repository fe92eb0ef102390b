#include "osem/collide.hpp"

#include "query/children_in.hpp"
#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

void Collision::Side::enter(unsigned child) {
    const Colour colour = node().colour(child);
    const Node below = colour == Colour::grey ? pool->child(node(), child) : Node::uniform(colour);
    octant = octant.child(child);
    path[octant.level] = below;
}

void Collision::begin(const Octree& a, const Octree& b, const Point& offset) {
    a_.pool = a.pool;
    b_.pool = b.pool;
    a_.octant = root_octant;
    b_.octant = root_octant;
    a_.path[0] = a.top;
    b_.path[0] = b.top;
    for (unsigned axis = 0; axis < 3; ++axis) { // roots two sides apart are as clear as any farther ones
        const std::int32_t by = offset.at[axis];
        offset_.at[axis] = by < -2 * root_side ? -2 * root_side : by > 2 * root_side ? 2 * root_side : by;
    }
    outcome_ = {
        Status::unfinished, Contact::clear, {root_octant, Colour::white}, {root_octant, Colour::white}, 0};
    running_ = true;
    fresh_ = true;
    frame_count_ = 0;
}

bool Collision::step(std::uint32_t pairs) {
    while (running_) {
        if (outcome_.contact == Contact::certain || (!fresh_ && frame_count_ == 0)) {
            outcome_.status = Status::ok;
            running_ = false;
            break;
        }
        if (pairs == 0) return true;
        if (!fresh_ && !advance()) continue;
        fresh_ = false;
        --pairs;
        visit();
    }
    return false;
}

// Enters the next child of the last divided octant; false when it has none left and is done with.
bool Collision::advance() {
    Frame& frame = frames_[frame_count_ - 1];
    if (frame.left == 0) {
        --frame_count_;
        if (frame_count_ > 0) leave();
        return false;
    }
    const unsigned child = lowest(frame.left);
    frame.left = without_lowest(frame.left);
    side(frame.of_b).enter(child);
    return true;
}

// Goes back to the octant that the last frame divides.
void Collision::leave() {
    Octant& octant = side(frames_[frame_count_ - 1].of_b).octant;
    octant = octant.parent();
}

// Divides one octant of the pair: the larger one that has a node. Its children that are leaves are judged at
// once when the other octant is one too.
void Collision::visit() {
    ++outcome_.visited;
    const bool leaf_a = a_.node().is_uniform();
    const bool leaf_b = b_.node().is_uniform();
    const bool of_b = !leaf_b && (leaf_a || b_.octant.level < a_.octant.level);
    const Side& divided = side(of_b);
    const Node& other = side(!of_b).node();
    const std::uint8_t inside = children_at(of_b, 0);
    const std::uint8_t around = children_at(of_b, 1);
    unsigned enter = 0xff;
    if (other.is_uniform()) {
        judge(of_b, inside, around);
        enter = divided.node().grey() & hopeful(other);
    }
    const unsigned reached = outcome_.contact < Contact::possible ? around : inside;
    enter &= reached & hopeful(divided.node());
    if (enter != 0) {
        frames_[frame_count_++] = Frame{of_b, static_cast<std::uint8_t>(enter)};
    } else if (frame_count_ > 0) {
        leave();
    }
}

// The children that may yet show a stronger contact than the one found.
std::uint8_t Collision::hopeful(const Node& node) const {
    const unsigned leaves = outcome_.contact < Contact::possible ? node.may : blacks(node);
    return static_cast<std::uint8_t>(node.grey() | leaves);
}

// The children of the divided octant within `margin` cells of the other one.
std::uint8_t Collision::children_at(bool of_b, std::int32_t margin) const {
    const Octant& other = of_b ? a_.octant : b_.octant;
    CellBox box = {};
    for (unsigned axis = 0; axis < 3; ++axis) {
        box.low.at[axis] = other.corner.at[axis] + (of_b ? -offset_.at[axis] : offset_.at[axis]);
        box.high.at[axis] = box.low.at[axis] + other.side();
    }
    return children_in(of_b ? b_.octant : a_.octant, box, margin);
}

// Judges the leaves among the divided octant's children against the other octant, a leaf.
void Collision::judge(bool of_b, std::uint8_t inside, std::uint8_t around) {
    const Node& node = side(of_b).node();
    const Node& other = side(!of_b).node();
    const auto solid = static_cast<std::uint8_t>(node.may & other.may);
    const auto black = static_cast<std::uint8_t>(inside & blacks(node) & blacks(other));
    note(Contact::certain, of_b, black);
    note(Contact::possible, of_b, static_cast<std::uint8_t>(inside & solid));
    note(Contact::touch, of_b, static_cast<std::uint8_t>(around & solid));
}

// Takes in the first of the children that meet the other octant so, unless something as strong is known.
void Collision::note(Contact contact, bool of_b, std::uint8_t children) {
    if (children == 0 || outcome_.contact >= contact) return;
    outcome_.contact = contact;
    const Side& divided = side(of_b);
    const Side& other = side(!of_b);
    const unsigned child = lowest(children);
    Leaf leaf = {divided.octant, divided.node().colour(child)};
    if (!divided.node().is_uniform()) leaf.octant = leaf.octant.child(child);
    const Leaf beside = {other.octant, other.node().colour(0)};
    outcome_.a = of_b ? beside : leaf;
    outcome_.b = of_b ? leaf : beside;
}

CollisionOutcome collide(Collision& job, const Octree& a, const Octree& b, const Point& offset) {
    job.begin(a, b, offset);
    run_to_end(job);
    return job.finish();
}

} // namespace osem
