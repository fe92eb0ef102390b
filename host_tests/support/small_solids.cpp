#include "support/small_solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace osem::tests {

void SmallSolid::add_face(const std::vector<Polygon>& rings) {
    for (const Polygon& ring : rings) {
        for (const Point& corner : ring) {
            corners_.push_back(static_cast<std::uint32_t>(vertices_.size()));
            vertices_.push_back(corner);
        }
        ring_starts_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
    face_rings_.push_back(static_cast<std::uint32_t>(ring_starts_.size() - 1));
    faces_.push_back(rings);
}

void SmallSolid::add(const SmallSolid& other) {
    for (const auto& rings : other.faces_) add_face(rings);
}

SmallSolid SmallSolid::shuffled(std::uint32_t seed) const {
    std::mt19937 random(seed);
    std::vector<std::vector<Polygon>> faces = faces_;
    for (std::size_t i = faces.size(); i > 1; --i) std::swap(faces[i - 1], faces[random() % i]);
    SmallSolid solid;
    solid.mesh_ = mesh_;
    for (auto& rings : faces) {
        for (Polygon& ring : rings) {
            const std::size_t turn = random() % ring.size();
            std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(turn), ring.end());
        }
        solid.add_face(rings);
    }
    return solid;
}

SmallSolid SmallSolid::inverted() const {
    SmallSolid solid;
    solid.mesh_ = mesh_;
    for (auto rings : faces_) {
        for (Polygon& ring : rings) std::reverse(ring.begin(), ring.end());
        solid.add_face(rings);
    }
    return solid;
}

SmallSolid SmallSolid::triangulated() const {
    SmallSolid solid;
    solid.mesh_ = true;
    for (const auto& rings : faces_) {
        const Polygon& ring = rings.front();
        for (std::size_t i = 2; i < ring.size(); ++i) solid.add_face({{ring[0], ring[i - 1], ring[i]}});
    }
    return solid;
}

Solid SmallSolid::view() const {
    const auto vertex_count = static_cast<std::uint32_t>(vertices_.size());
    if (mesh_) return triangle_mesh(vertices_.data(), vertex_count, corners_.data(), face_count());
    return Solid{
        vertices_.data(),    vertex_count,       corners_.data(), static_cast<std::uint32_t>(corners_.size()),
        ring_starts_.data(), face_rings_.data(), face_count()};
}

CheckedSolid SmallSolid::checked() const {
    const Solid solid = view();
    std::vector<Edge> scratch(check_scratch(solid));
    const CheckOutcome outcome = check(solid, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
    EXPECT_EQ(outcome.status, Status::ok) << describe(outcome.status);
    return CheckedSolid::vouched(solid);
}

TreeOutcome converted(const SmallSolid& solid, const ConvertOptions& options, NodePool* pool) {
    Conversion job;
    std::vector<std::uint32_t> scratch(solid.face_count());
    return convert(job, solid.checked(), options, scratch.data(), solid.face_count(), pool);
}

SmallSolid box_solid(const Box& box) {
    SmallSolid solid;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const bool is_high : {false, true}) {
            Polygon ring;
            for (const unsigned k : {0U, 1U, 3U, 2U}) { // counter-clockwise as seen from above along the axis
                Point p = is_high ? box.high : box.low;
                p.at[u] = (k & 1U) != 0 ? box.high.at[u] : box.low.at[u];
                p.at[v] = (k & 2U) != 0 ? box.high.at[v] : box.low.at[v];
                ring.push_back(p);
            }
            if (is_high != (box.winding > 0)) std::reverse(ring.begin(), ring.end());
            solid.add_face({ring});
        }
    }
    return solid;
}

SmallSolid boxes_solid(const std::vector<Box>& boxes) {
    SmallSolid solid;
    for (const Box& box : boxes) solid.add(box_solid(box));
    return solid;
}

namespace {

Colour colour_of_winding(WindingRule rule, int winding) {
    const bool inside = rule == WindingRule::nonzero    ? winding != 0
                        : rule == WindingRule::positive ? winding > 0
                                                        : std::abs(winding) % 2 == 1;
    return inside ? Colour::black : Colour::white;
}

} // namespace

