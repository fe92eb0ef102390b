// The first leaf a ray meets.
#ifndef OSEM_HOST_RAY_WALK_HPP
#define OSEM_HOST_RAY_WALK_HPP

#include "osem/octree.hpp"
#include "picture/vector.hpp"

namespace osem::host {

/// Where a ray enters the first leaf that is not white.
struct Hit {
    double distance; ///< from the ray's origin, in root sides
    Colour colour;   ///< black or boundary
    unsigned axis;   ///< the leaf's face that the ray enters by is perpendicular to it
};

/// Walks octants along parallel rays, nearest first, in the parameter of the ray: the octants a ray meets are
/// known from its parameters at the root's six planes, halved on the way down.
/// Source: Revelles, Urena and Lastra, An Efficient Parametric Algorithm for Octree Traversal, WSCG 2000.
class RayWalk {
  public:
    /// Rays of one unit direction through a tree.
    RayWalk(const Octree& tree, const Vector& direction);

    /// Casts the ray from `origin`, a point from which the whole root lies ahead; false when it meets
    /// nothing.
    bool cast(const Vector& origin, Hit& hit) const;

  private:
    struct Frame {
        Node node;
        Vector enter;   ///< parameters at the octant's near planes,
        Vector middle;  ///< at its middle planes,
        Vector leave;   ///< and at its far ones
        unsigned child; ///< in the mirrored order
        bool upper(unsigned axis) const { return ((child >> axis) & 1U) != 0; }
    };
    static Frame frame_of(const Node& node, const Vector& enter, const Vector& leave);
    static bool advance(Frame& frame);
    Hit hit_of(const Frame& frame, Colour colour) const;

    const Octree& tree_;
    Vector inverse_;        ///< of the direction, mirrored so that all components are positive
    unsigned mirrored_ = 0; ///< bit i: axis i is mirrored
};

} // namespace osem::host

#endif
