// A solid: a boundary representation in the caller's arrays, and the check that gives it a meaning.
#ifndef OSEM_SOLID_HPP
#define OSEM_SOLID_HPP

#include <cstddef>
#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/status.hpp"

namespace osem {

/// A ring: `count` corners, each an index into the vertex table; the last is joined to the first.
struct Ring {
    const std::uint32_t* corners;
    std::uint32_t count;
};

/// A view over a boundary representation; nothing is copied, so every table may lie in flash.
///
/// Vertices are lattice points. A face is planar and made of rings: the first is its outer ring,
/// counter-clockwise seen from outside the solid, the others are holes, clockwise. Rings may be concave and
/// may touch. Ring r has the corners [ring_starts[r], ring_starts[r + 1]); face f has the rings
/// [face_rings[f], face_rings[f + 1]). Both tables are null for a triangle mesh: face f is then the ring of
/// corners 3f, 3f + 1, 3f + 2.
struct Solid {
    const Point* vertices;
    std::uint32_t vertex_count;
    const std::uint32_t* corners;
    std::uint32_t corner_count;
    const std::uint32_t* ring_starts; ///< face_rings[face_count] + 1 entries, or null
    const std::uint32_t* face_rings;  ///< face_count + 1 entries, or null
    std::uint32_t face_count;

    constexpr bool is_triangle_mesh() const { return face_rings == nullptr; }
    constexpr std::uint32_t first_ring(std::uint32_t face) const {
        return is_triangle_mesh() ? face : face_rings[face];
    }
    constexpr std::uint32_t end_ring(std::uint32_t face) const {
        return is_triangle_mesh() ? face + 1 : face_rings[face + 1];
    }
    constexpr std::uint32_t first_corner(std::uint32_t ring) const {
        return is_triangle_mesh() ? 3 * ring : ring_starts[ring];
    }
    constexpr Ring ring(std::uint32_t r) const {
        return Ring{corners + first_corner(r), first_corner(r + 1) - first_corner(r)};
    }
    constexpr std::uint32_t ring_count() const { return face_count == 0 ? 0 : end_ring(face_count - 1); }
};

/// A triangle mesh over caller arrays: triangle t has the corners indices[3t .. 3t + 2].
/// Precondition: triangle_count <= (2^32 - 1) / 3.
constexpr Solid triangle_mesh(const Point* vertices, std::uint32_t vertex_count, const std::uint32_t* indices,
                              std::uint32_t triangle_count) {
    return Solid{vertices, vertex_count, indices, 3 * triangle_count, nullptr, nullptr, triangle_count};
}

/// A directed edge, from one vertex index to another: one entry of check's scratch.
struct Edge {
    std::uint32_t from;
    std::uint32_t to;
};
static_assert(sizeof(Edge) == 8, "edges are packed");

/// Entries of scratch that check needs: one Edge a corner.
constexpr std::uint32_t check_scratch(const Solid& solid) { return solid.corner_count; }

/// A solid that check has accepted, or that the caller vouches for. Conversion takes nothing else.
class CheckedSolid {
  public:
    /// For a solid that a host checked before it was put into flash. What check would refuse is undefined
    /// behaviour here.
    static constexpr CheckedSolid vouched(const Solid& solid) { return CheckedSolid(solid); }
    constexpr const Solid& view() const { return solid_; }

  private:
    explicit constexpr CheckedSolid(const Solid& solid) : solid_(solid) {}
    Solid solid_;
};

/// What check found. On refusal the fields that the status names say where; the others are 0.
struct CheckOutcome {
    Status status;
    std::uint32_t face;   ///< ring_table_invalid, index_out_of_range, ring_too_short, face_not_planar
    std::uint32_t ring;   ///< ring_table_invalid, index_out_of_range, ring_too_short, face_not_planar
    std::uint32_t corner; ///< index_out_of_range, face_not_planar: position in Solid::corners
    std::uint32_t vertex; ///< index_out_of_range, coordinate_off_lattice, face_not_planar: the vertex index
    Edge edge;            ///< surface_not_closed: a directed edge used too often, as vertex indices
    CheckedSolid solid;   ///< to convert if and only if status is ok
};

/// Decides whether a solid has an exact meaning. It has one when every face is planar and the surface is a
/// cycle: each undirected edge (compared by the coordinates of its ends, so vertices need not be welded) is
/// used as often in one direction as in the other. Then every point off the surface has a winding number.
/// Nested shells, touching parts, edges shared by four faces, self-intersection and zero-area faces are all
/// accepted; a zero-area face stands for the points of its ring.
///
/// Scratch: check_scratch(solid) edges; overwritten. Cost: O(c log c) for c corners at worst; O(c) as a rule
/// where vertices are welded (a hash table, in the scratch). No recursion.
/// The arrays must have the lengths that Solid states; what they hold is not trusted.
/// Status, in the order looked for: ring_table_invalid; ring_too_short and index_out_of_range, face by face;
/// coordinate_off_lattice, face_not_planar, scratch_too_small, surface_not_closed; ok otherwise. A table that
/// is invalid as a whole (null, or of the wrong length for a triangle mesh) is reported at face 0.
CheckOutcome check(const Solid& solid, Edge* scratch, std::uint32_t scratch_size);

} // namespace osem

#endif
