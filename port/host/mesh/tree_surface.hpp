// The surface of an octree, in arrays of its own and in pieces that mesh files can hold.
#ifndef OSEM_HOST_MESH_TREE_SURFACE_HPP
#define OSEM_HOST_MESH_TREE_SURFACE_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"
#include "osem/boundary.hpp"

namespace osem::host {

/// A surface on the lattice. Equal points are different vertices where several sheets of it touch.
struct TreeSurface : FaceTable {
    std::vector<Point> vertices;
    std::uint32_t double_edges = 0; ///< as BoundaryOutcome says

    Solid view() const;
};

/// Told now and then how much of a whole is done.
using Report = std::function<void(std::uint64_t part, std::uint64_t whole)>;

/// The surface of a tree's inner or outer solid.
TreeSurface surface_of(const Octree& tree, SolidPart part, const Report& report);

/// The surface in faces of one ring each that passes through no vertex and no point twice: faces of which
/// that is true already as they are if `keep_polygons`, every other in triangles. The vertices stay.
TreeSurface in_simple_faces(const TreeSurface& surface, bool keep_polygons, const Report& report);

} // namespace osem::host

#endif
