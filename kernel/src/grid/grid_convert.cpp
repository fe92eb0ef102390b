#include "osem/grid_convert.hpp"

#include "classify/crossing.hpp"
#include "convert/inside.hpp"
#include "grid/face_in_grid.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

constexpr std::uint32_t entry_words = 3;    // a face and the octants that it meets, the low half first
constexpr std::uint32_t winding_words = 64; // of the reference points of the octants met, in Morton order

// The faces that meet a grid's octant.
struct GridList {
    const Solid& solid;
    std::uint32_t* first;
    const std::uint32_t* end;

    // Notes for every face which octants it meets; the union. Also whether some face lies between octants.
    std::uint64_t meet(const OctantGrid& grid, bool& walls) const {
        std::uint64_t met = 0;
        for (std::uint32_t* entry = first; entry != end; entry += entry_words) {
            const FaceInGrid face(solid, *entry, grid);
            const std::uint64_t octants = face.octants_met();
            entry[1] = static_cast<std::uint32_t>(octants);
            entry[2] = static_cast<std::uint32_t>(octants >> 32);
            met |= octants;
            walls = walls || face.is_between_octants();
        }
        return met;
    }

    void add_crossings(const OctantGrid& grid, WindingLanes& windings) const {
        for (const std::uint32_t* entry = first; entry != end; entry += entry_words) {
            FaceInGrid(solid, *entry, grid).add_crossings(windings);
        }
    }

    // The octants inside among those that no face meets, when no face lies between octants: one winding
    // number for each of the parts in which they hang together.
    std::uint64_t inside_beside(std::uint64_t met, const OctantGrid& grid, std::int32_t winding,
                                WindingRule rule) const {
        const IndexRange all = {0, grid.last};
        std::uint64_t left = octants_in({all, all, all}) & ~met;
        std::uint64_t inside = 0;
        while (left != 0) {
            const unsigned place = lowest_of(left);
            const std::uint64_t part = grown(std::uint64_t{1} << place, left);
            if (is_inside(rule, winding + crossings_to(place, grid))) inside |= part;
            left &= ~part;
        }
        return inside;
    }

  private:
    // How the winding number changes from the grid's first reference point to another one.
    std::int32_t crossings_to(unsigned place, const OctantGrid& grid) const {
        std::int32_t change = 0;
        Point from = grid.corner;
        for (int axis = 2; axis >= 0; --axis) {
            const auto steps = static_cast<std::int32_t>(place >> (2 * axis) & 3U);
            if (steps == 0) continue;
            const std::int32_t length = steps << grid.shift;
            for (const std::uint32_t* entry = first; entry != end; entry += entry_words) {
                change += crossing(solid, *entry, from, static_cast<Axis>(axis), length);
            }
            from.at[axis] += length;
        }
        return change;
    }
};

std::uint8_t children_of(std::uint64_t set, unsigned child) {
    return static_cast<std::uint8_t>(set >> (8 * child));
}

} // namespace

Status GridConversion::begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                             std::uint32_t scratch_size, NodePool* pool) {
    builder_.abandon();
    overflowed_ = false;
    const int greatest_depth = options.leaves == LeafRule::centre ? max_depth - 1 : max_depth;
    if (options.depth < 1 || options.depth > greatest_depth) return Status::depth_out_of_range;
    if (scratch_size < std::uint64_t{entry_words} * solid.view().face_count) return Status::scratch_too_small;
    solid_ = solid.view();
    options_ = options;
    scratch_ = scratch;
    scratch_size_ = scratch_size;
    scratch_used_ = 0;
    visited_ = 0;
    grids_ = 0;
    started_ = false;
    builder_.begin(pool);
    return Status::ok;
}

bool GridConversion::step(std::uint32_t grids) {
    for (; grids > 0 && builder_.building(); --grids) {
        started_ ? visit_next() : visit_root();
        ++visited_;
    }
    return builder_.building();
}

TreeOutcome GridConversion::finish() {
    TreeOutcome outcome = builder_.finish(options_.depth);
    if (overflowed_) outcome.status = Status::scratch_too_small;
    return outcome;
}

std::uint64_t GridConversion::decided_volume() const {
    if (builder_.finished()) return root_volume;
    std::uint64_t decided = 0;
    for (int grid = 0; grid < grids_; ++grid) {
        const Frame& frame = frames_[grid];
        unsigned open = grid + 1 < grids_ ? 1 : 0;
        for (unsigned child = 0; child < 8; ++child) open += count_bits(children_of(frame.left, child));
        decided += ((is_of_eight(grid) ? 8 : 64) - open) * volume_at(level_of(grid));
    }
    return decided;
}

void GridConversion::visit_root() {
    started_ = true;
    Point start = {{-1, 0, 0}};
    for (int axis = 1; axis < 3; ++axis) start.at[axis] = offset();
    std::int32_t winding = 0;
    std::uint32_t* entry = scratch_;
    for (std::uint32_t face = 0; face < solid_.face_count; ++face, entry += entry_words) {
        *entry = face;
        winding += crossing(solid_, face, start, axis_x, offset() + 1);
    }
    reserve(0, entry_words * solid_.face_count);
    visit(root_octant.corner, 0, solid_.face_count, winding);
}

