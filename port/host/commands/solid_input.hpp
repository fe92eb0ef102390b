// A mesh file as a solid that the kernel takes.
#ifndef OSEM_HOST_SOLID_INPUT_HPP
#define OSEM_HOST_SOLID_INPUT_HPP

#include <optional>
#include <string>

#include "mesh/quantize.hpp"

namespace osem::host {

/// Reads a mesh and puts it on the lattice of `cube`, or of the default cube. Refusals name the file.
IntegerSolid read_solid(const std::string& path, const std::optional<WorldCube>& cube);

/// The solid, checked; it is only viewed. Refusals name the file.
CheckedSolid check_solid(const std::string& path, const IntegerSolid& solid);

} // namespace osem::host

#endif
