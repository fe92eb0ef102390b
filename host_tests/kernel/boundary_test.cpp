// The surface of an octree's solid against the cells themselves.
#include "osem/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

#include "osem/convert.hpp"
#include "support/heap_pool.hpp"
#include "support/surface.hpp"
#include "support/surface_sheets.hpp"

namespace osem::tests {

namespace {

constexpr SolidPart both_parts[] = {SolidPart::inner, SolidPart::outer};

CheckedSolid checked(const Solid& solid) {
    std::vector<Edge> scratch(check_scratch(solid));
    const CheckOutcome outcome = check(solid, scratch.data(), check_scratch(solid));
    EXPECT_EQ(outcome.status, Status::ok) << describe(outcome.status);
    return outcome.solid;
}

// Conversion of the surface at the tree's depth gives the solid's tree back.
bool converts_back(const Solid& surface, const DenseGrid& solid) {
    static Conversion job;
    HeapPool pool(5000);
    std::vector<std::uint32_t> faces(convert_scratch(surface));
    ConvertOptions options;
    options.depth = solid.depth();
    const TreeOutcome back =
        convert(job, checked(surface), options, faces.data(), convert_scratch(surface), &*pool);
    return back.status == Status::ok && expand(back.tree, solid.depth()) == solid;
}

// A face is a disk with holes, which has the Euler characteristic 2 - rings; every edge has two corners.
std::int64_t euler_characteristic(const Solid& s) {
    return std::int64_t{s.vertex_count} - s.corner_count / 2 + 2 * std::int64_t{s.face_count} -
           s.ring_count();
}

void expect_right_surface(const DenseGrid& grid, SolidPart part) {
    static Boundary job;
    HeapPool pool(5000);
    const Surface surface(job, planted(grid, *pool), part);
    const DenseGrid solid = solid_cells(grid, part);
    const BoundarySizes& sizes = surface.built().sizes;
    ASSERT_EQ(surface.counted().status, Status::ok);
    ASSERT_EQ(surface.built().status, Status::ok);
    EXPECT_EQ(surface.counted().sizes.vertices, sizes.vertices);
    EXPECT_EQ(surface.counted().sizes.corners, sizes.corners);
    EXPECT_EQ(surface.view().vertex_count, sizes.vertices);
    EXPECT_EQ(surface.view().corner_count, sizes.corners);
    EXPECT_EQ(surface.view().ring_count(), sizes.rings);
    EXPECT_EQ(surface.view().face_count, sizes.faces);
    EXPECT_EQ(surface.built().double_edges, 0U);
    const std::set<UnitFaces> expected = expected_faces(solid);
    EXPECT_EQ(expected.size(), sizes.faces);
    EXPECT_TRUE(covered_faces(surface.view(), grid.depth()) == expected);
    EXPECT_TRUE(is_manifold(surface.view(), solid));
    EXPECT_EQ(six_volumes(surface.view(), grid.cell_side()),
              static_cast<std::int64_t>(6 * solid.volume(Colour::black) / volume_at(grid.depth())));
    EXPECT_EQ(euler_characteristic(surface.view()), count_sheets(solid).euler);
    EXPECT_TRUE(converts_back(surface.view(), solid));
}

TEST(Boundary, EveryTwoByTwoByTwoGrid) {
    for (unsigned mask = 0; mask < 256; ++mask) {
        DenseGrid grid(1);
        for (unsigned cell = 0; cell < 8; ++cell) {
            grid[cell] = ((mask >> cell) & 1U) != 0 ? Colour::black : Colour::white;
        }
        expect_right_surface(grid, SolidPart::inner);
        if (HasFailure()) FAIL() << "mask " << mask;
    }
}

TEST(Boundary, RandomBlocks) {
    for (std::uint32_t seed = 0; seed < 80; ++seed) {
        for (const SolidPart part : both_parts) expect_right_surface(grid_of(seed), part);
        if (HasFailure()) FAIL() << "seed " << seed;
    }
}

// Cell by cell at every density: all that touches in edges and corners only.
TEST(Boundary, RandomCells) {
    std::mt19937 random(61);
    for (std::uint32_t round = 0; round < 120; ++round) {
        DenseGrid grid(round % 3 == 0 ? 2 : 3);
        const auto density = 1 + random() % 15;
        for (std::size_t cell = 0; cell < grid.size(); ++cell) {
            grid[cell] = random() % 16 < density ? Colour::black : Colour::white;
        }
        expect_right_surface(grid, SolidPart::inner);
        if (HasFailure()) FAIL() << "round " << round;
    }
}

// Holes in holes: square rings around each other on the floor, all of one face's sides at one height.
TEST(Boundary, FacesWithHoles) {
    const auto ring_of = [](int x, int y) {
        return std::max(std::abs(2 * x - 15), std::abs(2 * y - 15)) / 2;
    };
    const DenseGrid grid = make_grid(4, [&ring_of](const Point& p, std::int32_t side) {
        const int z = p.z() / side;
        const bool standing = ring_of(p.x() / side, p.y() / side) % 2 == 0;
        return z < 4 || (z < 6 && standing) ? Colour::black : Colour::white;
    });
    expect_right_surface(grid, SolidPart::inner);
    static Boundary job;
    HeapPool pool(5000);
    const Surface surface(job, planted(grid, *pool), SolidPart::inner);
    EXPECT_GT(surface.built().sizes.rings, surface.built().sizes.faces);
}

TEST(Boundary, UniformTrees) {
    static Boundary job;
    HeapPool pool(0);
    const Surface cube(job, Octree::uniform(*pool, Colour::black), SolidPart::inner);
    EXPECT_EQ(cube.view().vertex_count, 8U);
    EXPECT_EQ(cube.view().corner_count, 24U);
    EXPECT_EQ(cube.view().face_count, 6U);
    EXPECT_EQ(six_volumes(cube.view(), root_side), 6);
    const Surface outer(job, Octree::uniform(*pool, Colour::boundary), SolidPart::outer);
    EXPECT_EQ(outer.view().face_count, 6U);
    for (const Colour colour : {Colour::white, Colour::boundary}) {
        const Surface none(job, Octree::uniform(*pool, colour), SolidPart::inner);
        EXPECT_EQ(none.built().status, Status::ok);
        EXPECT_EQ(none.view().face_count, 0U);
        EXPECT_EQ(none.view().vertex_count, 0U);
    }
}

// One leaf of side 1 at the end of every kind of path.
TEST(Boundary, ALeafAtFullDepth) {
    static Boundary job;
    for (unsigned k = 0; k < 8; ++k) {
        Octant leaf = root_octant;
        HeapPool pool(max_depth);
        TreeBuilder builder;
        builder.begin(&*pool);
        for (int level = 1; level <= max_depth; ++level) {
            const unsigned child = level % 5 == 0 ? 7U - k : k;
            level < max_depth ? builder.open(child) : builder.leaf(child, Colour::black);
            leaf = leaf.child(child);
        }
        for (int level = 0; level < max_depth; ++level) builder.close();
        const Surface surface(job, builder.finish(max_depth).tree, SolidPart::inner);
        ASSERT_EQ(surface.view().vertex_count, 8U);
        ASSERT_EQ(surface.view().face_count, 6U);
        EXPECT_EQ(checked(surface.view()).view().corner_count, 24U);
        unsigned seen = 0;
        for (std::uint32_t v = 0; v < 8; ++v) {
            unsigned corner = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const std::int32_t off = surface.view().vertices[v].at[axis] - leaf.corner.at[axis];
                ASSERT_TRUE(off == 0 || off == 1);
                corner |= static_cast<unsigned>(off) << axis;
            }
            seen |= 1U << corner;
        }
        EXPECT_EQ(seen, 0xffU);
    }
}

// The tree of full depth whose last octant in the root's first corner is a grid of depth 2 of cells of
// side 1.
Octree in_a_corner(const DenseGrid& grid, NodePool& pool) {
    TreeBuilder builder;
    builder.begin(&pool);
    for (int level = 0; level < max_depth - 2; ++level) builder.open(0);
    for (unsigned octant = 0; octant < 8; ++octant) {
        builder.open(octant);
        for (unsigned k = 0; k < 8; ++k) builder.leaf(k, grid[8 * octant + k]);
        builder.close();
    }
    for (int level = 0; level <= max_depth - 2; ++level) builder.close();
    return builder.finish(max_depth).tree;
}

// Slabs joined by two columns that share an edge: both of its copies run from one vertex to one other. At
// side 2 each gets a vertex within; at side 1 there is no lattice point for it, and the outcome says so.
TEST(Boundary, AnEdgeThatJoinsTheSameVerticesTwice) {
    DenseGrid grid(2);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        const Point p = grid.corner(cell);
        const std::int32_t side = grid.cell_side();
        const int x = p.x() / side;
        const int y = p.y() / side;
        const int z = p.z() / side;
        const bool column = z == 1 && ((x == 1 && y == 1) || (x == 2 && y == 2));
        grid[cell] = (z == 0 || z == 2 || column) ? Colour::black : Colour::white;
    }
    expect_right_surface(grid, SolidPart::inner);

