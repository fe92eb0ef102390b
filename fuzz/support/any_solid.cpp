#include "support/any_solid.hpp"

#include <algorithm>

#include "support/near_face.hpp"

namespace osem::fuzz {

namespace {

using tests::Polygon;
using tests::SmallSolid;

// On the grid of sixteenths of the window, one off it, or anywhere in the window.
Point window_point(const Octant& window, Choices& choices) {
    Point p = window.corner;
    for (std::int32_t& at : p.at) {
        const std::uint8_t kind = choices.byte();
        const std::int32_t on_grid = window.side() / 16 * (kind % 17);
        if (kind < 136) {
            at += on_grid;
        } else if (kind < 187) {
            at += std::clamp(on_grid + (kind % 2 == 0 ? 1 : -1), 0, window.side());
        } else {
            at += choices.between(0, window.side());
        }
    }
    return p;
}

SmallSolid any_box(const Octant& window, Choices& choices) {
    const Point a = window_point(window, choices);
    const Point b = window_point(window, choices);
    tests::Box box = {a, b, choices.flag() ? 1 : -1};
    for (int axis = 0; axis < 3; ++axis) {
        box.low.at[axis] = std::min(a.at[axis], b.at[axis]);
        box.high.at[axis] = std::max(a.at[axis], b.at[axis]);
    }
    return box_solid(box);
}

SmallSolid tetrahedron(const Octant& window, Choices& choices) {
    const Point p[4] = {window_point(window, choices), window_point(window, choices),
                        window_point(window, choices), window_point(window, choices)};
    SmallSolid solid;
    solid.add_face({{p[0], p[2], p[1]}});
    solid.add_face({{p[0], p[1], p[3]}});
    solid.add_face({{p[1], p[2], p[3]}});
    solid.add_face({{p[2], p[0], p[3]}});
    return solid;
}

// Two points joined to one ring, which need not be planar.
SmallSolid double_cone(const Octant& window, Choices& choices) {
    const Point tips[2] = {window_point(window, choices), window_point(window, choices)};
    Polygon ring;
    for (std::uint32_t n = 3 + choices.below(5); n > 0; --n) ring.push_back(window_point(window, choices));
    SmallSolid solid;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& next = ring[(i + 1) % ring.size()];
        solid.add_face({{ring[i], next, tips[0]}});
        solid.add_face({{next, ring[i], tips[1]}});
    }
    return solid;
}

// Rings in a plane across an axis, and the same moved by a vector: the walls between are parallelograms.
SmallSolid prism(const Octant& window, Choices& choices) {
    const int axis = static_cast<int>(choices.below(3));
    const Point base = window_point(window, choices);
    const Point to = window_point(window, choices);
    Point by = {};
    for (int i = 0; i < 3; ++i) by.at[i] = i == axis || choices.below(4) == 0 ? to.at[i] - base.at[i] : 0;
    const auto moved = [&](Point p) {
        for (int i = 0; i < 3; ++i) p.at[i] += by.at[i];
        return p;
    };
    std::vector<Polygon> low(1 + choices.below(3));
    for (Polygon& ring : low) {
        for (std::uint32_t n = 3 + choices.below(6); n > 0; --n) {
            Point p = window_point(window, choices);
            p.at[axis] = base.at[axis];
            for (int i = 0; i < 3; ++i) { // where the other end would leave the lattice
                if (moved(p).at[i] < 0 || moved(p).at[i] > root_side) p.at[i] = base.at[i];
            }
            ring.push_back(p);
        }
    }
    SmallSolid solid;
    std::vector<Polygon> high;
    for (Polygon& ring : low) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point& next = ring[(i + 1) % ring.size()];
            solid.add_face({{ring[i], moved(ring[i]), moved(next), next}});
        }
        high.emplace_back();
        for (const Point& p : ring) high.back().insert(high.back().begin(), moved(p));
    }
    solid.add_face(low);
    solid.add_face(high);
    return solid;
}

// A face and the same one seen from behind: a wall without thickness.
SmallSolid sheet(const Octant& window, Choices& choices) {
    SmallSolid solid = near_face(window, choices);
    solid.add(solid.inverted());
    return solid;
}

SmallSolid any_shape(const Octant& window, Choices& choices) {
    switch (choices.below(8)) {
    case 0:
    case 1:
        return any_box(window, choices);
    case 2:
    case 3:
        return prism(window, choices);
    case 4:
        return double_cone(window, choices);
    case 5:
        return sheet(window, choices);
    default:
        return tetrahedron(window, choices);
    }
}

