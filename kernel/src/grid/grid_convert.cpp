#include "osem/grid_convert.hpp"

#include "classify/crossing.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/leaves.hpp"
#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

constexpr std::uint32_t winding_words = 64; // of the reference points of the octants met, in Morton order

// They are also where a face's octants and tables lie; and a last grid's space is for its tables, then for
// its parts.
static_assert(winding_words >= 16 + FaceInGrid::scratch_words, "room to meet a face above the last grid");
static_assert(last_grid_space(1) >= FaceInGrid::scratch_words, "room to meet a face in the last grid");
static_assert(last_grid_space(4) >= 16 + 4 && last_grid_space(5) >= 64 + 16 + 4,
              "room for the parts' states");

// Words an entry of a list: a face; above the last grid also the octants that it meets, the low half first.
constexpr std::uint32_t entry_words(bool last) { return last ? 1 : 3; }

// The faces that meet a grid's octant.
struct GridList {
    const Solid& solid;
    std::uint32_t* first;
    const std::uint32_t* end;
    std::uint32_t step; // words an entry

    // Notes for every face which octants it meets; the union. Adds what is crossed. `space` is scratch of 64
    // words.
    std::uint64_t meet(const OctantGrid& grid, RowWindings& windings, std::uint32_t* space) const {
        std::uint64_t met = 0;
        for (std::uint32_t* entry = first; entry != end; entry += step) {
            const FaceInGrid face(solid, *entry, grid);
            const std::uint64_t octants = face.octants_met(space);
            entry[1] = static_cast<std::uint32_t>(octants);
            entry[2] = static_cast<std::uint32_t>(octants >> 32);
            met |= octants;
            face.add_crossings(windings, space);
        }
        return met;
    }

    // The same, the octants met in rows, if they are wanted.
    void meet_leaves(const OctantGrid& grid, RowWindings& windings, std::uint32_t* met,
                     std::uint32_t* space) const {
        for (const std::uint32_t* entry = first; entry != end; entry += step) {
            const FaceInGrid face(solid, *entry, grid);
            if (met != nullptr) face.mark(met, space);
            face.add_crossings(windings, space);
        }
    }
};

} // namespace

Status GridConversion::begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                             std::uint32_t scratch_size, NodePool* pool, const GridOptions& grids) {
    builder_.abandon();
    overflowed_ = false;
    if (options.depth < 1 || options.depth > greatest_depth(options.leaves)) {
        return Status::depth_out_of_range;
    }
    if (grids.last_levels < 1 || grids.last_levels > most_grid_levels) return Status::depth_out_of_range;
    if (!is_octant(grids.octant) || grids.octant.level >= options.depth) return Status::depth_out_of_range;
    const int levels = options.depth - grids.octant.level;
    const bool first_is_last = upper_levels(levels, grids.last_levels) == 0;
    if (scratch_size < std::uint64_t{entry_words(first_is_last)} * solid.view().face_count) {
        return Status::scratch_too_small;
    }
    octant_ = grids.octant;
    last_levels_ = grids.last_levels < levels ? grids.last_levels : levels;
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
        Entry entry = {};
        if (started_ ? enter_next(entry) : enter_root(entry)) visit(entry);
        ++visited_;
    }
    return builder_.building();
}

TreeOutcome GridConversion::finish() {
    TreeOutcome outcome = builder_.finish(levels());
    if (overflowed_) outcome.status = Status::scratch_too_small;
    return outcome;
}

std::uint64_t GridConversion::decided_volume() const {
    if (builder_.finished()) return volume_at(octant_.level);
    std::uint64_t decided = 0;
    for (int grid = 0; grid < grids_; ++grid) {
        const Frame& frame = frames_[grid];
        unsigned open = grid + 1 < grids_ ? 1 : 0;
        for (unsigned child = 0; child < 8; ++child) open += count_bits(children_of(frame.left, child));
        decided += ((is_of_eight(grid) ? 8 : 64) - open) * volume_at(level_of(grid));
    }
    return decided;
}

bool GridConversion::enter_root(Entry& entry) {
    started_ = true;
    Point start = octant_.corner; // where the way along x to the octant's reference point enters the root
    start.at[axis_x] = -1;
    for (int axis = 1; axis < 3; ++axis) start.at[axis] += offset();
    entry = Entry{octant_.corner, 0, solid_.face_count, 0};
    const std::uint32_t step = entry_words(is_last());
    std::uint32_t* word = scratch_;
    for (std::uint32_t face = 0; face < solid_.face_count; ++face, word += step) {
        *word = face;
        entry.winding += crossing(solid_, face, start, axis_x, octant_.corner.x() + offset() + 1);
    }
    return reserve(0, step * solid_.face_count); // as begin has seen
}

