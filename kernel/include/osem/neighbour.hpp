// What lies on the other side of an octant's face.
//
// After Samet, "Neighbor Finding in Images Represented by Octrees", CVGIP 46(3), 1989; since nodes do not
// know their parents, the neighbour is found from the root.
#ifndef OSEM_NEIGHBOUR_HPP
#define OSEM_NEIGHBOUR_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"

namespace osem {

/// One of an octant's six faces: perpendicular to an axis, on its low or its high side.
struct OctantFace {
    Axis axis;
    bool high;
};

/// Outcome of a neighbour query.
struct NeighbourOutcome {
    Status status;
    bool outside;  ///< the face lies in the root's; octant and colour are then the root's and white
    Octant octant; ///< the neighbour: of the same size, or a greater leaf (of a part of a leaf: that leaf)
    Colour colour; ///< grey when the neighbour of the same size is divided
    std::uint32_t visited; ///< nodes visited, at most the octant's level
};

/// The neighbour of an octant, a leaf or not, across one of its faces. Status: ok; coordinate_out_of_range
/// when the octant is none of the lattice: its level is above 20, its corner no multiple of its side, or
/// outside the root. When not ok the octant is the root and the colour boundary. Cost: O(level) nodes.
NeighbourOutcome face_neighbour(const Octree& tree, const Octant& octant, OctantFace face);

/// Walks the leaves on the other side of an octant's face, in Morton order, with O(depth) state: those that
/// share an area with it. That is one where the neighbour is a leaf, none outside the root. for
/// (NeighbourWalk w(tree, octant, face); w.next(leaf);)
class NeighbourWalk {
  public:
    /// Status and cost are those of face_neighbour; a refused walk has no leaves.
    NeighbourWalk(const Octree& tree, const Octant& octant, OctantFace face);
    Status status() const { return neighbour_.status; }

    /// Takes the next leaf; false when there is none. Cost over the whole walk: O(nodes visited), each of
    /// which divides an octant that has a part of the face in its own.
    bool next(Leaf& leaf);

    /// Nodes visited so far, those on the way to the neighbour included.
    std::uint32_t visited() const { return neighbour_.visited; }

  private:
    NeighbourOutcome neighbour_;
    const NodePool* pool_;
    std::uint8_t near_ = 0; ///< the children along the face
    bool single_ = false;   ///< the neighbour is a leaf still to be taken
    bool divided_ = false;  ///< octants still to be gone through; octant_ is the one reached
    Octant octant_ = root_octant;
    Node path_[max_depth];
    std::uint8_t left_[max_depth]; ///< children of each still to be taken
};

} // namespace osem

#endif
