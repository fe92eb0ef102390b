// World coordinates of the command line, and lattice answers as text.
#ifndef OSEM_HOST_COMMANDS_WORLD_POINT_HPP
#define OSEM_HOST_COMMANDS_WORLD_POINT_HPP

#include <array>
#include <string>

#include <CLI/CLI.hpp>

#include "mesh/quantize.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"

namespace osem::host {

using Coordinates = std::array<double, 3>;

/// Adds an argument or option "X,Y,Z".
CLI::Option* add_coordinates(CLI::App& command, const std::string& name, Coordinates& target,
                             const std::string& help);

enum class Rounding { down, nearest, up };

/// The lattice point of a world point: (world - origin) * 2^20 / side, rounded; nearest has halves upwards,
/// as conversion has. Throws BadInput where a coordinate is past 2^29.
Point on_lattice(const Coordinates& world, const WorldCube& cube, Rounding rounding);

/// "x y z".
std::string point_text(const Point& point);

/// "x y z side colour", as osem leaves prints it; the colour may be grey.
std::string leaf_text(const Leaf& leaf);

std::string colour_name(Colour colour);

/// Throws BadInput unless the status is ok.
void require_ok(Status status);

} // namespace osem::host

#endif