// Face `changed` left out, or turned over.
void change_face(SolidArrays& arrays, std::uint32_t changed, bool turned) {
    if (!arrays.has_rings || !arrays.has_starts || changed >= arrays.face_count) return;
    SolidArrays result = {arrays.vertices, {}, {0}, {0}, 0};
    const Solid view = arrays.view();
    for (std::uint32_t face = 0; face < view.face_count; ++face) {
        if (face == changed && !turned) continue;
        for (std::uint32_t r = view.first_ring(face); r < view.end_ring(face); ++r) {
            const Ring ring = view.ring(r);
            std::vector<std::uint32_t> corners(ring.corners, ring.corners + ring.count);
            if (face == changed) std::reverse(corners.begin(), corners.end());
            result.corners.insert(result.corners.end(), corners.begin(), corners.end());
            result.ring_starts.push_back(static_cast<std::uint32_t>(result.corners.size()));
        }
        result.face_rings.push_back(static_cast<std::uint32_t>(result.ring_starts.size() - 1));
        ++result.face_count;
    }
    arrays = result;
}

// Entries that a table may name must be there: so it is as long as its last entry says.
void change_tables(SolidArrays& arrays, Choices& choices) {
    const std::uint32_t value = choices.below(80);
    const auto change = [&](std::vector<std::uint32_t>& table) {
        if (!table.empty()) table[choices.below(static_cast<std::uint32_t>(table.size()))] = value;
    };
    switch (choices.below(6)) {
    case 0:
        arrays.has_starts = false;
        break;
    case 1:
        arrays.has_rings = false;
        break;
    case 2:
        change(arrays.face_rings);
        if (!arrays.face_rings.empty()) arrays.ring_starts.resize(arrays.face_rings.back() + 1, value);
        break;
    default:
        change(arrays.ring_starts);
    }
}

} // namespace

Solid SolidArrays::view() const {
    const auto vertex_count = static_cast<std::uint32_t>(vertices.size());
    if (!has_starts && !has_rings && corners.size() == std::size_t{3} * face_count) {
        return triangle_mesh(vertices.data(), vertex_count, corners.data(), face_count);
    }
    return {vertices.data(),
            vertex_count,
            corners.data(),
            static_cast<std::uint32_t>(corners.size()),
            has_starts ? ring_starts.data() : nullptr,
            has_rings ? face_rings.data() : nullptr,
            face_count};
}

SolidArrays arrays_of(const SmallSolid& solid, bool welded) {
    SolidArrays arrays = {{}, {}, {0}, {0}, solid.face_count()};
    for (const auto& rings : solid.faces()) {
        for (const Polygon& ring : rings) {
            for (const Point& p : ring) {
                auto at = welded ? std::find(arrays.vertices.begin(), arrays.vertices.end(), p)
                                 : arrays.vertices.end();
                if (at == arrays.vertices.end()) at = arrays.vertices.insert(at, p);
                arrays.corners.push_back(static_cast<std::uint32_t>(at - arrays.vertices.begin()));
            }
            arrays.ring_starts.push_back(static_cast<std::uint32_t>(arrays.corners.size()));
        }
        arrays.face_rings.push_back(static_cast<std::uint32_t>(arrays.ring_starts.size() - 1));
    }
    return arrays;
}

SolidArrays as_mesh(const SolidArrays& arrays) {
    SolidArrays mesh = arrays;
    mesh.has_starts = false;
    mesh.has_rings = false;
    return mesh;
}

Octant any_window(Choices& choices) {
    const std::uint32_t kind = choices.below(32);
    Octant window = {{{0, 0, 0}}, static_cast<std::uint8_t>(kind < 16 ? 0 : kind - 15)};
    for (std::int32_t& at : window.corner.at)
        at = choices.between(0, (1 << window.level) - 1) * window.side();
    return window;
}

SmallSolid any_solid(const Octant& window, Choices& choices) {
    SmallSolid solid = any_shape(window, choices);
    for (std::uint32_t more = choices.below(4); more > 0; --more) solid.add(any_shape(window, choices));
    if (choices.below(8) == 0) solid = solid.inverted();
    return solid;
}

void damage(SolidArrays& arrays, Choices& choices) {
    for (std::uint32_t changes = choices.below(4); changes > 0; --changes) {
        const auto vertices = static_cast<std::uint32_t>(arrays.vertices.size());
        const auto corners = static_cast<std::uint32_t>(arrays.corners.size());
        switch (choices.below(6)) {
        case 0:
            change_face(arrays, choices.below(arrays.face_count + 1), false);
            break;
        case 1:
            change_face(arrays, choices.below(arrays.face_count + 1), true);
            break;
        case 2:
            if (corners > 0) arrays.corners[choices.below(corners)] = choices.below(vertices + 2);
            break;
        case 3:
            if (vertices > 0) {
                arrays.vertices[choices.below(vertices)].at[choices.below(3)] += choices.between(-2, 2);
            }
            break;
        case 4:
            if (vertices > 0) {
                arrays.vertices[choices.below(vertices)].at[choices.below(3)] =
                    static_cast<std::int32_t>(choices.word());
            }
            break;
        default:
            change_tables(arrays, choices);
            return; // the tables may be none that the other changes could follow
        }
    }
}

} // namespace osem::fuzz
