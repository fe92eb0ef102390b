// Random faces and octants near them, most of them degenerate in some way.
#ifndef OSEM_ORACLE_FACE_CASE_HPP
#define OSEM_ORACLE_FACE_CASE_HPP

#include <random>
#include <vector>

#include "osem/lattice.hpp"
#include "solids.hpp"

namespace oracle {

/// One case is one seed: a face and several octants near it.
class FaceCase {
  public:
    explicit FaceCase(unsigned seed);

    const osem::Octant& octant() const { return octant_; }

    /// The octant itself, its children, and the neighbours that exist.
    std::vector<osem::Octant> octants() const;

    TestSolid face();

  private:
    struct Span;

    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned long>(n)); }
    std::int32_t coordinate(unsigned axis);
    osem::Point corner();
    osem::Point near_point();
    osem::Point step(std::int32_t unit);
    static bool on_span(const std::vector<FlatRing>& rings, const Span& span, std::vector<Polygon>& polygons);
    std::vector<Polygon> laid(const std::vector<FlatRing>& rings);
    std::vector<Polygon> quad();
    std::vector<Polygon> with_hole();
    Polygon long_ring();

    std::mt19937 random_;
    osem::Octant octant_{};
};

/// Whether the closed bounding box of the face reaches the open octant: stage 1 by its own words.
bool boxes_overlap(const TestSolid& face, const osem::Octant& octant);

} // namespace oracle

#endif
