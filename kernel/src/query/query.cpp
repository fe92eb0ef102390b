#include "osem/query.hpp"

#include "query/cell_box.hpp"
#include "query/children_in.hpp"
#include "tree/masks.hpp"

namespace osem {

PointOutcome leaf_at(const Octree& tree, const Point& cell) {
    const auto x = static_cast<std::uint32_t>(cell.x());
    const auto y = static_cast<std::uint32_t>(cell.y());
    const auto z = static_cast<std::uint32_t>(cell.z());
    const bool in_root = (x | y | z) >> lattice_bits == 0; // a negative coordinate has high bits too
    unsigned shift = lattice_bits;                         // the leaf's side is 2^shift
    Colour colour = Colour::boundary; // off the root: whoever forgets the status errs on the safe side
    std::uint32_t visited = 0;
    if (in_root) {
        const Node* node = &tree.top;
        unsigned child = 0;
        for (;;) {
            --shift;
            child = (x >> shift & 1U) | (y >> shift & 1U) << 1 | (z >> shift & 1U) << 2;
            const std::uint8_t grey = node->grey();
            if (!contains(grey, child)) break;
            // As NodePool::child, written out for the sake of speed.
            const auto before = static_cast<std::uint8_t>(grey & ~(~std::uint32_t{0} << child));
            node = &tree.pool->at(static_cast<NodeIndex>(node->first() + count_bits(before)));
        }
        colour = node->colour(child);
        visited = lattice_bits - shift;
        if (visited == 1 && node->is_uniform()) ++shift;
    }
    const std::int32_t of_corner = in_root ? -(std::int32_t{1} << shift) : 0;
    const Point corner = {{cell.x() & of_corner, cell.y() & of_corner, cell.z() & of_corner}};
    return {in_root ? Status::ok : Status::point_off_root,
            Leaf{Octant{corner, static_cast<std::uint8_t>(lattice_bits - shift)}, colour}, visited};
}

namespace {

constexpr unsigned near_bit =
    colour_bit(Colour::grey); // solid in or beside the box; free, as no cell is grey
constexpr unsigned all_bits = colour_bit(Colour::white) | solid_colours;

// The nodes whose octants reach the box, in preorder.
class BoxWalk {
  public:
    BoxWalk(const Octree& tree, const CellBox& box) : pool_(tree.pool), box_(box), node_(&tree.top) {}

    // Takes in the leaves of the node reached; false when nothing can change the answer any more.
    bool visit() {
        const std::uint8_t inside = children_in(octant_, box_, 0);
        if ((inside & whites(*node_)) != 0) seen_ |= colour_bit(Colour::white);
        if ((inside & boundaries(*node_)) != 0) seen_ |= colour_bit(Colour::boundary);
        if ((inside & blacks(*node_)) != 0) seen_ |= colour_bit(Colour::black);
        std::uint8_t enter = inside;
        if ((seen_ & near_bit) == 0) { // then what lies beside the box matters as well
            const std::uint8_t around = children_in(octant_, box_, 1);
            if ((around & node_->may) != 0) {
                seen_ |= near_bit;
            } else {
                enter = around;
            }
        }
        path_[octant_.level] = node_;
        left_[octant_.level] = enter & node_->grey();
        return (seen_ & all_bits) != all_bits;
    }

    // Goes on to the next node; false when there is none.
    bool advance() {
        unsigned level = octant_.level;
        while (left_[level] == 0) {
            if (level-- == 0) return false;
        }
        const unsigned child = lowest(left_[level]);
        left_[level] = without_lowest(left_[level]);
        node_ = &pool_->child(*path_[level], child);
        const std::int32_t side = root_side >> level;
        for (unsigned axis = 0; axis < 3; ++axis) {
            octant_.corner.at[axis] &= -side;
            if (((child >> axis) & 1U) != 0) octant_.corner.at[axis] += side / 2;
        }
        octant_.level = static_cast<std::uint8_t>(level + 1);
        return true;
    }

    std::uint8_t colours() const { return static_cast<std::uint8_t>(seen_ & all_bits); }
    bool touches() const { return (seen_ & (solid_colours | near_bit)) == near_bit; }

  private:
    const NodePool* pool_;
    const CellBox& box_;
    const Node* node_; // the one reached, and its octant
    Octant octant_ = {Point{{0, 0, 0}}, 0};
    unsigned seen_ = 0;
    const Node* path_[max_depth];  // the nodes from the top down to it
    std::uint8_t left_[max_depth]; // grey children of each that are still to be entered
};

} // namespace

BoxOutcome colours_in(const Octree& tree, const CellBox& box) {
    BoxOutcome outcome = {fault_of(box), 0, false, 0};
    if (outcome.status != Status::ok) return outcome;
    BoxWalk walk(tree, box);
    do {
        ++outcome.visited;
    } while (walk.visit() && walk.advance());
    outcome.colours = walk.colours();
    outcome.touches = walk.touches();
    return outcome;
}

} // namespace osem
