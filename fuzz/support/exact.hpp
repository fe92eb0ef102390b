// Faces and solids over integers of any length: what the kernel's predicates have to answer.
//
// Nothing here shares an idea with the kernel beyond the definitions: edges are clipped to parameters, a
// section is decided at the mean of its corners, winding numbers are counted along skew ways out of the root.
#ifndef OSEM_FUZZ_EXACT_HPP
#define OSEM_FUZZ_EXACT_HPP

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace osem::fuzz {

/// The point at / 2^bits.
struct ScaledPoint {
    std::array<mpz_class, 3> at;
    unsigned bits;
};

ScaledPoint scaled(const Point& p);

/// p moved by (e, e^2, e^3) with e = 2^-100. For lattice data that is as good as an infinitesimal: a plane's
/// value along the curve is a polynomial in e whose coefficients are integers below 2^63, so its first
/// coefficient other than 0 outweighs the others.
ScaledPoint perturbed(const Point& p);

/// The centre of an octant, moved if the octant's side is 2 or more and `moved`.
ScaledPoint centre(const Octant& octant, bool moved);

/// An open box.
struct OpenBox {
    Point low;
    Point high;
};
OpenBox open_box(const Octant& octant);

/// A planar face: the closed set of its rings and of what they wind around.
class ExactFace {
  public:
    ExactFace(const Solid& solid, std::uint32_t face);

    bool is_planar() const;
    bool has_area() const { return axis_ >= 0; }
    const std::array<mpz_class, 3>& normal() const { return normal_; }
    /// The normal's value at p, less that at the face's first corner: its sign is p's side.
    mpz_class side(const ScaledPoint& p) const;

    /// Whether the closed bounding box shares a point with the open box.
    bool box_meets(const OpenBox& box) const;
    /// Whether the face's plane does. Precondition: has_area.
    bool plane_meets(const OpenBox& box) const;
    /// Whether the face does.
    bool meets(const OpenBox& box) const;

    /// How the winding number changes from p to q; none when the way ends on the face, meets a ring, or runs
    /// in the plane.
    std::optional<int> change(const ScaledPoint& p, const ScaledPoint& q) const;

  private:
    /// The corners of the section of plane and closed box that are no corners of other sections.
    std::vector<std::array<mpq_class, 3>> section(const OpenBox& box) const;
    /// How often the rings wind around (u, v) / w, as the normal sees it; none on a ring.
    std::optional<int> winding(const mpz_class& u, const mpz_class& v, const mpz_class& w) const;

    std::vector<std::vector<Point>> rings_;
    std::array<mpz_class, 3> normal_;
    int axis_ = -1; ///< along which the normal is not 0; -1: the null normal
};

/// Faces that are a cycle together.
class ExactSolid {
  public:
    explicit ExactSolid(const Solid& solid);

    std::size_t face_count() const { return faces_.size(); }
    const ExactFace& face(std::size_t index) const { return faces_[index]; }
    /// Those of the given faces that meet an open octant.
    std::vector<std::size_t> meeting(const std::vector<std::size_t>& faces, const Octant& octant) const;
    /// How often the surface winds around a point of the root that is not on it.
    int winding(const ScaledPoint& p) const;

  private:
    std::vector<ExactFace> faces_;
};

} // namespace osem::fuzz

#endif
