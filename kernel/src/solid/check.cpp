#include "osem/solid.hpp"

#include "geometry/plane.hpp"
#include "solid/edge_sort.hpp"
#include "solid/edge_table.hpp"

namespace osem {

namespace {

CheckOutcome refusal(Status status) { return {status, 0, 0, 0, 0, {0, 0}, CheckedSolid::vouched(Solid{})}; }

CheckOutcome refusal(Status status, std::uint32_t face, std::uint32_t ring) {
    CheckOutcome outcome = refusal(status);
    outcome.face = face;
    outcome.ring = ring;
    return outcome;
}

CheckOutcome refusal(const Solid& solid, Status status, std::uint32_t face, std::uint32_t ring,
                     std::uint32_t corner) {
    CheckOutcome outcome = refusal(status, face, ring);
    outcome.corner = corner;
    outcome.vertex = solid.corners[corner];
    return outcome;
}

// The tables, from the outside in, so that nothing is read through an entry not yet checked.
CheckOutcome check_tables(const Solid& solid) {
    if (solid.is_triangle_mesh()) {
        const bool fits =
            std::uint64_t{3} * solid.face_count == solid.corner_count && solid.ring_starts == nullptr;
        return refusal(fits ? Status::ok : Status::ring_table_invalid);
    }
    if (solid.ring_starts == nullptr) return refusal(Status::ring_table_invalid);
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        if (solid.end_ring(face) <= solid.first_ring(face)) {
            return refusal(Status::ring_table_invalid, face, solid.first_ring(face));
        }
    }
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t ring = solid.first_ring(face); ring < solid.end_ring(face); ++ring) {
            const std::uint32_t end = solid.first_corner(ring + 1);
            if (solid.first_corner(ring) > end || end > solid.corner_count) {
                return refusal(Status::ring_table_invalid, face, ring);
            }
        }
    }
    return refusal(Status::ok);
}

// Ring lengths and vertex indices, face by face. After it every access through the view is in range.
CheckOutcome check_rings(const Solid& solid) {
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t ring = solid.first_ring(face); ring < solid.end_ring(face); ++ring) {
            if (solid.ring(ring).count < 3) return refusal(Status::ring_too_short, face, ring);
            for (std::uint32_t corner = solid.first_corner(ring); corner < solid.first_corner(ring + 1);
                 ++corner) {
                if (solid.corners[corner] >= solid.vertex_count) {
                    return refusal(solid, Status::index_out_of_range, face, ring, corner);
                }
            }
        }
    }
    return refusal(Status::ok);
}

CheckOutcome check_coordinates(const Solid& solid) {
    for (std::uint32_t vertex = 0; vertex < solid.vertex_count; ++vertex) {
        for (const std::int32_t coordinate : solid.vertices[vertex].at) {
            if (coordinate < 0 || coordinate > root_side) {
                CheckOutcome outcome = refusal(Status::coordinate_off_lattice);
                outcome.vertex = vertex;
                return outcome;
            }
        }
    }
    return refusal(Status::ok);
}

CheckOutcome check_planarity(const Solid& solid) {
    if (solid.is_triangle_mesh()) return refusal(Status::ok);
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        const Plane plane(solid, face);
        for (std::uint32_t ring = solid.first_ring(face); ring < solid.end_ring(face); ++ring) {
            for (std::uint32_t corner = solid.first_corner(ring); corner < solid.first_corner(ring + 1);
                 ++corner) {
                if (plane.at(solid.vertices[solid.corners[corner]]).value() != 0) {
                    return refusal(solid, Status::face_not_planar, face, ring, corner);
                }
            }
        }
    }
    return refusal(Status::ok);
}

// Tells all edges until it is not taken; whether all were.
template <class Take>
bool each_edge(const Solid& solid, Take take) {
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
            const Ring ring = solid.ring(r);
            std::uint32_t from = ring.corners[ring.count - 1];
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                if (!take(Edge{from, ring.corners[i]})) return false;
                from = ring.corners[i];
            }
        }
    }
    return true;
}

// Writes edges but for pairs that run against each other, or mere edges where there is no room to wait for
// those; how many.
std::uint32_t collect_edges(const Solid& solid, Edge* edges) {
    EdgeTable table(edges, check_scratch(solid));
    if (each_edge(solid, [&table](const Edge& edge) { return table.take(edge); })) return table.gather();
    std::uint32_t count = 0;
    each_edge(solid, [edges, &count](const Edge& edge) {
        edges[count++] = edge;
        return true;
    });
    return count;
}

// Sorts edges and drops, from every run at one place, those that run against another. What is left is the
// surplus of each place, one way; says how many edges that is.
std::uint32_t cancel_edges(Edge* edges, std::uint32_t count, const EdgeOrder& order) {
    sort_edges(edges, count, order);
    std::uint32_t left = 0;
    for (std::uint32_t first = 0; first < count;) {
        const Edge run = edges[first];
        Edge up = run; // some edge of the run each way, where there is one
        Edge down = run;
        std::int64_t balance = 0;
        for (; first < count && order(run, edges[first]) == 0; ++first) {
            const int direction = order.direction(edges[first]);
            (direction > 0 ? up : down) = edges[first];
            balance += direction;
        }
        for (; balance != 0; balance += balance > 0 ? -1 : 1) {
            edges[left++] = balance > 0 ? up : down;
        }
    }
    return left;
}

// First by vertex index, which leaves nothing of a welded closed surface; what is left by place.
CheckOutcome check_cycle(const Solid& solid, Edge* edges) {
    std::uint32_t count = collect_edges(solid, edges);
    count = cancel_edges(edges, count, EdgeOrder(nullptr));
    count = cancel_edges(edges, count, EdgeOrder(solid.vertices));
    CheckOutcome outcome = refusal(count == 0 ? Status::ok : Status::surface_not_closed);
    if (count != 0) outcome.edge = edges[0];
    return outcome;
}

} // namespace

CheckOutcome check(const Solid& solid, Edge* scratch, std::uint32_t scratch_size) {
    CheckOutcome outcome = check_tables(solid);
    if (outcome.status == Status::ok) outcome = check_rings(solid);
    if (outcome.status == Status::ok) outcome = check_coordinates(solid);
    if (outcome.status == Status::ok) outcome = check_planarity(solid);
    if (outcome.status == Status::ok && scratch_size < check_scratch(solid)) {
        outcome.status = Status::scratch_too_small;
    }
    if (outcome.status == Status::ok) outcome = check_cycle(solid, scratch);
    if (outcome.status == Status::ok) outcome.solid = CheckedSolid::vouched(solid);
    return outcome;
}

} // namespace osem
