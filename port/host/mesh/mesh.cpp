#include "mesh/mesh.hpp"

#include "mesh/bad_input.hpp"

namespace osem::host {

void FaceTable::end_ring() {
    // 2^32 - 1 is left free as a mark for "no corner".
    if (corners.size() >= UINT32_MAX) throw BadInput("the mesh has more corners than 32 bits can count");
    ring_starts.push_back(static_cast<std::uint32_t>(corners.size()));
}

void FaceTable::end_face() { face_rings.push_back(ring_count()); }

} // namespace osem::host
