#include "boundary/link_cycle.hpp"

#include "tree/masks.hpp"

namespace osem {

namespace {

struct Step {
    Quad quad;
    bool turns;
};

Quad quad_of(unsigned cell, unsigned normal) {
    return Quad{static_cast<std::uint8_t>(cell), static_cast<std::uint8_t>(normal)};
}

// Over the last edge of a square: around the solid cell, straight on, or up the cell in the way.
Step successor(std::uint8_t solid, Quad quad) {
    const unsigned along = plane_axis(quad.facing(), quad.last_way());
    const unsigned across = 3U - quad.normal - along;
    const unsigned beside = quad.cell ^ (1U << across);
    if (!contains(solid, beside)) return {quad_of(quad.cell, across), true};
    const unsigned above = beside ^ (1U << quad.normal);
    if (!contains(solid, above)) return {quad_of(beside, quad.normal), false};
    return {quad_of(above, across), true};
}

} // namespace

unsigned Quad::first_way() const {
    const unsigned u = bit(plane_axis(facing(), 0));
    const unsigned v = bit(plane_axis(facing(), 1));
    return v != 0 ? 1U - u : 2U + u;
}

unsigned LinkCycle::next_crease(unsigned i) const {
    do {
        i = after(i);
    } while (!has_crease(i));
    return i;
}

unsigned LinkCycle::crease_count() const {
    unsigned found = 0;
    for (unsigned i = 0; i < count; ++i) found += has_crease(i) ? 1U : 0U;
    return found;
}

unsigned LinkCycle::direction(unsigned i) const {
    const unsigned way = quads[i].last_way();
    return 2U * plane_axis(quads[i].facing(), way) + (way < 2U ? 1U : 0U);
}

LinkCycle link_cycle(std::uint8_t solid, Quad first) {
    LinkCycle cycle = {};
    Quad quad = first;
    do {
        const Step step = successor(solid, quad);
        if (step.turns) cycle.creases = static_cast<std::uint16_t>(cycle.creases | (1U << cycle.count));
        cycle.quads[cycle.count++] = quad;
        quad = step.quad;
    } while (quad.number() != first.number());
    return cycle;
}

} // namespace osem
