#include "files/decimal.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace osem::host {

bool parse_decimals(std::string_view text, double* values, std::size_t count) {
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return false;
        const auto [rest, error] = std::from_chars(at, end, values[i]);
        if (error != std::errc() || !std::isfinite(values[i])) return false;
        values[i] += 0.0; // turns -0 into 0, so that frames that are equal have equal bits
        at = rest;
    }
    return at == end;
}

std::string decimal(double value) {
    char text[32]; // the longest is "-2.2250738585072014e-308"
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    static_cast<void>(error); // only a short buffer is one
    return std::string(text, end);
}

std::string decimals(const double* values, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + decimal(values[i]);
    return text;
}

std::string frame_text(const WorldCube& cube) {
    return decimals(cube.origin.data(), cube.origin.size()) + ',' + decimal(cube.side);
}

std::optional<WorldCube> parse_frame(std::string_view text) {
    double numbers[4];
    if (!parse_decimals(text, numbers, 4)) return std::nullopt;
    const WorldCube cube{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
    if (!is_cube(cube)) return std::nullopt;
    return cube;
}

bool is_cube(const WorldCube& cube) {
    bool finite = cube.side > 0;
    for (const double coordinate : cube.origin) {
        finite = finite && std::isfinite(coordinate) && std::isfinite(coordinate + cube.side);
    }
    return finite;
}

} // namespace osem::host
