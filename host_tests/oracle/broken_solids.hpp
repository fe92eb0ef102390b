// Solids broken on purpose, and whether a face is planar by CGAL's word.
#ifndef OSEM_ORACLE_BROKEN_SOLIDS_HPP
#define OSEM_ORACLE_BROKEN_SOLIDS_HPP

#include <cstdint>

#include "osem/solid.hpp"
#include "solids.hpp"

namespace oracle {

/// The solid without one of its faces, or with that face turned over.
TestSolid rebuilt(const TestSolid& solid, std::uint32_t changed, bool turned);

/// Whether all corners of the face are on one plane or line.
bool is_planar(const osem::Solid& solid, std::uint32_t face);

} // namespace oracle

#endif