Colour box_colour(const std::vector<Box>& boxes, WindingRule rule, const Point& corner, std::int32_t side) {
    int winding = 0;
    for (const Box& box : boxes) {
        bool cell_meets_box = true;
        bool cell_in_box = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t low = corner.at[axis];
            const std::int32_t high = low + side;
            if (high <= box.low.at[axis] || low >= box.high.at[axis]) cell_meets_box = false;
            if (low < box.low.at[axis] || high > box.high.at[axis]) cell_in_box = false;
        }
        if (cell_meets_box && !cell_in_box) return Colour::boundary;
        if (cell_in_box) winding += box.winding;
    }
    return colour_of_winding(rule, winding);
}

Colour box_centre_colour(const std::vector<Box>& boxes, WindingRule rule, const Point& corner,
                         std::int32_t side) {
    int winding = 0;
    for (const Box& box : boxes) {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t middle = corner.at[axis] + side / 2;
            if (middle < box.low.at[axis] || middle >= box.high.at[axis]) inside = false;
        }
        if (inside) winding += box.winding;
    }
    return colour_of_winding(rule, winding);
}

SmallSolid tunnel_solid(const Tunnel& tunnel) {
    Box inner = tunnel.inner;
    inner.low.at[tunnel.axis] = tunnel.outer.low.at[tunnel.axis];
    inner.high.at[tunnel.axis] = tunnel.outer.high.at[tunnel.axis];
    inner.winding = -tunnel.outer.winding;
    const SmallSolid outside = box_solid(tunnel.outer);
    const SmallSolid inside = box_solid(inner);
    SmallSolid solid;
    for (int face = 0; face < 6; ++face) {
        const auto f = static_cast<std::size_t>(face);
        if (face / 2 == tunnel.axis) {
            solid.add_face({outside.faces()[f][0], inside.faces()[f][0]});
        } else {
            solid.add_face(outside.faces()[f]);
            solid.add_face(inside.faces()[f]);
        }
    }
    return solid;
}

namespace {

// The box of the tunnel's hole, without ends along the axis.
Box endless_hole(const Tunnel& tunnel) {
    Box hole = tunnel.inner;
    hole.low.at[tunnel.axis] = -root_side;
    hole.high.at[tunnel.axis] = 2 * root_side;
    hole.winding = 1;
    return hole;
}

} // namespace

Colour tunnel_colour(const Tunnel& tunnel, const Point& corner, std::int32_t side) {
    const Colour outer = box_colour({tunnel.outer}, WindingRule::nonzero, corner, side);
    const Colour hole = box_colour({endless_hole(tunnel)}, WindingRule::nonzero, corner, side);
    if (outer == Colour::white || hole == Colour::black) return Colour::white;
    return outer == Colour::black && hole == Colour::white ? Colour::black : Colour::boundary;
}

Colour tunnel_centre_colour(const Tunnel& tunnel, const Point& corner, std::int32_t side) {
    const Colour outer = box_centre_colour({tunnel.outer}, WindingRule::nonzero, corner, side);
    const Colour hole = box_centre_colour({endless_hole(tunnel)}, WindingRule::nonzero, corner, side);
    return outer == Colour::black && hole == Colour::white ? Colour::black : Colour::white;
}

SmallSolid octahedron_solid(const Octahedron& octahedron) {
    SmallSolid solid;
    for (unsigned octant = 0; octant < 8; ++octant) {
        Polygon ring;
        for (unsigned axis = 0; axis < 3; ++axis) {
            Point tip = octahedron.centre;
            tip.at[axis] += ((octant >> axis) & 1U) != 0 ? octahedron.radius : -octahedron.radius;
            ring.push_back(tip);
        }
        const bool is_mirrored = octant == 0 || octant == 3 || octant == 5 || octant == 6;
        if (is_mirrored) std::reverse(ring.begin(), ring.end());
        solid.add_face({ring});
    }
    return solid;
}

namespace {

// A cell's distances from a centre, those along the given axes added up.
struct Distances {
    std::int64_t nearest = 0;
    std::int64_t farthest = 0;

    Distances(const Point& centre, const Point& corner, std::int32_t side, const std::vector<int>& axes) {
        for (const int axis : axes) {
            const std::int64_t low = std::int64_t{corner.at[axis]} - centre.at[axis];
            const std::int64_t high = low + side;
            nearest += low > 0 ? low : high < 0 ? -high : 0;
            farthest += std::max(std::abs(low), std::abs(high));
        }
    }
};

// Whether the centre of a cell is nearer than the radius. If it is on the surface it is moved off it by the
// greatest of its moves that is not along the surface: that along the first axis.
bool centre_is_near(const Point& centre, std::int32_t radius, const Point& corner, std::int32_t side,
                    const std::vector<int>& axes) {
    std::int64_t distance = 0;
    for (const int axis : axes) {
        distance += std::abs(std::int64_t{corner.at[axis]} + side / 2 - centre.at[axis]);
    }
    if (distance != radius) return distance < radius;
    return corner.at[axes[0]] + side / 2 < centre.at[axes[0]];
}

std::vector<int> axes_across(int axis) {
    if (axis == 0) return {1, 2};
    return axis == 1 ? std::vector<int>{0, 2} : std::vector<int>{0, 1};
}

} // namespace

