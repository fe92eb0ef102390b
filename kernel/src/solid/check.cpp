#include "osem/solid.hpp"

#include "geometry/plane.hpp"

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

bool ring_in_table(const Solid& solid, std::uint32_t ring) {
    if (solid.is_triangle_mesh()) return true;
    return solid.ring_starts[ring] <= solid.ring_starts[ring + 1] &&
           solid.ring_starts[ring + 1] <= solid.corner_count;
}

// Tables, ring lengths and indices, face by face; after it every access through the view is in range.
CheckOutcome check_structure(const Solid& solid) {
    if (solid.is_triangle_mesh() && std::uint64_t{3} * solid.face_count != solid.corner_count) {
        return refusal(Status::ring_table_invalid);
    }
    if (!solid.is_triangle_mesh() && solid.ring_starts == nullptr) return refusal(Status::ring_table_invalid);
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        if (solid.end_ring(face) <= solid.first_ring(face)) {
            return refusal(Status::ring_table_invalid, face, solid.first_ring(face));
        }
        for (std::uint32_t ring = solid.first_ring(face); ring < solid.end_ring(face); ++ring) {
            if (!ring_in_table(solid, ring)) return refusal(Status::ring_table_invalid, face, ring);
            const std::uint32_t first = solid.first_corner(ring);
            const std::uint32_t count = solid.ring(ring).count;
            if (count < 3) return refusal(Status::ring_too_short, face, ring);
            for (std::uint32_t corner = first; corner < first + count; ++corner) {
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

int compare(const Point& a, const Point& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.at[axis] != b.at[axis]) return a.at[axis] < b.at[axis] ? -1 : 1;
    }
    return 0;
}

// Edges ordered by the place they lie at, whichever way they run.
class EdgeOrder {
  public:
    explicit EdgeOrder(const Point* vertices) : vertices_(vertices) {}

    /// 1 when the edge runs from its lower to its higher end, -1 the other way, 0 when it has no length.
    int direction(const Edge& e) const { return -compare(vertices_[e.from], vertices_[e.to]); }

    int operator()(const Edge& a, const Edge& b) const {
        const bool a_up = direction(a) >= 0;
        const bool b_up = direction(b) >= 0;
        const int low = compare(vertices_[a_up ? a.from : a.to], vertices_[b_up ? b.from : b.to]);
        if (low != 0) return low;
        return compare(vertices_[a_up ? a.to : a.from], vertices_[b_up ? b.to : b.from]);
    }

  private:
    const Point* vertices_;
};

// Heapsort: in place, no recursion, O(n log n) at worst.
void sift_down(Edge* edges, std::uint32_t root, std::uint32_t count, const EdgeOrder& order) {
    const Edge sifted = edges[root];
    while (root < count / 2) { // count / 2 is the first without children
        std::uint32_t child = 2 * root + 1;
        if (child + 1 < count && order(edges[child], edges[child + 1]) < 0) ++child;
        if (order(sifted, edges[child]) >= 0) break;
        edges[root] = edges[child];
        root = child;
    }
    edges[root] = sifted;
}

void sort_edges(Edge* edges, std::uint32_t count, const EdgeOrder& order) {
    for (std::uint32_t root = count / 2; root-- > 0;) {
        sift_down(edges, root, count, order);
    }
    for (std::uint32_t end = count; end-- > 1;) {
        const Edge last = edges[end];
        edges[end] = edges[0];
        edges[0] = last;
        sift_down(edges, 0, end, order);
    }
}

std::uint32_t collect_edges(const Solid& solid, Edge* edges) {
    std::uint32_t count = 0;
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
            const Ring ring = solid.ring(r);
            std::uint32_t from = ring.corners[ring.count - 1];
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                edges[count++] = Edge{from, ring.corners[i]};
                from = ring.corners[i];
            }
        }
    }
    return count;
}

// Runs of edges at one place must be used as often one way as the other.
CheckOutcome check_cycle(const Solid& solid, Edge* edges) {
    const std::uint32_t count = collect_edges(solid, edges);
    const EdgeOrder order(solid.vertices);
    sort_edges(edges, count, order);
    for (std::uint32_t first = 0; first < count;) {
        std::int64_t balance = 0;
        std::uint32_t end = first;
        for (; end < count && order(edges[first], edges[end]) == 0; ++end) {
            balance += order.direction(edges[end]);
        }
        if (balance != 0) {
            CheckOutcome outcome = refusal(Status::surface_not_closed);
            const int excess = balance > 0 ? 1 : -1;
            while (order.direction(edges[first]) != excess) {
                ++first;
            }
            outcome.edge = edges[first];
            return outcome;
        }
        first = end;
    }
    return refusal(Status::ok);
}

} // namespace

CheckOutcome check(const Solid& solid, Edge* scratch, std::uint32_t scratch_size) {
    CheckOutcome outcome = check_structure(solid);
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
