#include <algorithm>
#include <string>

#include "mesh/coordinates.hpp"
#include "mesh/quantize.hpp"

namespace osem::host {

namespace {

std::uint32_t uses_of(const IntegerSolid& solid, std::uint32_t from, std::uint32_t to) {
    std::uint32_t uses = 0;
    for (std::uint32_t ring = 0; ring < solid.ring_count(); ++ring) {
        const std::uint32_t end = solid.ring_starts[ring + 1];
        std::uint32_t previous = solid.corners[end - 1];
        for (std::uint32_t corner = solid.ring_starts[ring]; corner < end; ++corner) {
            if (previous == from && solid.corners[corner] == to) ++uses;
            previous = solid.corners[corner];
        }
    }
    return uses;
}

std::string times(std::uint32_t uses) {
    if (uses == 0) return "never";
    return uses == 1 ? "once" : std::to_string(uses) + " times";
}

// What makes an edge of so many uses one way and so many the other.
const char* likely_cause(std::uint32_t most, std::uint32_t least) {
    if (least == 0 && most == 1) return "a gap, a crack or a T-junction";
    if (least == 0 && most % 2 == 0) return "a face is turned over";
    return "a gap, a crack, a T-junction or a face turned over";
}

std::string open_edge(const IntegerSolid& solid, const Edge& edge) {
    const std::uint32_t forward = uses_of(solid, edge.from, edge.to);
    const std::uint32_t backward = uses_of(solid, edge.to, edge.from);
    const std::uint32_t most = std::max(forward, backward);
    const std::uint32_t least = std::min(forward, backward);
    return "surface is not closed: edge " + to_text(solid.file_coordinates[edge.from]) + " - " +
           to_text(solid.file_coordinates[edge.to]) + " is used " + times(most) + " one way and " +
           times(least) + " the other: " + likely_cause(most, least);
}

} // namespace

CheckedSolid check_or_throw(const IntegerSolid& solid) {
    const Solid view = solid.view();
    if (view.face_count == 0) {
        throw BadInput("no face is left on the lattice: the solid is smaller than a cell");
    }
    std::vector<Edge> scratch(check_scratch(view));
    const CheckOutcome outcome = check(view, scratch.data(), static_cast<std::uint32_t>(scratch.size()));
    if (outcome.status == Status::ok) return outcome.solid;
    if (outcome.status == Status::surface_not_closed) throw BadInput(open_edge(solid, outcome.edge));
    throw BadInput(std::string(describe(outcome.status)) + " (face " + std::to_string(outcome.face) + ")");
}

} // namespace osem::host
