#include "osem/grid_convert.hpp"

#include "classify/crossing.hpp"
#include "grid/each_face.hpp"
#include "grid/face_in_grid.hpp"
#include "grid/last_octants.hpp"
#include "grid/leaves.hpp"
#include "grid/placed_faces.hpp"
#include "grid/set_zero.hpp"
#include "tree/masks.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

constexpr std::uint32_t winding_words = 64; // of the reference points of the octants met, in Morton order

// They are also where a face's octants and tables lie.
static_assert(winding_words >= 16 + last_grid_space(2), "room to meet a face above the last grid");
static_assert(last_grid_space(4) >= 4 && last_grid_space(5) >= 16, "room for the cubes' states");

// Words of a list above the last grids, behind each other: the faces; which octants each of them meets, the
// low halves first, then the high ones; and the winding numbers. Before these are known the placed faces are
// sorted there.
constexpr std::uint64_t words_above(std::uint32_t faces) {
    return std::uint64_t{3} * faces + PlacedFaces::words_to_sort;
}
static_assert(PlacedFaces::words_to_sort >= winding_words + 3 * 16, "room for rows' winding numbers");
constexpr std::uint32_t in_a_look = 8; // halves that are looked at at once
static_assert(winding_words >= in_a_look, "a look at the last half ends in the words behind it");

// The listed faces that meet a grid's octant; of the first grid, those whose extents reach into it.
struct GridList {
    const Solid& solid;
    const std::uint32_t* faces;
    std::uint32_t count;

    // Notes for every face which octants it meets; the union. Adds what is crossed. `space` is scratch of 64
    // words.
    std::uint64_t meet(const OctantGrid& grid, RowWindings& windings, std::uint32_t* halves,
                       std::uint32_t* space) const {
        std::uint64_t met = 0;
        auto ahead = faces_ahead(solid, 0, count, [this](std::uint32_t next) { return faces[next]; });
        for (std::uint32_t i = 0; i < count; ++i) {
            ahead.send(i);
            FaceInGrid face(solid, faces[i], grid);
            const std::uint64_t octants = face.octants_met(space);
            halves[i] = static_cast<std::uint32_t>(octants);
            halves[count + i] = static_cast<std::uint32_t>(octants >> 32);
            met |= octants;
            face.add_crossings(windings, space);
        }
        return met;
    }
};

// The shift is below 32 where there are placed faces.
PlacedFaces::Digit digit_at(int levels_below, bool of_eight) {
    return {3 * static_cast<unsigned>(levels_below), of_eight ? 7U : 63U};
}

} // namespace

Status GridConversion::begin(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t* scratch,
                             std::uint32_t scratch_size, NodePool* pool, const GridOptions& grids) {
    builder_.reset();
    overflowed_ = false;
    scratch_size_ = 0;
    room_ = 0;
    scratch_used_ = 0;
    visited_ = 0;
    grids_ = 0;
    if (options.depth < 1 || options.depth > greatest_depth(options.leaves)) {
        return Status::depth_out_of_range;
    }
    if (grids.last_levels < 1 || grids.last_levels > most_grid_levels) return Status::depth_out_of_range;
    if (!is_octant(grids.octant) || grids.octant.level >= options.depth) return Status::depth_out_of_range;
    const int levels = options.depth - grids.octant.level;
    if (scratch_size < solid.view().face_count) return Status::scratch_too_small;
    octant_ = grids.octant;
    last_levels_ = grids.last_levels < levels ? grids.last_levels : levels;
    solid_ = solid.view();
    options_ = options;
    scratch_ = scratch;
    scratch_size_ = scratch_size;
    room_ = scratch_size;
    started_ = false;
    builder_.begin(pool);
    return Status::ok;
}

