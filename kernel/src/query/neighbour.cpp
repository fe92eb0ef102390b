#include "osem/neighbour.hpp"

#include "tree/masks.hpp"

namespace osem {

namespace {

// As face_neighbour; when the neighbour is grey, `node` becomes the one that divides it.
NeighbourOutcome find(const Octree& tree, const Octant& octant, OctantFace face, Node& node) {
    NeighbourOutcome outcome = {Status::coordinate_out_of_range, false, root_octant, Colour::boundary, 0};
    if (!is_octant(octant)) return outcome;
    outcome.status = Status::ok;
    Point corner = octant.corner;
    corner.at[face.axis] += face.high ? octant.side() : -octant.side();
    outcome.outside = corner.at[face.axis] < 0 || corner.at[face.axis] >= root_side;
    outcome.colour = Colour::white;
    if (outcome.outside) return outcome;
    node = tree.top;
    outcome.visited = 1;
    if (node.is_uniform()) {
        outcome.colour = node.colour(0);
        return outcome;
    }
    for (Octant& found = outcome.octant;; ++outcome.visited) {
        unsigned child = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            if ((corner.at[axis] & (found.side() / 2)) != 0) child |= 1U << axis;
        }
        found = found.child(child);
        outcome.colour = node.colour(child);
        if (outcome.colour != Colour::grey) return outcome;
        node = tree.pool->child(node, child);
        if (found.level == octant.level) return outcome;
    }
}

} // namespace

NeighbourOutcome face_neighbour(const Octree& tree, const Octant& octant, OctantFace face) {
    Node node;
    return find(tree, octant, face, node);
}

NeighbourWalk::NeighbourWalk(const Octree& tree, const Octant& octant, OctantFace face) : pool_(tree.pool) {
    Node node;
    neighbour_ = find(tree, octant, face, node);
    if (neighbour_.status != Status::ok || neighbour_.outside) return;
    const unsigned low = low_children[face.axis];
    near_ = static_cast<std::uint8_t>(face.high ? low : ~low);
    octant_ = neighbour_.octant;
    single_ = neighbour_.colour != Colour::grey;
    divided_ = !single_;
    if (!divided_) return;
    ++neighbour_.visited;
    path_[octant_.level] = node;
    left_[octant_.level] = near_;
}

bool NeighbourWalk::next(Leaf& leaf) {
    if (single_) {
        single_ = false;
        leaf = {neighbour_.octant, neighbour_.colour};
        return true;
    }
    while (divided_) {
        const unsigned level = octant_.level;
        if (left_[level] == 0) {
            divided_ = level > neighbour_.octant.level;
            if (divided_) octant_ = octant_.parent();
            continue;
        }
        const unsigned child = lowest(left_[level]);
        left_[level] = without_lowest(left_[level]);
        const Colour colour = path_[level].colour(child);
        if (colour != Colour::grey) {
            leaf = {octant_.child(child), colour};
            return true;
        }
        ++neighbour_.visited;
        octant_ = octant_.child(child);
        path_[level + 1] = pool_->child(path_[level], child);
        left_[level + 1] = near_;
    }
    return false;
}

} // namespace osem