// Goes on to the next octant of the innermost grid that faces meet. False when there is no room for its list.
bool GridConversion::enter_next(Entry& entry) {
    Frame& above = frames_[grids_ - 1];
    const unsigned m = lowest_of(above.left);
    above.left &= above.left - 1;
    if (!is_of_eight(grids_ - 1)) open_child(above, m >> 3);
    builder_.open(m & 7U);
    const unsigned place = place_of(m);
    const std::uint32_t windings = above.first + entry_words(false) * above.faces;
    entry =
        Entry{above.corner, windings + winding_words, 0, static_cast<std::int32_t>(scratch_[windings + m])};
    const int shift = lattice_bits - level_of(grids_ - 1);
    for (unsigned axis = 0; axis < 3; ++axis) {
        entry.corner.at[axis] += static_cast<std::int32_t>(place >> (2 * axis) & 3U) << shift;
    }
    if (select(above, place, entry)) return true;
    overflow();
    return false;
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
bool GridConversion::select(const Frame& above, unsigned place, Entry& entry) {
    const unsigned half = 1 + (place >> 5);
    const unsigned bit = place & 31U;
    const std::uint32_t step = entry_words(is_last());
    const std::uint32_t* const end = scratch_ + above.first + std::size_t{entry_words(false)} * above.faces;
    for (const std::uint32_t* face = scratch_ + above.first; face != end; face += entry_words(false)) {
        if ((face[half] >> bit & 1U) == 0) continue;
        const std::uint32_t word = entry.first + step * entry.faces++;
        if (!reserve(word, step)) return false;
        scratch_[word] = *face;
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

void GridConversion::visit(const Entry& entry) {
    if (is_last()) return visit_last(entry);
    const int level = level_of(grids_);
    const OctantGrid grid = {entry.corner, lattice_bits - level, offset(), is_of_eight(grids_) ? 1 : 2};
    const std::uint32_t words = entry.first + entry_words(false) * entry.faces;
    const GridList list = {solid_, scratch_ + entry.first, scratch_ + words, entry_words(false)};
    if (!reserve(words, winding_words)) return overflow();
    const std::uint32_t behind = words + winding_words;
    RowWindings windings(scratch_ + behind, scratch_size_ - behind, grid.levels, options_.winding);
    if (windings.overflowed()) return overflow();
    const std::uint64_t met = list.meet(grid, windings, scratch_ + words); // where winding numbers are to be
    windings.finish(entry.winding);
    if (windings.overflowed()) return overflow();
    reserve(behind, windings.words_used());
    std::uint32_t* const rows = scratch_ + words;
    windings.inside(rows);
    const std::uint64_t open = in_morton_order(met);
    const std::uint64_t inside = in_morton_order(as_mask(rows, 0, grid.levels) & ~met);
    if (is_of_eight(grids_)) {
        builder_.leaves(static_cast<std::uint8_t>(inside), static_cast<std::uint8_t>(inside));
    } else {
        builder_.grandchildren(inside, inside, open);
    }
    if (open == 0) return close();
    frames_[grids_++] = Frame{entry.corner, entry.first, entry.faces, open, inside, no_child};
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
        const unsigned m = lowest_of(left);
        const unsigned place = place_of(m);
        const std::uint32_t row = (place >> 2 & 3U) + ((place >> 4) << grid.levels);
        scratch_[words + m] = static_cast<std::uint32_t>(windings.at(row, place & 3U));
    }
}

// A grid whose octants are leaves.
void GridConversion::visit_last(const Entry& entry) {
    const OctantGrid grid = {entry.corner, lattice_bits - options_.depth, offset(), last_levels_};
    const bool three_valued = options_.leaves == LeafRule::conservative;
    const auto rows = static_cast<std::uint32_t>(grid.rows());
    const std::uint32_t list_end = entry.first + entry.faces;
    const std::uint32_t behind = list_end + (three_valued ? rows : 0) + last_grid_space(last_levels_);
    if (!reserve(list_end, behind - list_end)) return overflow();
    const GridList list = {solid_, scratch_ + entry.first, scratch_ + list_end, entry_words(true)};
    std::uint32_t* const met = three_valued ? scratch_ + list_end + last_grid_space(last_levels_) : nullptr;
    if (three_valued) {
        for (std::uint32_t row = 0; row < rows; ++row) met[row] = 0;
    }
    std::uint32_t* const inside = scratch_ + behind;
    RowWindings windings(inside, scratch_size_ - behind, last_levels_, options_.winding);
    if (windings.overflowed()) return overflow();
    list.meet_leaves(grid, windings, met, scratch_ + list_end);
    windings.finish(entry.winding);
    if (windings.overflowed()) return overflow();
    reserve(behind, windings.words_used());
    windings.inside(inside);
    GridLeaves{last_levels_, inside, met, scratch_ + list_end}.set(builder_);
    close();
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
                    std::uint32_t* scratch, std::uint32_t scratch_size, NodePool* pool,
                    const GridOptions& grids) {
    const Status status = job.begin(solid, options, scratch, scratch_size, pool, grids);
    if (status != Status::ok) return {status, 0, 0, Octree{pool, Node::uniform(Colour::white), 1}};
    run_to_end(job);
    return job.finish();
}

} // namespace osem
