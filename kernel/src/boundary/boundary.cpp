#include "osem/boundary.hpp"

#include "boundary/corner_order.hpp"
#include "boundary/link_cycle.hpp"

namespace osem {

void Boundary::begin(const Octree& tree, SolidPart part, BoundaryCorner* scratch,
                     std::uint32_t scratch_size) {
    tree_ = tree;
    part_ = part;
    corners_ = scratch;
    capacity_ = scratch_size;
    sizes_ = BoundarySizes{};
    double_edges_ = 0;
    emission_ = Status::ok;
    walk_.begin(tree, part);
    enter(Phase::gather);
}

bool Boundary::step(std::uint32_t units) {
    for (; phase_ != Phase::idle && phase_ != Phase::ready; --units) {
        if (units == 0) return true;
        if (!work()) return false;
    }
    return false;
}

// One piece; false when that was the last.
bool Boundary::work() {
    if (piece()) return true;
    enter(successor());
    return phase_ != Phase::ready;
}

// False when the phase has none left.
bool Boundary::piece() {
    if (phase_ < Phase::trace) return phase_ == Phase::gather ? gather() : sort();
    if (phase_ < Phase::ready) return phase_ == Phase::trace ? trace() : nest();
    return phase_ == Phase::vertices ? emit_vertices() : emit_face();
}

Boundary::Phase Boundary::successor() const {
    const bool over = phase_ == Phase::gather     ? !is_storing()
                      : phase_ == Phase::vertices ? emission_ != Status::ok
                                                  : phase_ == Phase::faces;
    return over ? Phase::ready : static_cast<Phase>(static_cast<unsigned>(phase_) + 1U);
}

void Boundary::enter(Phase phase) {
    phase_ = phase;
    position_ = 0;
    if (phase != Phase::sort_out && phase != Phase::sort_in) return;
    position_ = sizes_.corners / 2;
    heap_end_ = sizes_.corners;
}

BoundaryOutcome Boundary::finish() const {
    if (phase_ != Phase::ready) return {Status::unfinished, {}, 0, 0};
    BoundaryOutcome outcome = {emission_, sizes_, 0, double_edges_};
    if (corners_ != nullptr && !is_storing()) {
        outcome.status = Status::scratch_too_small;
        outcome.scratch_missing = boundary_scratch(sizes_.corners) - capacity_;
    }
    return outcome;
}

std::uint64_t Boundary::walked_volume() const {
    return phase_ == Phase::gather || phase_ == Phase::vertices ? walk_.volume() : root_volume;
}

bool Boundary::gather() {
    Octant leaf = root_octant;
    if (!walk_.next(leaf)) return false;
    visit_leaf(leaf);
    return true;
}

bool Boundary::sort() { return CornerOrder(corners_, phase_ == Phase::sort_out).step(position_, heap_end_); }

// Follows one ring that has not been followed yet. It is named after one of its corners, from which the
// ring runs along the plane's second axis where the ring is lowest along the first: there the face lies
// ahead along the first axis if the ring is an outer one, and behind if it is a hole's.
bool Boundary::trace() {
    while (position_ < sizes_.corners &&
           (corners_[position_].role != role_none || corners_[position_].ring != no_corner)) {
        ++position_;
    }
    if (position_ == sizes_.corners) return false;
    const unsigned first_axis = plane_axis(corners_[position_].facing, 0);
    std::uint32_t leader = no_corner;
    std::uint32_t corner = position_;
    do {
        const BoundaryCorner& c = corners_[corner];
        const bool along_second = (c.out & 1U) != 0;
        if (along_second &&
            (leader == no_corner || c.at.at[first_axis] < corners_[leader].at.at[first_axis])) {
            leader = corner;
        }
        corner = c.next;
    } while (corner != position_);
    do {
        corners_[corner].ring = leader;
        corner = corners_[corner].next;
    } while (corner != position_);
    const bool outer = corners_[leader].out == 3;
    corners_[leader].role = outer ? role_outer : role_hole;
    corners_[leader].ring = no_corner;
    ++sizes_.rings;
    if (outer) ++sizes_.faces;
    return true;
}

// Enters one hole into the list of its face. Whatever ring of the face lies beside it, it is either the
// outer one or a hole that is in the list already: that one reaches lower along the plane's first axis, so
// its corner comes before in the order.
bool Boundary::nest() {
    while (position_ < sizes_.corners && corners_[position_].role != role_hole) ++position_;
    if (position_ == sizes_.corners) return false;
    const std::uint32_t beside = edge_beside_hole(corners_, sizes_.corners, position_);
    const std::uint32_t ring = corners_[beside].role != role_none ? beside : corners_[beside].ring;
    corners_[position_].ring = corners_[ring].ring;
    corners_[ring].ring = position_;
    ++position_;
    return true;
}

} // namespace osem
