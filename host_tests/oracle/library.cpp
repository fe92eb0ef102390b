// The library of test solids, in small coordinates from 0 to 32.
#include <cmath>

#include "solids.hpp"

namespace oracle {

namespace {

using Solids = std::vector<TestSolid>;

void put(Solids& solids, const char* name, TestSolid solid) {
    solid.name = name;
    solids.push_back(std::move(solid));
}

TestSolid joined(std::initializer_list<TestSolid> parts) {
    TestSolid all;
    for (const TestSolid& part : parts) all.add(part);
    return all;
}

TestSolid inverted(TestSolid solid) {
    solid.invert();
    return solid;
}

FlatRing square(int low, int high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

FlatRing reversed(const FlatRing& ring) { return {ring.rbegin(), ring.rend()}; }

// An octahedron whose faces are divided `n` times and whose points are drawn onto a sphere, rounded.
TestSolid sphere(const Grid& grid, std::array<int, 3> centre, int radius, int n) {
    TestSolid solid;
    const osem::Point middle = grid(centre[0], centre[1], centre[2]);
    for (int octant = 0; octant < 8; ++octant) {
        const int sign[3] = {(octant & 1) ? -1 : 1, (octant & 2) ? -1 : 1, (octant & 4) ? -1 : 1};
        const auto point = [&](int i, int j) {
            const int raw[3] = {i, j, n - i - j};
            const double length = std::sqrt(raw[0] * raw[0] + raw[1] * raw[1] + raw[2] * raw[2]);
            osem::Point p = middle;
            for (int k = 0; k < 3; ++k) {
                p.at[k] += static_cast<int>(std::floor(grid.unit * radius * sign[k] * raw[k] / length + 0.5));
            }
            return p;
        };
        const bool turned = sign[0] * sign[1] * sign[2] < 0;
        const auto triangle = [&](const osem::Point& a, const osem::Point& b, const osem::Point& c) {
            solid.add_face(turned ? std::vector<Polygon>{{a, c, b}} : std::vector<Polygon>{{a, b, c}});
        };
        for (int i = 0; i < n; ++i) {
            for (int j = 0; i + j < n; ++j) {
                triangle(point(i, j), point(i + 1, j), point(i, j + 1));
                if (i + j + 1 < n) triangle(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
            }
        }
    }
    return solid;
}

void put_boxes(Solids& all, const Grid& g) {
    put(all, "box", box(g, {4, 8, 2}, {20, 24, 31}));
    put(all, "box inverted", inverted(box(g, {4, 8, 2}, {20, 24, 31})));
    put(all, "box filling the grid", box(g, {0, 0, 0}, {32, 32, 32}));
    put(all, "half of the grid", box(g, {0, 0, 16}, {32, 32, 32}));
    put(all, "one octant", box(g, {8, 16, 24}, {16, 24, 32}));
    put(all, "thin wall", box(g, {5, 3, 3}, {6, 29, 27}));
    put(all, "wall between two octants", box(g, {1, 1, 15}, {31, 31, 17}));
    put(all, "needle box", box(g, {7, 9, 0}, {8, 10, 32}));
    put(all, "cubes sharing a face",
        joined({box(g, {4, 4, 4}, {12, 12, 12}), box(g, {12, 4, 4}, {20, 12, 12})}));
    put(all, "cubes sharing part of a face",
        joined({box(g, {3, 3, 3}, {13, 13, 13}), box(g, {13, 6, 8}, {21, 27, 18})}));
    put(all, "cubes sharing an edge",
        joined({box(g, {4, 4, 4}, {16, 16, 16}), box(g, {16, 16, 4}, {24, 30, 16})}));
    put(all, "cubes sharing a vertex",
        joined({box(g, {4, 4, 4}, {16, 16, 16}), box(g, {16, 16, 16}, {29, 23, 22})}));
    put(all, "nested shells", joined({box(g, {2, 2, 2}, {30, 30, 30}), box(g, {9, 9, 9}, {20, 21, 22})}));
    put(all, "hollow box",
        joined({box(g, {2, 2, 2}, {30, 30, 30}), inverted(box(g, {9, 9, 9}, {20, 21, 22}))}));
    put(all, "cavity touching the shell",
        joined({box(g, {2, 2, 2}, {30, 30, 30}), inverted(box(g, {2, 9, 9}, {20, 21, 22}))}));
    put(all, "overlapping boxes",
        joined({box(g, {2, 2, 2}, {20, 20, 20}), box(g, {10, 12, 5}, {30, 29, 31})}));
    put(all, "box less overlapping box",
        joined({box(g, {2, 2, 2}, {20, 20, 20}), inverted(box(g, {10, 12, 5}, {30, 29, 31}))}));
    put(all, "box twice", joined({box(g, {3, 5, 7}, {22, 24, 26}), box(g, {3, 5, 7}, {22, 24, 26})}));
    put(all, "box and its inverse",
        joined({box(g, {3, 5, 7}, {22, 24, 26}), inverted(box(g, {3, 5, 7}, {22, 24, 26}))}));
}

void put_polyhedra(Solids& all, const Grid& g) {
    put(all, "corner tetrahedron", tetrahedron(g(0, 0, 0), g(32, 0, 0), g(0, 32, 0), g(0, 0, 32)));
    put(all, "inner tetrahedron", tetrahedron(g(32, 32, 0), g(32, 0, 32), g(0, 32, 32), g(0, 0, 0)));
    put(all, "needle tetrahedron", tetrahedron(g(1, 1, 1), g(2, 1, 1), g(1, 2, 2), g(31, 30, 29)));
    put(all, "diagonal needle", tetrahedron(g(0, 0, 0), g(1, 0, 0), g(0, 1, 0), g(32, 32, 32)));
    put(all, "flat tetrahedron", tetrahedron(g(2, 3, 4), g(29, 5, 6), g(12, 28, 17), g(13, 27, 18)));
    put(all, "vertex on an octant's corner",
        tetrahedron(g(16, 16, 16), g(31, 17, 18), g(15, 29, 12), g(20, 21, 30)));
    put(all, "vertex on an octant's edge",
        tetrahedron(g(16, 8, 3), g(29, 10, 5), g(16, 31, 11), g(19, 15, 28)));
    put(all, "tetrahedron of no volume", tetrahedron(g(2, 2, 8), g(30, 2, 8), g(2, 30, 8), g(20, 20, 8)));
    put(all, "sphere", sphere(g, {16, 16, 16}, 13, 4));
    put(all, "sphere filling the grid", sphere(g, {16, 16, 16}, 16, 3));
    put(all, "octahedron", sphere(g, {16, 16, 16}, 16, 1));
    TestSolid ball = joined({sphere(g, {16, 16, 16}, 15, 3), inverted(sphere(g, {17, 15, 16}, 8, 2))});
    put(all, "hollow sphere", std::move(ball));
    TestSolid loose;
    loose.weld = false;
    loose.add(sphere(g, {15, 16, 17}, 11, 2));
    put(all, "sphere without shared vertices", std::move(loose));
}

void put_prisms(Solids& all, const Grid& g) {
    const FlatRing l = {{2, 2}, {28, 2}, {28, 10}, {11, 10}, {11, 30}, {2, 30}};
    const FlatRing u = {{3, 3}, {29, 3}, {29, 27}, {22, 27}, {22, 9}, {10, 9}, {10, 30}, {3, 30}};
    const FlatRing star = {{16, 1},  {19, 12}, {31, 13}, {21, 19}, {26, 31},
                           {16, 23}, {6, 31},  {11, 19}, {1, 13},  {13, 12}};
    put(all, "L prism", prism(g, osem::axis_x, {l}, 5, 26));
    put(all, "U prism", prism(g, osem::axis_y, {u}, 8, 16));
    put(all, "star prism", prism(g, osem::axis_z, {star}, 3, 24));
    put(all, "star prism along x", prism(g, osem::axis_x, {star}, 8, 9));
    const FlatRing pentagram = {{16, 30}, {8, 5}, {29, 20}, {3, 20}, {24, 5}};
    put(all, "pentagram prism", prism(g, osem::axis_z, {pentagram}, 6, 25));
    put(all, "pentagram prism along y", prism(g, osem::axis_y, {pentagram}, 8, 24));
    const FlatRing eight = {{4, 4}, {28, 28}, {28, 4}, {4, 28}}; // encloses as much one way as the other
    put(all, "bow-tie prism", prism(g, osem::axis_x, {eight}, 6, 17));
    const FlatRing twice = {{4, 4}, {24, 4}, {24, 20}, {4, 20}, {4, 4}, {24, 4}, {24, 20}, {4, 20}};
    put(all, "ring run through twice", prism(g, osem::axis_z, {twice}, 4, 13));
    const FlatRing spur = {{4, 4}, {20, 4}, {20, 12}, {30, 17}, {20, 12}, {20, 20}, {4, 20}};
    put(all, "face with a spur", prism(g, osem::axis_y, {spur}, 7, 25));
    const FlatRing straight = {{4, 4}, {12, 4}, {20, 4}, {28, 4}, {28, 28}, {16, 28}, {4, 28}, {4, 16}};
    put(all, "ring with straight corners", prism(g, osem::axis_x, {straight}, 9, 21));
    put(all, "rings that cancel", prism(g, osem::axis_z, {square(4, 27), reversed(square(4, 27))}, 9, 21));
}

void put_plates(Solids& all, const Grid& g) {
    const FlatRing outer = square(1, 31);
    const FlatRing hexagon = reversed({{14, 10}, {20, 12}, {21, 19}, {16, 23}, {9, 20}, {9, 13}});
    const FlatRing notch = reversed({{20, 20}, {29, 22}, {24, 24}, {26, 29}});
    const FlatRing corner_hole = reversed({{1, 1}, {12, 4}, {5, 13}});
    const FlatRing side_hole = reversed({{31, 16}, {22, 20}, {21, 11}});
    put(all, "plate with a square hole", prism(g, osem::axis_z, {outer, reversed(square(8, 16))}, 14, 18));
    put(all, "plate with two holes", prism(g, osem::axis_x, {outer, hexagon, notch}, 7, 10));
    put(all, "hole touching a corner", prism(g, osem::axis_y, {outer, corner_hole}, 11, 20));
    put(all, "hole touching an edge", prism(g, osem::axis_z, {outer, side_hole}, 16, 17));
    const FlatRing left = reversed({{6, 6}, {16, 16}, {6, 26}});
    const FlatRing right = reversed({{26, 6}, {26, 26}, {16, 16}});
    put(all, "hole touching a hole", prism(g, osem::axis_x, {outer, left, right}, 8, 24));
    put(all, "island in a hole",
        prism(g, osem::axis_z, {outer, reversed(square(5, 27)), square(11, 20)}, 8, 23));
    put(all, "hole turned the wrong way", prism(g, osem::axis_z, {outer, square(11, 20)}, 8, 23));

    const FlatRing low = {{3, 4}, {18, 4}, {18, 12}, {3, 12}};
    const FlatRing low_hole = reversed({{6, 6}, {12, 5}, {15, 10}, {8, 11}});
    TestSolid oblique = prism(g, osem::axis_z, {low, low_hole}, 12, 14);
    oblique = sheared(oblique, osem::axis_x, osem::axis_z, 1, -g.origin.x());
    oblique = sheared(oblique, osem::axis_y, osem::axis_z, -1, g.origin.y());
    put(all, "oblique plate with a hole", std::move(oblique));
    const FlatRing small = {{1, 3}, {6, 3}, {6, 11}, {1, 11}};
    const FlatRing small_hole = reversed({{2, 5}, {5, 4}, {4, 10}});
    TestSolid steep = prism(g, osem::axis_z, {small, small_hole}, 1, 2);
    steep = sheared(steep, osem::axis_x, osem::axis_z, 2, -2 * g.origin.x());
    steep = sheared(steep, osem::axis_z, osem::axis_y, 1, -g.origin.z());
    steep = sheared(steep, osem::axis_y, osem::axis_x, 1, -g.origin.y() - g.unit);
    put(all, "steep plate with a hole", std::move(steep));
}

// The top of a box is divided at a point of one edge, and the wall below it is not: a zero-area triangle
// closes the crack.
TestSolid box_with_filler(const Grid& g) {
    const int l = 5;
    const int h = 21;
    TestSolid solid = box(g, {l, l, l}, {h, h, h});
    // The prism's last two faces are top and bottom; the top is made anew.
    const std::size_t top_ring = solid.ring_starts.size() - 3;
    const auto begin = solid.corners.begin() + solid.ring_starts[top_ring];
    solid.corners.erase(begin, begin + 4);
    solid.ring_starts.pop_back();
    solid.face_rings.pop_back();
    const osem::Point a = g(l, l, h), b = g(h, l, h), c = g(h, h, h), d = g(l, h, h), m = g(12, l, h);
    solid.add_face({{a, m, d}});
    solid.add_face({{m, b, c}});
    solid.add_face({{m, c, d}});
    solid.add_face({{a, b, m}});
    return solid;
}

} // namespace

std::vector<TestSolid> library(const Grid& grid) {
    Solids all;
    put_boxes(all, grid);
    put_polyhedra(all, grid);
    put_prisms(all, grid);
    put_plates(all, grid);
    put(all, "zero-area filler", box_with_filler(grid));
    TestSolid specks = box(grid, {10, 3, 5}, {25, 12, 30});
    specks.add_face({{grid(17, 16, 21), grid(17, 16, 21), grid(17, 16, 21)}});
    specks.add_face({{grid(3, 20, 9), grid(28, 27, 13), grid(3, 20, 9)}});
    put(all, "box, loose point and loose segment", std::move(specks));
    return all;
}

} // namespace oracle
