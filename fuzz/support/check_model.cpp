#include "support/check_model.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "support/exact.hpp"

namespace osem::fuzz {

namespace {

bool tables_are_valid(const Solid& solid) {
    if (solid.face_rings == nullptr) {
        return solid.ring_starts == nullptr && std::uint64_t{3} * solid.face_count == solid.corner_count;
    }
    if (solid.ring_starts == nullptr) return false;
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        if (solid.face_rings[face] >= solid.face_rings[face + 1]) return false;
    }
    if (solid.face_count == 0) return true;
    for (std::uint32_t r = solid.face_rings[0]; r < solid.face_rings[solid.face_count]; ++r) {
        if (solid.ring_starts[r] > solid.ring_starts[r + 1]) return false;
        if (solid.ring_starts[r + 1] > solid.corner_count) return false;
    }
    return true;
}

// The first ring at fault, face by face: too short, or with a corner that names no vertex.
Status status_of_rings(const Solid& solid) {
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
            const Ring ring = solid.ring(r);
            if (ring.count < 3) return Status::ring_too_short;
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                if (ring.corners[i] >= solid.vertex_count) return Status::index_out_of_range;
            }
        }
    }
    return Status::ok;
}

using Place = std::array<std::int32_t, 3>;
Place place_of(const Point& p) { return {p.x(), p.y(), p.z()}; }

// Directed edges by the places of their ends: uses less those of the opposite.
using Balance = std::map<std::pair<Place, Place>, std::int64_t>;

Balance balance_of(const Solid& solid) {
    Balance balance;
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        for (std::uint32_t r = solid.first_ring(face); r < solid.end_ring(face); ++r) {
            const Ring ring = solid.ring(r);
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                const Place a = place_of(solid.vertices[ring.corners[i]]);
                const Place b = place_of(solid.vertices[ring.corners[(i + 1) % ring.count]]);
                ++balance[{a, b}];
                --balance[{b, a}];
            }
        }
    }
    return balance;
}

Status expected_status(const Solid& solid) {
    if (!tables_are_valid(solid)) return Status::ring_table_invalid;
    if (const Status status = status_of_rings(solid); status != Status::ok) return status;
    for (std::uint32_t v = 0; v < solid.vertex_count; ++v) {
        for (const std::int32_t at : solid.vertices[v].at) {
            if (at < 0 || at > root_side) return Status::coordinate_off_lattice;
        }
    }
    for (std::uint32_t face = 0; face < solid.face_count; ++face) {
        if (!ExactFace(solid, face).is_planar()) return Status::face_not_planar;
    }
    for (const auto& entry : balance_of(solid)) {
        if (entry.second != 0) return Status::surface_not_closed;
    }
    return Status::ok;
}

// What the refusal names must be at fault.
void expect_place(const Solid& solid, const CheckOutcome& outcome) {
    switch (outcome.status) {
    case Status::ring_too_short:
        EXPECT_LT(solid.ring(outcome.ring).count, 3U);
        break;
    case Status::index_out_of_range:
        EXPECT_EQ(solid.corners[outcome.corner], outcome.vertex);
        EXPECT_GE(outcome.vertex, solid.vertex_count);
        break;
    case Status::coordinate_off_lattice: {
        const Point& p = solid.vertices[outcome.vertex];
        EXPECT_TRUE(p.x() < 0 || p.y() < 0 || p.z() < 0 || p.x() > root_side || p.y() > root_side ||
                    p.z() > root_side);
        break;
    }
    case Status::face_not_planar:
        EXPECT_FALSE(ExactFace(solid, outcome.face).is_planar());
        EXPECT_EQ(solid.corners[outcome.corner], outcome.vertex);
        EXPECT_NE(ExactFace(solid, outcome.face).side(scaled(solid.vertices[outcome.vertex])), 0);
        break;
    case Status::surface_not_closed:
        EXPECT_GT(balance_of(solid).at({place_of(solid.vertices[outcome.edge.from]),
                                        place_of(solid.vertices[outcome.edge.to])}),
                  0);
        break;
    default:
        break;
    }
    if (outcome.status == Status::ring_too_short || outcome.status == Status::index_out_of_range ||
        outcome.status == Status::face_not_planar) {
        EXPECT_GE(outcome.ring, solid.first_ring(outcome.face));
        EXPECT_LT(outcome.ring, solid.end_ring(outcome.face));
    }
}

} // namespace

CheckOutcome checked_as_expected(const Solid& solid) {
    std::vector<Edge> scratch(check_scratch(solid));
    const Status expected = expected_status(solid);
    const CheckOutcome outcome = check(solid, scratch.data(), check_scratch(solid));
    EXPECT_EQ(outcome.status, expected) << describe(outcome.status) << ", not " << describe(expected);
    expect_place(solid, outcome);

    const bool about_edges = expected == Status::ok || expected == Status::surface_not_closed;
    if (about_edges && solid.corner_count > 0) {
        EXPECT_EQ(check(solid, scratch.data(), check_scratch(solid) - 1).status, Status::scratch_too_small);
    } else {
        EXPECT_EQ(check(solid, nullptr, 0).status, expected);
    }
    return outcome;
}

} // namespace osem::fuzz