// The cell meets the solid when the cell's nearest point is nearer than the radius (the distance is least at
// a side of the cell, which is not part of it, unless it is 0), and lies in it when the farthest is not
// farther.
Colour octahedron_colour(const Octahedron& octahedron, const Point& corner, std::int32_t side) {
    const Distances d(octahedron.centre, corner, side, {0, 1, 2});
    if (d.farthest <= octahedron.radius) return Colour::black;
    return d.nearest < octahedron.radius ? Colour::boundary : Colour::white;
}

Colour octahedron_centre_colour(const Octahedron& octahedron, const Point& corner, std::int32_t side) {
    const bool inside = centre_is_near(octahedron.centre, octahedron.radius, corner, side, {0, 1, 2});
    return inside ? Colour::black : Colour::white;
}

SmallSolid diamond_solid(const Diamond& diamond) {
    const int u = (diamond.axis + 1) % 3;
    const int v = (diamond.axis + 2) % 3;
    const auto corner = [&](unsigned k, std::int32_t along) { // counter-clockwise as seen along the axis
        Point p = diamond.centre;
        p.at[diamond.axis] = along;
        p.at[k % 2 == 0 ? u : v] += k % 4 < 2 ? diamond.radius : -diamond.radius;
        return p;
    };
    SmallSolid solid;
    Polygon top;
    Polygon bottom;
    for (unsigned k = 0; k < 4; ++k) {
        top.push_back(corner(k, diamond.high));
        bottom.push_back(corner(3 - k, diamond.low));
        solid.add_face({{corner(k, diamond.low), corner(k + 1, diamond.low), corner(k + 1, diamond.high),
                         corner(k, diamond.high)}});
    }
    solid.add_face({top});
    solid.add_face({bottom});
    return solid;
}

Colour diamond_colour(const Diamond& diamond, const Point& corner, std::int32_t side) {
    const Distances d(diamond.centre, corner, side, axes_across(diamond.axis));
    const std::int32_t low = corner.at[diamond.axis];
    const std::int32_t high = low + side;
    const bool within = diamond.low <= low && high <= diamond.high;
    const bool beside = high <= diamond.low || diamond.high <= low;
    if (d.farthest <= diamond.radius && within) return Colour::black;
    return d.nearest < diamond.radius && !beside ? Colour::boundary : Colour::white;
}

Colour diamond_centre_colour(const Diamond& diamond, const Point& corner, std::int32_t side) {
    const std::int32_t along = corner.at[diamond.axis] + side / 2;
    const bool near = centre_is_near(diamond.centre, diamond.radius, corner, side, axes_across(diamond.axis));
    return near && diamond.low <= along && along < diamond.high ? Colour::black : Colour::white;
}

SmallSolid dented_ball(int edge, std::int32_t rounded_to) {
    const auto corner = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        const auto hash = static_cast<std::uint32_t>(x * 7919 + y * 104729 + z * 1299709);
        const auto dent = static_cast<std::int32_t>((hash * 2654435761U) >> 19); // below 2^13
        Point point = {{x, y, z}};
        for (std::int32_t& at : point.at) {
            at = root_side / 2 + at * (400000 / edge) - at * dent / edge;
            at = at / rounded_to * rounded_to;
        }
        return point;
    };
    SmallSolid solid;
    for (int octant = 0; octant < 8; ++octant) {
        const auto at = [&](int i, int j) {
            const int k = edge - i - j;
            return corner((octant & 1) == 0 ? i : -i, (octant & 2) == 0 ? j : -j, (octant & 4) == 0 ? k : -k);
        };
        const bool turned = ((octant ^ octant >> 1 ^ octant >> 2) & 1) != 0;
        const auto add = [&](const Point& a, const Point& b, const Point& c) {
            solid.add_face({turned ? Polygon{a, c, b} : Polygon{a, b, c}});
        };
        for (int i = 0; i < edge; ++i) {
            for (int j = 0; i + j < edge; ++j) {
                add(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < edge) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
        }
    }
    return solid;
}

} // namespace osem::tests
