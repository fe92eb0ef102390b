// The boundary of a face made ready for triangulation.
#ifndef OSEM_HOST_MESH_FACE_CYCLES_HPP
#define OSEM_HOST_MESH_FACE_CYCLES_HPP

#include <cstdint>
#include <vector>

#include "mesh/flat.hpp"
#include "mesh/triangulate.hpp"

namespace osem::host {

/// A corner in a doubly linked closed walk.
struct CycleNode {
    std::uint32_t vertex; ///< index into FaceCycles::at
    std::uint32_t previous;
    std::uint32_t next;
};

/// Closed walks with the face on their left. In a face whose rings touch at most, no two walks cross, none
/// passes a vertex except as a corner, and the sectors between the edges of the corners do not overlap.
struct FaceCycles {
    std::vector<FlatPoint> at;        ///< the face's vertices, projected
    std::vector<std::uint32_t> names; ///< their indices in the solid
    std::vector<CycleNode> nodes;
    std::vector<std::uint32_t> heads; ///< a node of each cycle

    const FlatPoint& point(std::uint32_t node) const { return at[nodes[node].vertex]; }
};

/// The cycles of a face. Edges that pass another corner are broken there; the triangles of zero area that
/// account for the difference go to `triangles`. Opposite edges (the two banks of a slit) cancel.
FaceCycles face_cycles(const Solid& solid, std::uint32_t face, std::vector<Triangle>& triangles);

} // namespace osem::host

#endif
