// The edges of a surface: which corners use which.
#ifndef OSEM_HOST_MESH_EDGE_USES_HPP
#define OSEM_HOST_MESH_EDGE_USES_HPP

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace osem::host {

/// The edge from corner `corner` (a position in FaceTable::corners) to the next corner of its ring.
struct EdgeUse {
    std::uint32_t low;  ///< the lesser of its vertices
    std::uint32_t high; ///< the greater
    std::uint32_t corner;
};

/// For every corner the next one in its ring.
std::vector<std::uint32_t> next_corners(const FaceTable& faces);

/// For every corner its face.
std::vector<std::uint32_t> faces_of_corners(const FaceTable& faces);

/// All edge uses, those of an edge together; an edge is its two vertices, wherever these lie.
std::vector<EdgeUse> edge_uses(const FaceTable& faces, std::uint32_t vertex_count,
                               const std::vector<std::uint32_t>& next);

/// Calls visit(first, end) with the uses of every edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit visit) {
    const EdgeUse* const end = uses.data() + uses.size();
    for (const EdgeUse* first = uses.data(); first != end;) {
        const EdgeUse* last = first + 1;
        while (last != end && last->low == first->low && last->high == first->high) ++last;
        visit(first, last);
        first = last;
    }
}

} // namespace osem::host

#endif
