#include "mesh/coordinates.hpp"

#include <charconv>

namespace osem::host {

std::string to_text(const std::array<double, 3>& point) {
    std::string text = "(";
    for (std::size_t axis = 0; axis < 3; ++axis) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, point[axis]).ptr;
        text.append(axis == 0 ? "" : " ").append(digits, end);
    }
    return text + ")";
}

} // namespace osem::host
