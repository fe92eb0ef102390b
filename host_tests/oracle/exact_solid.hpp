// A solid as a set of exact pieces: does its surface meet an open octant, and how often does it wind around
// a point? Independent of the kernel and exact throughout.
#ifndef OSEM_ORACLE_EXACT_SOLID_HPP
#define OSEM_ORACLE_EXACT_SOLID_HPP

#include <memory>

#include "exact_face.hpp"
#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace oracle {

class ExactSolid {
  public:
    /// Precondition: every face is planar.
    explicit ExactSolid(const osem::Solid& solid);
    ~ExactSolid();
    ExactSolid(const ExactSolid&) = delete;
    ExactSolid& operator=(const ExactSolid&) = delete;

    /// Whether the surface shares a point with the open octant.
    bool meets_open(const osem::Octant& octant) const;

    /// How often the surface winds around a point: the outward crossings, less the inward ones, of a way
    /// from the point out of the root octant. Preconditions: the surface is a cycle; the point is in the
    /// root octant and off the surface.
    int winding(const Point3& p) const;

  private:
    struct Trees;
    std::unique_ptr<Trees> trees_;
};

/// The centre of an octant, half-integral when its side is 1.
Point3 centre_of(const osem::Octant& octant);

/// The centre moved by (e, e^2, e^3) with e = 2^-100. That e is as good as an infinitesimal: on lattice
/// data the value of a plane along the curve is a polynomial a + b e + c e^2 + d e^3 with integers below
/// 2^63 in magnitude, so its first coefficient other than 0 outweighs the others on all of (0, 2^-100], and
/// the point can be drawn to the centre without crossing a plane. Precondition: side of 2 or more.
Point3 perturbed_centre_of(const osem::Octant& octant);

} // namespace oracle

#endif
