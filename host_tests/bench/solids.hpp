// The solids that are measured: real meshes, the bundled bracket, and spheres of any number of faces.
#ifndef OSEM_BENCH_SOLIDS_HPP
#define OSEM_BENCH_SOLIDS_HPP

#include <string>
#include <vector>

#include "mesh/quantize.hpp"
#include "mesh/triangulate.hpp"

namespace osem::bench {

/// A solid on the lattice, checked, and its faces cut into triangles for those who take nothing else. All
/// methods are given these integers.
struct BenchSolid {
    host::IntegerSolid solid;
    std::vector<host::Triangle> triangles;

    /// Valid while this object stays where it is.
    CheckedSolid checked() const { return CheckedSolid::vouched(solid.view()); }
};

/// The solid of a name, made once and kept: "bracket", "sphere-F" (F faces; nearly fills the root), "dot-F"
/// (the same sphere, a sixteenth as wide), "ties" (parts that overlap; vertices, edges and faces pass through
/// cells' centres at 256 cells along an axis), or that of a mesh in CGAL's data folder. F is 20 times
/// a power of 4. Other solids are scaled to fit the root, with a margin of 777 lattice units. Ends the
/// program when there is no such solid.
const BenchSolid& solid_of(const std::string& name);

} // namespace osem::bench

#endif