// Goes on to the next octant of the innermost grid that faces meet.
void GridConversion::visit_next() {
    Frame& above = frames_[grids_ - 1];
    const unsigned m = lowest_of(above.left);
    above.left &= above.left - 1;
    if (!is_of_eight(grids_ - 1)) open_child(above, m >> 3);
    builder_.open(m & 7U);
    const unsigned place = place_of(m);
    const std::uint32_t windings = above.first + entry_words * above.faces;
    const std::uint32_t first = windings + winding_words;
    std::uint32_t faces = 0;
    if (!select(above, place, first, faces)) return overflow();
    Point corner = above.corner;
    const int shift = lattice_bits - level_of(grids_ - 1);
    for (unsigned axis = 0; axis < 3; ++axis) {
        corner.at[axis] += static_cast<std::int32_t>(place >> (2 * axis) & 3U) << shift;
    }
    visit(corner, first, faces, static_cast<std::int32_t>(scratch_[windings + m]));
}

// Opens a child of the grid's octant, after the one before it is closed.
void GridConversion::open_child(Frame& frame, unsigned child) {
    if (frame.child == child) return;
    if (frame.child != no_child) builder_.close();
    frame.child = static_cast<std::uint8_t>(child);
    builder_.open(child);
    const std::uint8_t black = children_of(frame.inside, child);
    builder_.leaves(black, black);
}

// Copies the faces that meet an octant to a list of its own. False when there is no room.
bool GridConversion::select(const Frame& above, unsigned place, std::uint32_t first, std::uint32_t& faces) {
    const unsigned half = 1 + (place >> 5);
    const unsigned bit = place & 31U;
    const std::uint32_t words = entry_words * above.faces;
    const std::uint32_t* const end = scratch_ + above.first + words;
    for (const std::uint32_t* entry = scratch_ + above.first; entry != end; entry += entry_words) {
        if ((entry[half] >> bit & 1U) == 0) continue;
        const std::uint32_t word = first + entry_words * faces++;
        if (!reserve(word, entry_words)) return false;
        scratch_[word] = *entry;
    }
    return true;
}

// Whether the scratch has so many words behind others; they are then in use.
bool GridConversion::reserve(std::uint32_t first, std::uint32_t words) {
    if (words > scratch_size_ - first) return false;
    if (scratch_used_ < first + words) scratch_used_ = first + words;
    return true;
}

void GridConversion::overflow() {
    overflowed_ = true;
    builder_.abandon();
}

void GridConversion::visit(const Point& corner, std::uint32_t first, std::uint32_t faces,
                           std::int32_t winding) {
    const bool whole = !is_of_eight(grids_);
    const OctantGrid grid = {corner, lattice_bits - level_of(grids_), offset(), whole ? 3 : 1};
    const bool last = grids_ + 1 == nested_grids(options_.depth);
    const std::uint32_t words = first + entry_words * faces;
    const GridList list = {solid_, scratch_ + first, scratch_ + words};
    if (last && options_.leaves == LeafRule::centre) {
        WindingLanes windings(lanes_, winding);
        list.add_crossings(grid, windings);
        const std::uint64_t black = in_morton_order(windings.inside(options_.winding));
        set_leaves(black, black, 0, whole);
        return close();
    }
    bool walls = false;
    const std::uint64_t met = list.meet(grid, walls);
    if (last && !walls) {
        const std::uint64_t inside =
            in_morton_order(list.inside_beside(met, grid, winding, options_.winding));
        set_leaves(inside | in_morton_order(met), inside, 0, whole);
        return close();
    }
    WindingLanes windings(lanes_, winding);
    list.add_crossings(grid, windings);
    const std::uint64_t open = in_morton_order(met);
    const std::uint64_t inside = in_morton_order(windings.inside(options_.winding) & ~met);
    if (last || open == 0) {
        set_leaves(inside | open, inside, 0, whole);
        return close();
    }
    set_leaves(inside, inside, open, whole);
    Frame& frame = frames_[grids_++];
    frame = Frame{corner, first, faces, open, inside, no_child};
    if (!reserve(words, winding_words)) return overflow();
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
        const unsigned m = lowest_of(left);
        scratch_[words + m] = static_cast<std::uint32_t>(windings.at(place_of(m)));
    }
}

// Sets the leaves of a grid, but for the children of its octant that hold open octants.
void GridConversion::set_leaves(std::uint64_t may, std::uint64_t must, std::uint64_t open, bool whole) {
    if (!whole) return builder_.leaves(static_cast<std::uint8_t>(may), static_cast<std::uint8_t>(must));
    for (unsigned child = 0; child < 8; ++child) {
        if (children_of(open, child) != 0) continue;
        const Node node = Node::of(children_of(may, child), children_of(must, child), 0);
        if (node.is_uniform()) {
            builder_.leaf(child, node.colour(0));
        } else {
            builder_.graft(child, node);
        }
    }
}

// Closes an octant whose grid is done, and every one above that is done with it.
void GridConversion::close() {
    builder_.close();
    while (grids_ > 0 && frames_[grids_ - 1].left == 0) {
        if (frames_[--grids_].child != no_child) builder_.close();
        builder_.close();
    }
}

TreeOutcome convert(GridConversion& job, const CheckedSolid& solid, const ConvertOptions& options,
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool) {
    const Status status = job.begin(solid, options, scratch, scratch_size, pool);
    if (status != Status::ok) return {status, 0, 0, Octree{pool, Node::uniform(Colour::white), 1}};
    while (job.step(UINT32_MAX)) {
    }
    return job.finish();
}

} // namespace osem
