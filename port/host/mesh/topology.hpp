// What a surface is made of: counts, shells, genus, volume.
#ifndef OSEM_HOST_MESH_TOPOLOGY_HPP
#define OSEM_HOST_MESH_TOPOLOGY_HPP

#include <cstdint>
#include <optional>

#include "mesh/quantize.hpp"

namespace osem::host {

struct Topology {
    std::uint32_t faces = 0;
    std::uint32_t rings = 0;
    std::uint32_t hole_rings = 0; ///< rings - faces
    std::uint32_t vertices = 0;   ///< lattice points that are corners
    std::uint32_t edges = 0;      ///< undirected, by lattice points
    std::uint32_t shells = 0;     ///< components of faces joined by edges
    bool manifold =
        false; ///< each edge is used by two faces, once a way, and each vertex has one fan of faces
    /// Sum over the shells, by Euler and Poincare: V - E + F - hole rings = 2 (shells - genus); only for a
    /// manifold surface.
    std::optional<std::int64_t> genus;
    double volume6 = 0; ///< six times the signed volume in lattice units, exactly summed, then rounded once
};

Topology topology(const IntegerSolid& solid);

} // namespace osem::host

#endif
