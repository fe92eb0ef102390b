#include "mesh/topology.hpp"

#include <algorithm>

#include "mesh/edge_uses.hpp"
#include "mesh/face_sets.hpp"
#include "mesh/volume.hpp"

namespace osem::host {

namespace {

constexpr std::uint32_t none = UINT32_MAX;

// Whether the corners around every vertex form one closed fan. twin[c] is the corner at the start of the
// other, opposite use of corner c's edge.
bool vertices_are_manifold(const IntegerSolid& solid, const std::vector<std::uint32_t>& next,
                           const std::vector<std::uint32_t>& twin) {
    std::vector<bool> seen(solid.corners.size(), false);
    std::vector<bool> has_fan(solid.vertices.size(), false);
    for (std::uint32_t start = 0; start < solid.corners.size(); ++start) {
        if (seen[start]) continue;
        const std::uint32_t vertex = solid.corners[start];
        if (has_fan[vertex]) return false;
        has_fan[vertex] = true;
        for (std::uint32_t corner = start; !seen[corner]; corner = next[twin[corner]]) seen[corner] = true;
    }
    return true;
}

std::uint32_t used_vertices(const IntegerSolid& solid) {
    std::vector<bool> used(solid.vertices.size(), false);
    for (const std::uint32_t vertex : solid.corners) used[vertex] = true;
    return static_cast<std::uint32_t>(std::count(used.begin(), used.end(), true));
}

double volume6(const IntegerSolid& solid) {
    const Solid view = solid.view();
    WideSum sum;
    for (std::uint32_t face = 0; face < view.face_count; ++face) add_volume6(sum, view, face);
    return sum.value();
}

} // namespace

Topology topology(const IntegerSolid& solid) {
    Topology result;
    result.faces = solid.face_count();
    result.rings = solid.ring_count();
    result.hole_rings = result.rings - result.faces;
    result.vertices = used_vertices(solid);
    result.volume6 = volume6(solid);

    const std::vector<std::uint32_t> next = next_corners(solid);
    const std::vector<std::uint32_t> face_of = faces_of_corners(solid);
    std::vector<std::uint32_t> twin(solid.corners.size(), none);
    FaceSets shells(result.faces);
    result.manifold = result.faces != 0;
    const auto uses = edge_uses(solid, static_cast<std::uint32_t>(solid.vertices.size()), next);
    for_each_edge(uses, [&](const EdgeUse* first, const EdgeUse* end) {
        ++result.edges;
        for (const EdgeUse* use = first + 1; use != end; ++use) {
            shells.unite(face_of[first->corner], face_of[use->corner]);
        }
        const bool paired = end - first == 2 && face_of[first->corner] != face_of[first[1].corner] &&
                            solid.corners[first->corner] != solid.corners[first[1].corner];
        if (!paired) {
            result.manifold = false;
            return;
        }
        twin[first->corner] = first[1].corner;
        twin[first[1].corner] = first->corner;
    });
    result.shells = shells.count();
    if (result.manifold) result.manifold = vertices_are_manifold(solid, next, twin);
    if (result.manifold) {
        const std::int64_t euler =
            std::int64_t{result.vertices} - result.edges + result.faces - result.hole_rings;
        result.genus = result.shells - euler / 2;
    }
    return result;
}

} // namespace osem::host
