// Every triangle of the 3 x 3 x 3 lattice against every octant of side 1 in it, by clipping in fractions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "osem/classify.hpp"
#include "support/small_solids.hpp"

namespace osem::tests {

namespace {

// A fraction in lowest terms with a positive denominator.
struct Fraction {
    std::int64_t top;
    std::int64_t bottom;
};

Fraction reduced(std::int64_t top, std::int64_t bottom) {
    const std::int64_t common = std::gcd(top, bottom) * (bottom < 0 ? -1 : 1);
    return {top / common, bottom / common};
}
Fraction operator+(Fraction a, Fraction b) {
    return reduced(a.top * b.bottom + b.top * a.bottom, a.bottom * b.bottom);
}
Fraction operator-(Fraction a, Fraction b) { return a + Fraction{-b.top, b.bottom}; }
Fraction operator*(Fraction a, Fraction b) { return reduced(a.top * b.top, a.bottom * b.bottom); }
Fraction operator/(Fraction a, Fraction b) { return reduced(a.top * b.bottom, a.bottom * b.top); }
int sign(Fraction a) { return a.top < 0 ? -1 : a.top > 0 ? 1 : 0; }

using Corner = std::array<Fraction, 3>;
using Corners = std::vector<Corner>;

// How far a point is inside one of the six closed half-spaces of the unit cube at `low`.
Fraction depth_inside(const Corner& p, const std::array<int, 3>& low, int side) {
    const auto axis = static_cast<std::size_t>(side / 2);
    const Fraction from_low = p[axis] - Fraction{low[axis], 1};
    return side % 2 == 0 ? from_low : Fraction{1, 1} - from_low;
}

// Sutherland and Hodgman: the part of a convex polygon in a half-space, degenerate ones included.
Corners clipped(const Corners& polygon, const std::array<int, 3>& low, int side) {
    Corners kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& a = polygon[i];
        const Corner& b = polygon[(i + 1) % polygon.size()];
        const Fraction at_a = depth_inside(a, low, side);
        const Fraction at_b = depth_inside(b, low, side);
        if (sign(at_a) >= 0) kept.push_back(a);
        if (sign(at_a) * sign(at_b) >= 0) continue;
        const Fraction t = at_a / (at_a - at_b);
        Corner cut = a;
        for (std::size_t axis = 0; axis < 3; ++axis) cut[axis] = a[axis] + t * (b[axis] - a[axis]);
        kept.push_back(cut);
    }
    return kept;
}

// The part in the closed cube is convex: it has a point in the open cube exactly if, for each side, it has
// one off that side, for then the mean of its corners is off all of them.
bool meets_open_cube(Corners polygon, const std::array<int, 3>& low) {
    for (int side = 0; side < 6; ++side) polygon = clipped(polygon, low, side);
    if (polygon.empty()) return false;
    for (int side = 0; side < 6; ++side) {
        const bool is_off = std::any_of(polygon.begin(), polygon.end(), [&](const Corner& p) {
            return sign(depth_inside(p, low, side)) > 0;
        });
        if (!is_off) return false;
    }
    return true;
}

std::array<int, 3> lattice_point(int i) { return {i % 3, i / 3 % 3, i / 9}; }

void expect_triangle(const std::array<int, 3>& indices, const Octant& base) {
    Corners exact;
    Polygon ring;
    for (const int i : indices) {
        const std::array<int, 3> p = lattice_point(i);
        exact.push_back({Fraction{p[0], 1}, Fraction{p[1], 1}, Fraction{p[2], 1}});
        Point placed = base.corner;
        for (int axis = 0; axis < 3; ++axis) {
            placed.at[axis] += p[static_cast<std::size_t>(axis)] * (base.side() / 2);
        }
        ring.push_back(placed);
    }
    SmallSolid face;
    face.add_face({ring});
    const CheckedSolid solid = face.vouched();
    for (unsigned k = 0; k < 8; ++k) {
        const std::array<int, 3> low = {static_cast<int>(k & 1U), static_cast<int>((k >> 1) & 1U),
                                        static_cast<int>(k >> 2)};
        ASSERT_EQ(classify(solid, 0, base.child(k)).meets, meets_open_cube(exact, low))
            << indices[0] << " " << indices[1] << " " << indices[2] << ", octant " << k;
    }
}

void expect_all_triangles(const Octant& base) {
    int count = 0;
    for (int a = 0; a < 27; ++a) {
        for (int b = a + 1; b < 27; ++b) {
            for (int c = b + 1; c < 27; ++c, ++count) {
                // Each triangle in one of the six orders of its corners.
                std::array<int, 3> order = {a, b, c};
                for (int i = 0; i < count % 6; ++i) std::next_permutation(order.begin(), order.end());
                expect_triangle(order, base);
            }
        }
    }
    EXPECT_EQ(count, 2925);
}

TEST(ClassifyLattice, AllTrianglesAtTheGreatestScale) { expect_all_triangles(root_octant); }

TEST(ClassifyLattice, AllTrianglesAtTheLeastScale) {
    expect_all_triangles(Octant{{{root_side - 2, 0, root_side / 2}}, 19});
}

// Corners off the octant, too: triangles of a 5 x 5 x 5 lattice around an octant in its middle.
TEST(ClassifyLattice, TrianglesAroundAnOctant) {
    const Octant octant = {{{2 * 4096, 6 * 4096, 10 * 4096}}, 8};
    ASSERT_EQ(octant.side(), 4096);
    std::uint32_t state = 12345;
    const auto next = [&state] {
        state = state * 1664525U + 1013904223U;
        return static_cast<int>((state >> 16) % 5) - 2;
    };
    for (int trial = 0; trial < 20000; ++trial) {
        Corners exact;
        Polygon ring;
        for (int i = 0; i < 3; ++i) {
            const std::array<int, 3> p = {next(), next(), next()};
            exact.push_back({Fraction{p[0], 1}, Fraction{p[1], 1}, Fraction{p[2], 1}});
            ring.push_back({{octant.corner.x() + p[0] * 4096, octant.corner.y() + p[1] * 4096,
                             octant.corner.z() + p[2] * 4096}});
        }
        SmallSolid face;
        face.add_face({ring});
        ASSERT_EQ(classify(face.vouched(), 0, octant).meets, meets_open_cube(exact, {0, 0, 0}))
            << "trial " << trial;
    }
}

} // namespace

} // namespace osem::tests
