// What a conversion will take, guessed beforehand. No result depends on it, only how long it takes.
#ifndef OSEM_HOST_ESTIMATE_HPP
#define OSEM_HOST_ESTIMATE_HPP

#include <array>
#include <cstdint>

#include "osem/solid.hpp"

namespace osem::host {

struct Estimate {
    double leaves = 0; ///< the area of faces, in squares of a leaf's side
    double faces = 0;

    void add(const Estimate& other) {
        leaves += other.leaves;
        faces += other.faces;
    }
    /// Nodes of the tree: three-valued trees of meshes have about half a node a leaf of area, so this is
    /// mostly enough, whatever the number of faces. At most 2^26, which are 400 MB: beyond that it is found
    /// out instead.
    std::uint64_t nodes() const;
    /// Proportional to the time by grids: a face takes as long as some fifty leaves of its area.
    double effort() const { return leaves + 50 * faces; }
};

/// For leaves of a depth; a face counts in the child of the root in which its first corner lies.
std::array<Estimate, 8> estimate_children(const Solid& solid, int depth);

/// All of them.
Estimate estimate(const Solid& solid, int depth);

} // namespace osem::host

#endif
