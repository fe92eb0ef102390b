#include "mesh/edge_uses.hpp"

#include <algorithm>
#include <tuple>

namespace osem::host {

std::vector<std::uint32_t> next_corners(const FaceTable& faces) {
    std::vector<std::uint32_t> next(faces.corners.size());
    for (std::size_t ring = 0; ring + 1 < faces.ring_starts.size(); ++ring) {
        const std::uint32_t first = faces.ring_starts[ring];
        const std::uint32_t end = faces.ring_starts[ring + 1];
        for (std::uint32_t corner = first; corner < end; ++corner) {
            next[corner] = corner + 1 == end ? first : corner + 1;
        }
    }
    return next;
}

std::vector<std::uint32_t> faces_of_corners(const FaceTable& faces) {
    std::vector<std::uint32_t> face_of(faces.corners.size());
    for (std::uint32_t face = 0; face < faces.face_count(); ++face) {
        const std::uint32_t first = faces.ring_starts[faces.face_rings[face]];
        const std::uint32_t end = faces.ring_starts[faces.face_rings[face + 1]];
        std::fill(face_of.data() + first, face_of.data() + end, face);
    }
    return face_of;
}

// A counting sort by the lower vertex and a small sort for each vertex: half the time of one large sort.
std::vector<EdgeUse> edge_uses(const FaceTable& faces, std::uint32_t vertex_count,
                               const std::vector<std::uint32_t>& next) {
    const auto& corners = faces.corners;
    const auto corner_count = static_cast<std::uint32_t>(corners.size());
    const auto low = [&](std::uint32_t corner) { return std::min(corners[corner], corners[next[corner]]); };
    std::vector<std::uint32_t> starts(std::size_t{vertex_count} + 1, 0);
    for (std::uint32_t corner = 0; corner < corner_count; ++corner) ++starts[low(corner) + 1];
    for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) starts[vertex + 1] += starts[vertex];

    std::vector<EdgeUse> uses(corner_count);
    std::vector<std::uint32_t> place(starts.begin(), starts.end() - 1);
    for (std::uint32_t corner = 0; corner < corner_count; ++corner) {
        const std::uint32_t vertex = low(corner);
        uses[place[vertex]++] = {vertex, std::max(corners[corner], corners[next[corner]]), corner};
    }
    for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
        std::sort(uses.data() + starts[vertex], uses.data() + starts[vertex + 1],
                  [](const EdgeUse& a, const EdgeUse& b) {
                      return std::tie(a.high, a.corner) < std::tie(b.high, b.corner);
                  });
    }
    return uses;
}

} // namespace osem::host
