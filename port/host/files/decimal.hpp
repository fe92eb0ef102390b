// Decimal numbers of the command line and of reports; the locale has no say in them.
#ifndef OSEM_HOST_DECIMAL_HPP
#define OSEM_HOST_DECIMAL_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/quantize.hpp"

namespace osem::host {

/// The numbers of a comma-separated list; none unless there are exactly `count`, all finite, and nothing
/// else. Minus zero becomes zero.
bool parse_decimals(std::string_view text, double* values, std::size_t count);

/// The shortest decimal that reads back as the same binary64.
std::string decimal(double value);

/// Several of them, in the syntax of parse_decimals.
std::string decimals(const double* values, std::size_t count);

/// "X,Y,Z,SIDE", the syntax of --frame.
std::string frame_text(const WorldCube& cube);

/// The cube of a --frame value; none when it is malformed or no cube (see is_cube).
std::optional<WorldCube> parse_frame(std::string_view text);

/// Whether every coordinate of the cube is finite and its side is above 0.
bool is_cube(const WorldCube& cube);

} // namespace osem::host

#endif
