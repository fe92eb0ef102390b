// What check refuses and where: a good solid of quadrangles and triangles, spoilt in one place at a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "osem/solid.hpp"

namespace osem::tests {

namespace {

// A wedge: five planar faces on six vertices. The arrays have exactly the stated length.
struct Wedge {
    std::vector<Point> vertices = {{{100, 100, 100}}, {{900, 100, 100}}, {{900, 900, 100}},
                                   {{100, 900, 100}}, {{100, 100, 600}}, {{100, 900, 600}}};
    std::vector<std::uint32_t> corners = {0, 3, 2, 1, 0, 1, 4, 1, 2, 5, 4, 2, 3, 5, 0, 4, 5, 3};
    std::vector<std::uint32_t> ring_starts = {0, 4, 7, 11, 14, 18};
    std::vector<std::uint32_t> face_rings = {0, 1, 2, 3, 4, 5};

    std::vector<std::uint32_t>::iterator first_of(std::uint32_t ring) {
        return corners.begin() + static_cast<std::ptrdiff_t>(ring_starts[ring]);
    }
    Solid view() const {
        return {vertices.data(),
                static_cast<std::uint32_t>(vertices.size()),
                corners.data(),
                static_cast<std::uint32_t>(corners.size()),
                ring_starts.data(),
                face_rings.data(),
                static_cast<std::uint32_t>(face_rings.size() - 1)};
    }
    std::uint32_t ring_of(std::uint32_t corner) const {
        std::uint32_t ring = 0;
        while (ring_starts[ring + 1] <= corner) ++ring;
        return ring;
    }
    CheckOutcome checked() const {
        std::vector<Edge> scratch(check_scratch(view()));
        return check(view(), scratch.data(), check_scratch(view()));
    }
};

TEST(Check, TakesAGoodSolid) {
    const Wedge wedge;
    const CheckOutcome outcome = wedge.checked();
    EXPECT_EQ(outcome.status, Status::ok);
    EXPECT_EQ(outcome.solid.view().corners, wedge.corners.data());
    EXPECT_EQ(outcome.solid.view().face_count, 5U);
}

TEST(Check, NamesTheCornerWithAnIndexPastTheVertices) {
    for (std::uint32_t corner = 0; corner < 18; ++corner) {
        for (const std::uint32_t index : {6U, UINT32_MAX}) {
            Wedge wedge;
            wedge.corners[corner] = index;
            const CheckOutcome outcome = wedge.checked();
            ASSERT_EQ(outcome.status, Status::index_out_of_range);
            ASSERT_EQ(outcome.face, wedge.ring_of(corner));
            ASSERT_EQ(outcome.ring, wedge.ring_of(corner));
            ASSERT_EQ(outcome.corner, corner);
            ASSERT_EQ(outcome.vertex, index);
        }
    }
}

TEST(Check, NamesTheVertexOffTheLattice) {
    for (std::uint32_t vertex = 0; vertex < 6; ++vertex) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            for (const std::int32_t value : {INT32_MIN, -1, 0, root_side, root_side + 1, INT32_MAX}) {
                Wedge wedge;
                wedge.vertices[vertex].at[axis] = value;
                const CheckOutcome outcome = wedge.checked();
                const bool off = value < 0 || value > root_side;
                ASSERT_EQ(outcome.status == Status::coordinate_off_lattice, off) << value;
                ASSERT_TRUE(!off || outcome.vertex == vertex);
            }
        }
    }
}

// Six times the volume of the tetrahedron of a face's corners.
std::int64_t volume_of_corners(const Wedge& wedge, std::uint32_t first) {
    std::int64_t m[3][3];
    const auto at = [&](std::uint32_t k) { return wedge.vertices[wedge.corners[first + k]]; };
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned axis = 0; axis < 3; ++axis) m[row][axis] = at(row + 1).at[axis] - at(0).at[axis];
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(Check, NamesTheFirstCornerOffItsFacesPlane) {
    for (std::uint32_t vertex = 0; vertex < 6; ++vertex) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            for (const std::int32_t by : {-1, 1}) {
                Wedge wedge;
                wedge.vertices[vertex].at[axis] += by;
                std::uint32_t face = 0;
                while (face < 5 && (wedge.ring_starts[face + 1] - wedge.ring_starts[face] == 3 ||
                                    volume_of_corners(wedge, wedge.ring_starts[face]) == 0)) {
                    ++face;
                }
                const CheckOutcome outcome = wedge.checked();
                ASSERT_EQ(outcome.status, face < 5 ? Status::face_not_planar : Status::ok);
                if (face == 5) continue;
                ASSERT_EQ(outcome.face, face);
                ASSERT_EQ(outcome.ring, face);
                ASSERT_EQ(outcome.corner, wedge.ring_starts[face] + 3); // three always have a plane
                ASSERT_EQ(outcome.vertex, wedge.corners[outcome.corner]);
            }
        }
    }
}