bool GridConversion::step(std::uint32_t grids) {
    for (; grids > 0 && builder_.building(); --grids) {
        Entry entry = {};
        if (started_ ? enter_next(entry) : enter_root(entry)) {
            is_last() ? visit_last(entry) : visit(entry);
        }
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
    entry = Entry{octant_.corner, 0, 0, 0, 0, 0};
    const std::int32_t length = octant_.corner.x() + offset() + 1;
    const bool centres = options_.leaves == LeafRule::centre;
    const LastOctants last(octant_, levels_above(), centres ? lattice_bits - options_.depth : 0, offset());
    const Solid solid = solid_; // a compiler cannot know that no word of scratch is part of it
    auto ahead = faces_ahead(solid, 0, solid.face_count, [](std::uint32_t next) { return next; });
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        ahead.send(face);
        const FacePlaces places = last.places_of(solid, face);
        if (places.has_effect && !list_or_place(face, places, entry)) {
            overflow();
            return false;
        }
        if (places.is_on_way) entry.winding += crossing(solid_, face, start, axis_x, length);
    }
    reserve(0, entry.faces);
    entry.placed_end = placed_words() / PlacedFaces::words;
    return true;
}

// Places a face, or lists it if it has no place. False when there is no room.
bool GridConversion::list_or_place(std::uint32_t face, const FacePlaces& places, Entry& root) {
    const std::uint32_t words = places.count == 0 ? 1 : places.count * PlacedFaces::words;
    if (words > room_ - root.faces) return false;
    if (places.count == 0) {
        scratch_[root.faces++] = face;
        return true;
    }
    // A face of one place is written twice there, so that nothing depends on how many it has.
    PlacedFaces::put(scratch_ + room_ - PlacedFaces::words, places.octants[0], face);
    room_ -= words;
    PlacedFaces::put(scratch_ + room_, places.octants[1], face);
    return true;
}

// Goes on to the next octant of the innermost grid that faces meet. False when there is no room for its list.
bool GridConversion::enter_next(Entry& entry) {
    Frame& above = frames_[grids_ - 1];
    const unsigned m = lowest_of(above.left);
    above.left &= above.left - 1;
    if (!is_of_eight(grids_ - 1)) open_child(above, m >> 3);
    builder_.open(m & 7U);
    const unsigned place = place_of(m);
    const std::uint32_t windings = above.first + 3 * above.faces;
    const PlacedFaces::Range placed = PlacedFaces{scratch_ + room_}.front(
        {above.placed, above.placed_end}, digit_at(levels_below(grids_ - 1), is_of_eight(grids_ - 1)), m);
    above.placed = placed.end;
    entry = Entry{above.corner,
                  windings + winding_words,
                  0,
                  placed.first,
                  placed.end,
                  static_cast<std::int32_t>(scratch_[windings + m])};
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

// Copies the faces that meet an octant to a list of its own. False when there is no room. Mostly few do: so
// some are looked at at once, and if any of them meets it all are written, each over those before that do
// not.
bool GridConversion::select(const Frame& above, unsigned place, Entry& entry) {
    const std::uint32_t* const faces = scratch_ + above.first;
    const std::size_t words_before = (std::size_t{1} + (place >> 5)) * above.faces;
    const std::uint32_t* const halves = faces + words_before;
    const unsigned bit = place & 31U;
    std::uint32_t* const list = scratch_ + entry.first;
    const std::uint32_t room = room_ - entry.first;
    std::uint32_t count = 0;
    for (std::uint32_t first = 0; first < above.faces; first += in_a_look) {
        std::uint32_t any = 0;
        for (std::uint32_t i = 0; i < in_a_look; ++i) any |= halves[first + i];
        if ((any >> bit & 1U) == 0) continue;
        for (std::uint32_t i = first; i < above.faces && i < first + in_a_look; ++i) {
            if (count < room) list[count] = faces[i];
            count += halves[i] >> bit & 1U;
        }
    }
    entry.faces = count;
    return reserve(entry.first, count);
}

// Whether the scratch has so many words behind others; they are then in use.
bool GridConversion::reserve(std::uint32_t first, std::uint32_t words) {
    if (words > room_ - first) return false;
    if (scratch_used_ < first + words) scratch_used_ = first + words;
    return true;
}

void GridConversion::overflow() {
    overflowed_ = true;
    builder_.abandon();
}

// A grid above the last ones. This stands beside visit_last, not above it, so that their stacks do not add
// up.
void GridConversion::visit(const Entry& entry) {
    const int level = level_of(grids_);
    const OctantGrid grid = {entry.corner, lattice_bits - level, offset(), is_of_eight(grids_) ? 1 : 2};
    const GridList list = {solid_, scratch_ + entry.first, entry.faces};
    if (words_above(entry.faces) > room_ - entry.first) return overflow();
    const std::uint32_t words = entry.first + 3 * entry.faces;
    reserve(words, PlacedFaces::words_to_sort);
    const std::uint64_t met_by_placed = PlacedFaces{scratch_ + room_}.sort(
        {entry.placed, entry.placed_end}, digit_at(levels_below(grids_), is_of_eight(grids_)),
        scratch_ + words);
    const std::uint32_t behind = words + winding_words;
    RowWindings windings(scratch_ + behind, room_ - behind, grid.levels, options_.winding);
    OSEM_ASSERT(!windings.overflowed());
    const std::uint64_t met_by_list = list.meet(grid, windings, scratch_ + entry.first + entry.faces,
                                                scratch_ + words); // where winding numbers are to be
    if (windings.overflowed()) return overflow();
    windings.finish(entry.winding);
    reserve(behind, windings.words_used());
    for (std::uint32_t i = 0; i < in_a_look; ++i) scratch_[words + i] = 0; // looked at with the last halves
    const std::uint64_t open = in_morton_order(met_by_list) | met_by_placed;
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
        const unsigned m = lowest_of(left);
        const unsigned place = place_of(m);
        const std::uint32_t row = (place >> 2 & 3U) + ((place >> 4) << grid.levels);
        scratch_[words + m] = static_cast<std::uint32_t>(windings.at(row, place & 3U));
    }
    const std::uint64_t inside = in_morton_order(as_mask(windings.inside(), grid.levels)) & ~open;
    if (is_of_eight(grids_)) {
        builder_.leaves(static_cast<std::uint8_t>(inside), static_cast<std::uint8_t>(inside));
    } else {
        builder_.grandchildren(inside, inside, open);
    }
    if (open == 0) return close();
    frames_[grids_++] =
        Frame{entry.corner, entry.first, entry.faces, entry.placed, entry.placed_end, open, inside, no_child};
}