    HeapPool pool(100);
    for (const int lower : {17, 18}) {
        TreeBuilder builder;
        builder.begin(&*pool);
        for (int level = 0; level < lower; ++level) builder.open(0);
        for (unsigned octant = 0; octant < 8; ++octant) {
            builder.open(octant);
            for (unsigned k = 0; k < 8; ++k) builder.leaf(k, grid[8 * octant + k]);
            builder.close();
        }
        for (int level = 0; level <= lower; ++level) builder.close();
        static Boundary job;
        const Surface surface(job, builder.finish(lower + 2).tree, SolidPart::inner);
        EXPECT_EQ(checked(surface.view()).view().face_count, surface.built().sizes.faces);
        EXPECT_EQ(surface.built().double_edges, lower == 18 ? 1U : 0U);
    }
}

// Edges that are used more than once in one direction, by vertex indices.
std::uint32_t repeated_edges(const Solid& s) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::uint32_t repeated = 0;
    for (std::uint32_t r = 0; r < s.ring_count(); ++r) {
        const Ring ring = s.ring(r);
        for (std::uint32_t i = 0; i < ring.count; ++i) {
            repeated += edges.insert({ring.corners[i], ring.corners[(i + 1) % ring.count]}).second ? 0U : 1U;
        }
    }
    return repeated;
}

