// The solids of the conversion and Boolean vectors.
#ifndef OSEM_VECTORS_SOURCES_HPP
#define OSEM_VECTORS_SOURCES_HPP

#include <string>
#include <vector>

#include "off_mesh.hpp"
#include "solids.hpp"

namespace vectors {

/// The library and some random solids on a grid.
std::vector<oracle::TestSolid> all_solids(const oracle::Grid& grid, unsigned random_count, unsigned seed);

/// Some vertex lies on a plane through cells of a depth.
bool is_aligned(const osem::Solid& solid, int depth);

/// Some vertex is at an end of the lattice.
bool reaches_end(const osem::Solid& solid);

/// Reads a real mesh; throws when it is not there.
oracle::TriangleMesh real_mesh(const std::string& name, const oracle::Fit& fit);

} // namespace vectors

#endif
