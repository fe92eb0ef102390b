#include "boundary/corner_order.hpp"

#include "boundary/link_cycle.hpp"

namespace osem {

namespace {

int compared(std::int32_t a, std::int32_t b) { return a == b ? 0 : a < b ? -1 : 1; }

// By plane side, plane, way, line and place on the line.
int compare_edges(const BoundaryCorner& a, unsigned a_way, const BoundaryCorner& b, unsigned b_way) {
    if (a.facing != b.facing) return a.facing < b.facing ? -1 : 1;
    const int plane = compared(a.at.at[a.facing / 2U], b.at.at[a.facing / 2U]);
    if (plane != 0) return plane;
    if (a_way != b_way) return a_way < b_way ? -1 : 1;
    const unsigned across = plane_axis(a.facing, a_way + 1U);
    const int line = compared(a.at.at[across], b.at.at[across]);
    if (line != 0) return line;
    const unsigned along = plane_axis(a.facing, a_way);
    return compared(a.at.at[along], b.at.at[along]);
}

} // namespace

bool CornerOrder::less(std::uint32_t a, std::uint32_t b) const {
    if (by_out_) return compare_edges(corners_[a], corners_[a].out, corners_[b], corners_[b].out) < 0;
    const BoundaryCorner& of_a = corners_[corners_[a].next];
    const BoundaryCorner& of_b = corners_[corners_[b].next];
    return compare_edges(of_a, of_a.in, of_b, of_b.in) < 0;
}

void CornerOrder::swap(std::uint32_t a, std::uint32_t b) const {
    if (by_out_) {
        const BoundaryCorner moved = corners_[a];
        corners_[a] = corners_[b];
        corners_[b] = moved;
    } else {
        const std::uint32_t moved = corners_[a].next;
        corners_[a].next = corners_[b].next;
        corners_[b].next = moved;
    }
}

void CornerOrder::sift(std::uint32_t root, std::uint32_t end) const {
    while (root < end / 2) { // end / 2 is the first without children
        std::uint32_t child = 2 * root + 1;
        if (child + 1 < end && less(child, child + 1)) ++child;
        if (!less(root, child)) return;
        swap(root, child);
        root = child;
    }
}

bool CornerOrder::step(std::uint32_t& position, std::uint32_t& end) const {
    if (position > 0) {
        sift(--position, end);
        return true;
    }
    if (end < 2) return false;
    swap(0, --end);
    sift(0, end);
    return true;
}

std::uint32_t edge_beside_hole(const BoundaryCorner* corners, std::uint32_t count, std::uint32_t corner) {
    BoundaryCorner line = corners[corner]; // the start of the corner's line, the other way
    line.at.at[plane_axis(line.facing, 1)] = -1;
    std::uint32_t low = 0;
    std::uint32_t high = count;
    while (low < high) {
        const std::uint32_t middle = low + (high - low) / 2;
        const bool before = compare_edges(corners[middle], corners[middle].out, line, 3) < 0;
        before ? low = middle + 1 : high = middle;
    }
    const unsigned second = plane_axis(line.facing, 1);
    const std::int32_t height = corners[corner].at.at[second];
    do {
        --low; // a face reaches up to an edge on every side, so there is one
    } while (corners[low].at.at[second] <= height || corners[corners[low].next].at.at[second] > height);
    return low;
}

} // namespace osem