// A grid whose octants are leaves.
void GridConversion::visit_last(const Entry& entry) {
    const OctantGrid grid = {entry.corner, lattice_bits - options_.depth, offset(), last_levels_};
    const bool three_valued = options_.leaves == LeafRule::conservative;
    const auto rows = static_cast<std::uint32_t>(grid.rows());
    const std::uint32_t list_end = entry.first + entry.faces;
    const std::uint32_t behind = list_end + (three_valued ? rows : 0) + last_grid_space(last_levels_);
    if (!reserve(list_end, behind - list_end)) return overflow();
    std::uint32_t* const met = three_valued ? scratch_ + list_end + last_grid_space(last_levels_) : nullptr;
    if (three_valued) set_zero(met, rows);
    RowWindings windings(scratch_ + behind, room_ - behind, last_levels_, options_.winding);
    if (windings.overflowed()) return overflow();
    const auto meet = [&](std::uint32_t number) {
        std::uint32_t* const space = scratch_ + list_end;
        if (met == nullptr && FaceInGrid::has_added_crossings(solid_, number, grid, windings, space)) return;
        FaceInGrid face(solid_, number, grid);
        if (met != nullptr) face.mark(met, space, windings.spare_words());
        face.add_crossings(windings, space);
    };
    const std::uint32_t* const list = scratch_ + entry.first;
    each_face(
        solid_, 0, entry.faces, [list](std::uint32_t i) { return list[i]; }, meet);
    const PlacedFaces placed = {scratch_ + room_};
    each_face(
        solid_, entry.placed, entry.placed_end, [placed](std::uint32_t i) { return placed.face(i); }, meet);
    if (windings.overflowed()) return overflow();
    windings.finish(entry.winding);
    reserve(behind, windings.words_used());
    GridLeaves{last_levels_, windings.inside(), met, scratch_ + list_end}.set(builder_);
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
