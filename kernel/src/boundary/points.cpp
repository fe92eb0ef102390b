// From the leaves to the vertices and corners of the surface.
#include "boundary/corner_order.hpp"
#include "boundary/link_cycle.hpp"
#include "osem/boundary.hpp"
#include "tree/counts.hpp"
#include "tree/masks.hpp"

namespace osem {

namespace {

// The minimum corner of cell `cell` of the eight around a point.
Point cell_at(const Point& at, unsigned cell) {
    Point p = at;
    for (unsigned axis = 0; axis < 3; ++axis) p.at[axis] -= ((cell >> axis) & 1U) != 0 ? 0 : 1;
    return p;
}

bool is_corner(const Point& at, std::int32_t side) {
    return ((at.at[0] | at.at[1] | at.at[2]) & (side - 1)) == 0;
}

} // namespace

// Every vertex is a corner of a solid leaf: where all solid leaves at a point reach beyond it, the least of
// them does so along an axis along which all others do too, so that the surface is straight there. A point
// is looked at from the first of the leaves that have it as a corner.
void Boundary::visit_leaf(const Octant& leaf) {
    for (unsigned k = 0; k < 8; ++k) {
        Point at = leaf.corner;
        for (unsigned axis = 0; axis < 3; ++axis) at.at[axis] += ((k >> axis) & 1U) != 0 ? leaf.side() : 0;
        const unsigned own = 7U - k;
        unsigned solid = 1U << own;
        bool first = true;
        for (unsigned cell = 0; cell < 8 && first; ++cell) {
            if (cell == own) continue;
            const std::int32_t side = walk_.solid_side(cell_at(at, cell));
            if (side == 0) continue;
            solid |= 1U << cell;
            first = cell > own || !is_corner(at, side);
        }
        if (first) visit_point(at, static_cast<std::uint8_t>(solid));
    }
}

// A sheet that is flat or has one straight edge at the point has no vertex there.
void Boundary::visit_point(const Point& at, std::uint8_t solid) {
    std::uint32_t seen = 0;
    for (std::uint8_t normal = 0; normal < 3; ++normal) {
        for (std::uint8_t cell = 0; cell < 8; ++cell) {
            const Quad quad = {cell, normal};
            const bool on_surface = contains(solid, cell) && !contains(solid, cell ^ (1U << normal));
            if (!on_surface || contains(seen, quad.number())) continue;
            const LinkCycle cycle = link_cycle(solid, quad);
            for (unsigned i = 0; i < cycle.count; ++i) seen |= std::uint32_t{1} << cycle.quads[i].number();
            if (cycle.crease_count() > 2) take_cycle(at, cycle);
        }
    }
}

void Boundary::take_cycle(const Point& at, const LinkCycle& cycle) {
    add_vertex(at);
    for (unsigned i = 0; i < cycle.count; ++i) {
        if (!cycle.has_crease(i)) continue;
        const Quad& first = cycle.quads[cycle.after(i)];
        const Quad& last = cycle.quads[cycle.next_crease(i)];
        add_corner(at, first.facing(), (last.last_way() + 2U) & 3U, first.first_way());
    }
    unsigned directions = 0;
    for (unsigned i = 0; i < cycle.count; ++i) {
        if (!cycle.has_crease(i)) continue;
        const unsigned direction = cycle.direction(i);
        if ((direction & 1U) != 0 && contains(directions, direction)) divide_edge(at, cycle, i);
        directions |= 1U << direction;
    }
}

// Both copies of a cut edge start at this vertex; so that they do not end at one vertex too, the one behind
// quad `crease` gets a vertex one unit on, if the edge goes on from there.
void Boundary::divide_edge(const Point& at, const LinkCycle& cycle, unsigned crease) {
    const unsigned axis = cycle.direction(crease) / 2U;
    const Quad& quad = cycle.quads[crease];
    const Quad& next = cycle.quads[cycle.after(crease)];
    Point middle = at;
    ++middle.at[axis];
    if (!is_cut(middle, axis, quad.cell)) {
        if (phase_ == Phase::gather) ++double_edges_;
        return;
    }
    add_vertex(middle);
    const unsigned back = (quad.last_way() + 2U) & 3U;
    add_corner(middle, quad.facing(), back, back);
    add_corner(middle, next.facing(), next.first_way(), next.first_way());
}

// Whether a cut edge leaves a point along an axis, `cell` and the cell across the edge being solid.
bool Boundary::is_cut(const Point& at, unsigned axis, unsigned cell) const {
    const unsigned one = 1U << axis_after(axis);
    const unsigned other = 1U << axis_after(axis_after(axis));
    const auto solid = [this, &at](unsigned c) { return walk_.solid_side(cell_at(at, c)) != 0; };
    return solid(cell) && solid(cell ^ one ^ other) && !solid(cell ^ one) && !solid(cell ^ other);
}

void Boundary::add_vertex(const Point& at) {
    if (phase_ == Phase::gather) {
        ++sizes_.vertices;
    } else if (emission_ == Status::ok && !sink_.vertex(sink_.context, at)) {
        emission_ = Status::sink_refused;
    }
}

void Boundary::add_corner(const Point& at, std::uint8_t facing, unsigned in, unsigned out) {
    if (phase_ != Phase::gather) return;
    const std::uint32_t index = sizes_.corners;
    sizes_.corners = counted(index, 1);
    if (!is_storing()) return;
    corners_[index] = BoundaryCorner{at,
                                     sizes_.vertices - 1,
                                     index,
                                     no_corner,
                                     facing,
                                     static_cast<std::uint8_t>(in),
                                     static_cast<std::uint8_t>(out),
                                     role_none};
}

} // namespace osem
