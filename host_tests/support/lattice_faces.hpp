// All small faces whose corners are among 4 x 4 x 4 points, and what they meet and cross, by clipping and by
// solving for the point of intersection: in integers, with none of the kernel's ideas.
//
// Coordinates count halves of the points' distance, so the points are at 0, 2, 4, 6 along each axis.
#ifndef OSEM_SUPPORT_LATTICE_FACES_HPP
#define OSEM_SUPPORT_LATTICE_FACES_HPP

#include <array>
#include <cstdint>
#include <vector>

namespace osem::tests {

constexpr int lattice_points = 64;
using Halves = std::array<int, 3>;
constexpr Halves lattice_point(int i) { return {2 * (i % 4), 2 * (i / 4 % 4), 2 * (i / 16)}; }

/// Rings of points by their numbers; the first ring is the outer one.
struct LatticeFace {
    std::vector<std::vector<int>> rings;
};

/// Every set of three points once, collinear ones included: 41,664.
std::vector<LatticeFace> lattice_triangles();

/// Every ring of four different points of one plane once, whatever its shape (crossing itself, with a corner
/// within another edge, collinear), up to where it begins and which way it runs.
std::vector<LatticeFace> lattice_quads();

/// Every strictly convex ring of four points with every triangle of points in it that is not flat as a hole,
/// the other way round. The hole may touch the ring.
std::vector<LatticeFace> lattice_quads_with_hole(bool touching);

/// Boxes of one form: an interval of each list, so that the lists stand for all of their combinations.
struct Interval {
    int low;
    int high;
};
using BoxForm = std::array<std::vector<Interval>, 3>;

/// Which open boxes of a form the closed face meets; x varies fastest.
std::vector<bool> boxes_met(const LatticeFace& face, const BoxForm& form);

/// What the face adds to the winding number on the way from one point to `length` further along an axis, both
/// ends moved by (e, e^2, e^3), e = 1 / 1024.
int winding_added(const LatticeFace& face, const Halves& from, int axis, int length);

} // namespace osem::tests

#endif
