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

std::string open_edge(const IntegerSolid& solid, const Edge& edge) {
    return "surface is not closed: edge " + to_text(solid.file_coordinates[edge.from]) + " - " +
           to_text(solid.file_coordinates[edge.to]) + " is used " +
           std::to_string(uses_of(solid, edge.from, edge.to)) + " time(s) one way and " +
           std::to_string(uses_of(solid, edge.to, edge.from)) +
           " the other; so a gap, a crack, a T-junction or a face turned over shows";
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