// How often an edge of these places runs one way, less how often the other way.
int surplus(const Wedge& wedge, const Edge& edge) {
    int surplus = 0;
    for (std::uint32_t corner = 0; corner < wedge.corners.size(); ++corner) {
        const std::uint32_t ring = wedge.ring_of(corner);
        const std::uint32_t next =
            corner + 1 < wedge.ring_starts[ring + 1] ? corner + 1 : wedge.ring_starts[ring];
        const Point from = wedge.vertices[wedge.corners[corner]];
        const Point to = wedge.vertices[wedge.corners[next]];
        surplus += from == wedge.vertices[edge.from] && to == wedge.vertices[edge.to]   ? 1
                   : from == wedge.vertices[edge.to] && to == wedge.vertices[edge.from] ? -1
                                                                                        : 0;
    }
    return surplus;
}

TEST(Check, NamesAnEdgeUsedTooOften) {
    for (std::uint32_t face = 0; face < 5; ++face) {
        Wedge turned;
        for (std::uint32_t i = turned.ring_starts[face], j = turned.ring_starts[face + 1] - 1; i < j;
             ++i, --j) {
            std::swap(turned.corners[i], turned.corners[j]);
        }
        const CheckOutcome outcome = turned.checked();
        ASSERT_EQ(outcome.status, Status::surface_not_closed);
        ASSERT_EQ(surplus(turned, outcome.edge), 2);
    }
    Wedge open; // without the last face
    open.corners.resize(14);
    open.ring_starts.pop_back();
    open.face_rings.pop_back();
    const CheckOutcome outcome = open.checked();
    ASSERT_EQ(outcome.status, Status::surface_not_closed);
    ASSERT_EQ(surplus(open, outcome.edge), 1);
}

TEST(Check, NamesTheRingThatIsTooShort) {
    for (std::uint32_t ring = 0; ring < 5; ++ring) {
        for (const std::uint32_t length : {0U, 1U, 2U}) {
            Wedge wedge;
            const std::uint32_t dropped = wedge.ring_starts[ring + 1] - wedge.ring_starts[ring] - length;
            wedge.corners.erase(wedge.first_of(ring),
                                wedge.first_of(ring) + static_cast<std::ptrdiff_t>(dropped));
            for (std::uint32_t r = ring + 1; r <= 5; ++r) wedge.ring_starts[r] -= dropped;
            const CheckOutcome outcome = wedge.checked();
            ASSERT_EQ(outcome.status, Status::ring_too_short);
            ASSERT_EQ(outcome.face, ring);
            ASSERT_EQ(outcome.ring, ring);
        }
    }
}

// The last thing before the cycle, which is the first to write to the scratch.
TEST(Check, ScratchTooSmallIsRefusedAndNotWritten) {
    const Wedge wedge;
    std::vector<Edge> scratch(18, Edge{77, 78});
    for (const std::uint32_t size : {0U, 1U, 17U}) {
        EXPECT_EQ(check(wedge.view(), scratch.data(), size).status, Status::scratch_too_small);
        for (const Edge& edge : scratch) EXPECT_TRUE(edge.from == 77 && edge.to == 78);
    }
    EXPECT_EQ(check(wedge.view(), scratch.data(), 18).status, Status::ok);
    Wedge bent;
    bent.vertices[2].at[2] += 1;
    EXPECT_EQ(check(bent.view(), scratch.data(), 0).status, Status::face_not_planar);
}

// Each corner gets a vertex of its own.
void unweld(Wedge& wedge) {
    std::vector<Point> vertices;
    for (std::uint32_t& corner : wedge.corners) {
        vertices.push_back(wedge.vertices[corner]);
        corner = static_cast<std::uint32_t>(vertices.size() - 1);
    }
    wedge.vertices = vertices;
}

// A face once more, either way round: each of its edges is used twice one way and once the other.
TEST(Check, NamesAnEdgeTheWayThatIsUsedTooOften) {
    for (std::uint32_t face = 0; face < 5; ++face) {
        for (const bool turned : {false, true}) {
            for (const bool welded : {false, true}) {
                Wedge wedge;
                std::vector<std::uint32_t> ring(wedge.first_of(face), wedge.first_of(face + 1));
                if (turned) std::reverse(ring.begin(), ring.end());
                wedge.corners.insert(wedge.corners.end(), ring.begin(), ring.end());
                wedge.ring_starts.push_back(static_cast<std::uint32_t>(wedge.corners.size()));
                wedge.face_rings.push_back(6);
                if (!welded) unweld(wedge);
                const CheckOutcome outcome = wedge.checked();
                ASSERT_EQ(outcome.status, Status::surface_not_closed);
                ASSERT_EQ(surplus(wedge, outcome.edge), 1);
            }
        }
    }
}

} // namespace

} // namespace osem::tests
