#include "osem/nearest.hpp"

#include "tree/masks.hpp"

namespace osem {

namespace {

constexpr std::int32_t reach = std::int32_t{1} << 29;

Status fault_in_reach(const CellBox& box) {
    Status status = Status::ok;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t low = box.low.at[axis];
        const std::int32_t high = box.high.at[axis];
        if (low < -reach || low > reach || high < -reach || high > reach) {
            return Status::coordinate_out_of_range;
        }
        if (low > high) status = Status::box_empty;
    }
    return status;
}

// Whether a comes before b in Morton order: by the highest bit in which they differ, z before y before x.
bool precedes(const Point& a, const Point& b) {
    std::int32_t highest = 0;
    unsigned by = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::int32_t difference = a.at[axis] ^ b.at[axis];
        if (difference < highest && difference < (difference ^ highest)) continue; // its highest bit is lower
        highest = difference;
        by = axis;
    }
    return a.at[by] < b.at[by];
}

// The search: the octant reached, the nodes above it and their grey children still to be entered.
class Search {
  public:
    Search(const Octree& tree, const CellBox& from, std::uint8_t colours, NearestOutcome& outcome)
        : pool_(tree.pool), from_(from), colours_(colours), outcome_(outcome) {
        path_[0] = tree.top;
    }

    // Takes in the leaves of the node reached.
    void visit() {
        ++outcome_.visited;
        const Node& node = path_[octant_.level];
        std::uint8_t leaves = asked_for(node);
        const Distances distances(octant_, from_);
        for (; leaves != 0; leaves = without_lowest(leaves)) {
            const unsigned child = lowest(leaves);
            offer(distances.to(child), Leaf{octant_.child(child), node.colour(child)});
        }
        left_[octant_.level] = node.grey();
    }

    // Goes on to the nearest child still to be entered; false when none can hold a better leaf.
    bool advance() {
        for (;;) {
            std::uint8_t& left = left_[octant_.level];
            const Distances distances(octant_, from_);
            const unsigned child = nearest_of(left, distances);
            // When the nearest one is no better, and the first of several, none is.
            if (left != 0 && better(distances.to(child), octant_.child(child).corner)) {
                left = static_cast<std::uint8_t>(left & ~(1U << child));
                path_[octant_.level + 1] = pool_->child(path_[octant_.level], child);
                octant_ = octant_.child(child);
                return true;
            }
            if (octant_.level == 0) return false;
            octant_ = octant_.parent();
        }
    }

    void offer(std::uint64_t distance, const Leaf& leaf) {
        if (!better(distance, leaf.octant.corner)) return;
        outcome_.found = true;
        outcome_.distance = distance;
        outcome_.leaf = leaf;
    }

  private:
    // The squares of the gaps between the box and an octant's two halves along each axis.
    class Distances {
      public:
        Distances(const Octant& octant, const CellBox& from) {
            const std::int32_t half = octant.side() / 2;
            for (unsigned axis = 0; axis < 3; ++axis) {
                for (unsigned upper = 0; upper < 2; ++upper) {
                    const std::int32_t low = octant.corner.at[axis] + (upper != 0 ? half : 0);
                    const std::int32_t above = low - from.high.at[axis];
                    const std::int32_t below = from.low.at[axis] - (low + half);
                    const std::int32_t apart = above > below ? above : below;
                    const auto gap = static_cast<std::uint64_t>(apart > 0 ? apart : 0); // below 2^30
                    squares_[axis][upper] = gap * gap;
                }
            }
        }
        std::uint64_t to(unsigned child) const {
            return squares_[0][child & 1U] + squares_[1][(child >> 1) & 1U] + squares_[2][child >> 2];
        }

      private:
        std::uint64_t squares_[3][2];
    };

    static unsigned nearest_of(std::uint8_t children, const Distances& distances) {
        unsigned nearest = 0;
        std::uint64_t least = UINT64_MAX;
        for (; children != 0; children = without_lowest(children)) {
            const std::uint64_t distance = distances.to(lowest(children));
            if (distance >= least) continue;
            least = distance;
            nearest = lowest(children);
        }
        return nearest;
    }

    std::uint8_t asked_for(const Node& node) const {
        unsigned leaves = 0;
        if ((colours_ & colour_bit(Colour::white)) != 0) leaves |= whites(node);
        if ((colours_ & colour_bit(Colour::boundary)) != 0) leaves |= boundaries(node);
        if ((colours_ & colour_bit(Colour::black)) != 0) leaves |= blacks(node);
        return static_cast<std::uint8_t>(leaves);
    }

    // The outcome's distance is the bound as long as nothing is found.
    bool better(std::uint64_t distance, const Point& corner) const {
        if (distance != outcome_.distance) return distance < outcome_.distance;
        return !outcome_.found || precedes(corner, outcome_.leaf.octant.corner);
    }

    const NodePool* pool_;
    const CellBox& from_;
    std::uint8_t colours_;
    NearestOutcome& outcome_;
    Octant octant_ = root_octant;
    Node path_[max_depth];
    std::uint8_t left_[max_depth];
};

} // namespace

NearestOutcome nearest_leaf(const Octree& tree, const CellBox& from, std::uint8_t colours,
                            std::uint64_t within) {
    NearestOutcome outcome = {fault_in_reach(from), false, Leaf{root_octant, Colour::white}, within, 0};
    if (outcome.status != Status::ok) return outcome;
    Search search(tree, from, colours, outcome);
    do {
        search.visit();
    } while (search.advance());
    if (outcome.found && tree.top.is_uniform()) outcome.leaf.octant = root_octant;
    return outcome;
}

} // namespace osem
