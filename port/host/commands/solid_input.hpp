// A mesh file as a solid that the kernel takes, and the options that say how.
#ifndef OSEM_HOST_SOLID_INPUT_HPP
#define OSEM_HOST_SOLID_INPUT_HPP

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "mesh/quantize.hpp"
#include "osem/convert.hpp"

namespace osem::host {

/// How a mesh becomes a solid.
struct SolidOptions {
    std::string frame;                  ///< empty: the default cube
    std::optional<WindingRule> winding; ///< none: as the mesh asks for
};

/// Adds --winding and --frame.
void add_solid_options(CLI::App& command, SolidOptions& options);

/// Reads a mesh and puts it on the lattice of the cube asked for. Refusals name the file.
IntegerSolid read_solid(const std::string& path, const SolidOptions& options);

/// Puts a mesh that was read from `path` on the lattice of a cube. Refusals name the file.
IntegerSolid solid_in(const WorldCube& cube, const std::string& path, const Mesh& mesh);

/// The winding rule asked for, or the one that suits the file: odd where it gives no orientation.
WindingRule winding_rule(const SolidOptions& options, const IntegerSolid& solid);

/// The solid, checked; it is only viewed. Refusals name the file.
CheckedSolid check_solid(const std::string& path, const IntegerSolid& solid);

} // namespace osem::host

#endif
