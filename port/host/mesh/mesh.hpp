// A polygon mesh as a file gives it, before it meets the lattice.
#ifndef OSEM_HOST_MESH_MESH_HPP
#define OSEM_HOST_MESH_MESH_HPP

#include <array>
#include <cstdint>
#include <vector>

namespace osem::host {

/// Faces made of rings made of corners (vertex indices), in the kernel's layout: ring r has the corners
/// [ring_starts[r], ring_starts[r + 1]), face f the rings [face_rings[f], face_rings[f + 1]), its outer ring
/// first.
struct FaceTable {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> ring_starts{0}; ///< ring count + 1 entries
    std::vector<std::uint32_t> face_rings{0};  ///< face count + 1 entries

    std::uint32_t face_count() const { return static_cast<std::uint32_t>(face_rings.size() - 1); }
    std::uint32_t ring_count() const { return static_cast<std::uint32_t>(ring_starts.size() - 1); }

    /// Makes the corners pushed since the last call a ring. Throws BadInput when there are more corners
    /// than 32-bit indices can count.
    void end_ring();
    /// Makes the rings ended since the last call a face.
    void end_face();
};

/// A polygon mesh in the file's own coordinates.
struct Mesh : FaceTable {
    std::vector<std::array<double, 3>> vertices;
    bool oriented = true; ///< false for TetGen .poly: facets carry no orientation, their rings no roles
};

} // namespace osem::host

#endif
