// The symmetries of the cube as a group, and as maps of points.
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "osem/symmetry.hpp"

namespace osem::tests {

namespace {

constexpr Symmetry turned = {{1, 0, 2}, 1}; // a quarter turn about z: x is -y, y is x
static_assert(turned.is_rotation() && turned * turned * turned * turned == Symmetry::identity(), "order 4");
static_assert(turned * turned == Symmetry{{0, 1, 2}, 3}, "half a turn reverses x and y");
static_assert(turned.inverse() == turned * turned * turned, "back is three times on");

bool same_maps(const Symmetry& a, const Symmetry& b) {
    const Point p = {{1, 2, 5}}; // far from every plane of symmetry
    return a.point(p) == b.point(p);
}

TEST(Symmetries, AreFortyEightMapsEachOnce) {
    std::set<std::vector<std::int32_t>> images;
    unsigned rotations = 0;
    for (unsigned n = 0; n < 48; ++n) {
        const Symmetry s = Symmetry::nth(n);
        ASSERT_TRUE(s.is_valid());
        const Point image = s.point(Point{{1, 2, 5}});
        images.insert({image.x(), image.y(), image.z()});
        rotations += s.is_rotation() ? 1U : 0U;
    }
    EXPECT_EQ(images.size(), 48U);
    EXPECT_EQ(rotations, 24U);
    EXPECT_EQ(Symmetry::nth(0), Symmetry::identity());
}

// The determinant of the map's linear part, from the images of three corners beside the origin.
int determinant(const Symmetry& s) {
    const Point origin = s.point(Point{{0, 0, 0}});
    int m[3][3] = {};
    for (int column = 0; column < 3; ++column) {
        Point corner = {{0, 0, 0}};
        corner.at[column] = root_side;
        const Point image = s.point(corner);
        for (int row = 0; row < 3; ++row) m[row][column] = (image.at[row] - origin.at[row]) / root_side;
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(Symmetries, RotationsHaveDeterminantOne) {
    for (unsigned n = 0; n < 48; ++n) {
        EXPECT_EQ(determinant(Symmetry::nth(n)), Symmetry::nth(n).is_rotation() ? 1 : -1) << n;
    }
}

TEST(Symmetries, AreAGroup) {
    const Point p = {{7, 100, 3000}};
    for (unsigned i = 0; i < 48; ++i) {
        const Symmetry a = Symmetry::nth(i);
        EXPECT_EQ(a * a.inverse(), Symmetry::identity());
        EXPECT_EQ(a.inverse() * a, Symmetry::identity());
        EXPECT_EQ(a * Symmetry::identity(), a);
        EXPECT_EQ(Symmetry::identity() * a, a);
        for (unsigned j = 0; j < 48; ++j) {
            const Symmetry b = Symmetry::nth(j);
            ASSERT_TRUE((a * b).is_valid());
            ASSERT_EQ((a * b).point(p), a.point(b.point(p)));
            ASSERT_EQ((a * b).cell(p), a.cell(b.cell(p)));
            ASSERT_EQ((a * b).inverse(), b.inverse() * a.inverse());
            ASSERT_EQ(a == b, same_maps(a, b));
            ASSERT_EQ(a != b, !same_maps(a, b));
        }
    }
}

TEST(Symmetries, ChildrenGoWhereTheirCellsGo) {
    for (unsigned n = 0; n < 48; ++n) {
        const Symmetry s = Symmetry::nth(n);
        for (unsigned k = 0; k < 8; ++k) {
            const Point image = s.cell(root_octant.child(k).corner);
            const Point low = root_octant.child(s.child(k)).corner;
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(image.at[axis], low.at[axis]);
                EXPECT_LT(image.at[axis], low.at[axis] + root_side / 2);
            }
        }
    }
}

TEST(Symmetries, WhatIsNoPermutationIsNotValid) {
    EXPECT_FALSE((Symmetry{{0, 0, 2}, 0}).is_valid());
    EXPECT_FALSE((Symmetry{{0, 1, 1}, 0}).is_valid());
    EXPECT_FALSE((Symmetry{{2, 1, 2}, 0}).is_valid());
    EXPECT_FALSE((Symmetry{{3, 0, 1}, 0}).is_valid());
    EXPECT_FALSE((Symmetry{{0, 3, 1}, 0}).is_valid());
    EXPECT_FALSE((Symmetry{{0, 1, 3}, 0}).is_valid());
    EXPECT_FALSE((Symmetry{{0, 1, 2}, 8}).is_valid());
}

TEST(Symmetries, DifferInAnyMember) {
    const Symmetry s = {{0, 1, 2}, 5};
    EXPECT_TRUE(s == (Symmetry{{0, 1, 2}, 5}));
    for (const Symmetry& other :
         {Symmetry{{1, 1, 2}, 5}, Symmetry{{0, 2, 2}, 5}, Symmetry{{0, 1, 0}, 5}, Symmetry{{0, 1, 2}, 4}}) {
        EXPECT_TRUE(s != other);
        EXPECT_FALSE(s == other);
    }
}

} // namespace

} // namespace osem::tests
