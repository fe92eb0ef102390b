// Solids that own their arrays, ways to build them, and the library that the oracle tests run over.
#ifndef OSEM_ORACLE_SOLIDS_HPP
#define OSEM_ORACLE_SOLIDS_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace oracle {

using Polygon = std::vector<osem::Point>; ///< a ring by its corners, the last joined to the first

class TestSolid {
  public:
    std::string name;
    std::vector<osem::Point> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> ring_starts{0};
    std::vector<std::uint32_t> face_rings{0};
    bool weld = true; ///< whether equal points become one vertex

    explicit TestSolid(std::string solid_name = {}) : name(std::move(solid_name)) {}

    void add_face(const std::vector<Polygon>& rings);
    void add(const TestSolid& other);

    /// Turns every face over.
    void invert();

    /// Without ring tables when every face is a triangle.
    osem::Solid view() const;
    /// With ring tables in any case.
    osem::Solid view_with_tables() const;

  private:
    std::uint32_t vertex(const osem::Point& p);
};

/// What the library's small coordinates, 0 to 32, become: origin + unit * coordinate. A polygon's second
/// and third coordinates are those that follow its axis in cyclic order.
struct Grid {
    const char* name;
    osem::Point origin;
    std::int32_t unit;

    osem::Point operator()(int x, int y, int z) const {
        return {{origin.x() + unit * x, origin.y() + unit * y, origin.z() + unit * z}};
    }
};

using Flat = std::array<int, 2>;
using FlatRing = std::vector<Flat>;

TestSolid box(const Grid& grid, std::array<int, 3> low, std::array<int, 3> high);
TestSolid tetrahedron(const osem::Point& a, const osem::Point& b, const osem::Point& c, const osem::Point& d);

/// The rings (the outer one counter-clockwise, holes clockwise) swept along an axis from low to high.
TestSolid prism(const Grid& grid, osem::Axis axis, const std::vector<FlatRing>& rings, int low, int high);

/// Adds `p` times coordinate `from` and then subtracts `q` units: an integer shear, which keeps planes plane
/// and the orientation. The caller sees to it that the result is on the lattice.
TestSolid sheared(TestSolid solid, osem::Axis from, osem::Axis to, int p, std::int32_t offset);

/// The library on a grid: deterministic; every name is unique.
std::vector<TestSolid> library(const Grid& grid);

/// Random solids on a grid: soups of tetrahedra and convex hulls, with coordinates biased to even ones.
std::vector<TestSolid> random_solids(const Grid& grid, unsigned count, unsigned seed);

/// Every `step`th of some solids.
std::vector<TestSolid> every(std::size_t step, std::vector<TestSolid> solids);

/// The grids of the tests: one whose planes are planes of octants and which fills the root; one that has
/// nothing in common with octants; one of unit 1, whose solids are a few leaves of side 1 wide.
extern const Grid aligned_grid;
extern const Grid crooked_grid;
extern const Grid tiny_grid;

/// The octant in which all solids of the tiny grid lie: side 32.
extern const osem::Octant tiny_window;

} // namespace oracle

#endif