// Edges of cells, along an axis, around which two cells that touch in it alone are black, and which do not go
// on so behind their end: those that can be of length 1 and cut.
std::uint32_t ends_of_cut_edges(const DenseGrid& grid) {
    const int cells = 1 << grid.depth();
    std::uint32_t ends = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // Which of the two diagonals is black around the edge from place (i, j, k) along the axis.
        const auto diagonal = [&](int i, int j, int k) {
            const auto black = [&](int dj, int dk) {
                const int at[3] = {i, j - dj, k - dk};
                Point p = {};
                for (int n = 0; n < 3; ++n) {
                    if (at[n] < 0 || at[n] >= cells) return false;
                    p.at[(axis + n) % 3] = at[n] * grid.cell_side();
                }
                return grid.at(p) == Colour::black;
            };
            const int set =
                (black(0, 0) ? 1 : 0) + (black(1, 1) ? 2 : 0) + (black(0, 1) ? 4 : 0) + (black(1, 0) ? 8 : 0);
            return set == 3 ? 1 : set == 12 ? 2 : 0;
        };
        for (int i = 0; i < cells; ++i) {
            for (int j = 1; j < cells; ++j) {
                for (int k = 1; k < cells; ++k) {
                    const int cut = diagonal(i, j, k);
                    ends += cut != 0 && cut != diagonal(i + 1, j, k) ? 1U : 0U;
                }
            }
        }
    }
    return ends;
}

// Cells of side 1, where no edge of a cell has a lattice point within. Looked at from so near that a cell is
// as large as those of a grid of depth 2, the surface is right; and where the outcome does not warn of edges
// that join the same vertices, or there are none after all, it is a manifold by its vertices.
TEST(Boundary, RandomCellsOfSideOne) {
    static Boundary job;
    std::mt19937 random(67);
    std::uint32_t double_edges = 0;
    for (std::uint32_t round = 0; round < 300; ++round) {
        SCOPED_TRACE(round);
        DenseGrid grid(2);
        for (std::size_t cell = 0; cell < grid.size(); ++cell) {
            grid[cell] = random() % 16 < 4 + round % 8 ? Colour::black : Colour::white;
        }
        HeapPool pool(100);
        const Octree tree = in_a_corner(grid, *pool);
        const Surface surface(job, tree, SolidPart::inner);
        std::vector<Point> vertices(surface.view().vertices,
                                    surface.view().vertices + surface.view().vertex_count);
        for (Point& vertex : vertices) {
            for (std::int32_t& coordinate : vertex.at) coordinate *= grid.cell_side();
        }
        Solid enlarged = surface.view();
        enlarged.vertices = vertices.data();
        EXPECT_TRUE(covered_faces(enlarged, grid.depth()) == expected_faces(grid));
        EXPECT_EQ(six_volumes(enlarged, grid.cell_side()),
                  static_cast<std::int64_t>(6 * grid.volume(Colour::black) / volume_at(grid.depth())));
        const std::uint32_t repeated = repeated_edges(enlarged);
        EXPECT_LE(repeated, 2 * surface.built().double_edges);
        EXPECT_LE(surface.built().double_edges, ends_of_cut_edges(grid));
        EXPECT_TRUE(repeated != 0 || is_manifold(enlarged, grid));
        double_edges += surface.built().double_edges;
    }
    EXPECT_GT(double_edges, 0U);
}

} // namespace

} // namespace osem::tests
