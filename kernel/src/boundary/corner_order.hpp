// Corners of a surface in the order that tells which one follows which.
#ifndef OSEM_BOUNDARY_CORNER_ORDER_HPP
#define OSEM_BOUNDARY_CORNER_ORDER_HPP

#include <cstdint>

#include "osem/boundary.hpp"

namespace osem {

constexpr std::uint32_t no_corner = UINT32_MAX;

/// What a corner stands for. Any other corner names that of its ring.
enum CornerRole : std::uint8_t { role_none, role_outer, role_hole };

/// The edges of one plane side that run one way along one line follow each other; their starts and their
/// ends, each in order, belong together one by one. So with the corners sorted by the edges out of them
/// (`position` names a corner) and `next` by the edges into them, corner i is followed by corner next[i].
class CornerOrder {
  public:
    /// by_out: orders the corners themselves. Otherwise: orders their members `next`, indices of corners.
    CornerOrder(BoundaryCorner* corners, bool by_out) : corners_(corners), by_out_(by_out) {}

    /// Heap sort, a step at a time. Start: position = count / 2, end = count. False when sorted.
    bool step(std::uint32_t& position, std::uint32_t& end) const;

  private:
    bool less(std::uint32_t a, std::uint32_t b) const;
    void swap(std::uint32_t a, std::uint32_t b) const;
    void sift(std::uint32_t root, std::uint32_t end) const;

    BoundaryCorner* corners_;
    bool by_out_;
};

/// The corner whose edge bounds the same face and is the first to be met when going against the plane's
/// first axis from the middle of the edge out of `corner`, which is one of a hole that runs along the second
/// axis. `count` corners, sorted by the edges out of them.
std::uint32_t edge_beside_hole(const BoundaryCorner* corners, std::uint32_t count, std::uint32_t corner);

} // namespace osem

#endif
