#include "support/any_grid.hpp"

#include <algorithm>

namespace osem::fuzz {

namespace {

void fill(tests::DenseGrid& grid, std::size_t first, std::size_t count, Choices& choices) {
    const std::uint8_t block = choices.byte();
    if (count == 1 || block % 4 != 0) {
        constexpr Colour colours[] = {Colour::white, Colour::black, Colour::boundary, Colour::black};
        for (std::size_t i = 0; i < count; ++i) grid[first + i] = colours[block / 4 % 4];
        return;
    }
    for (std::size_t k = 0; k < 8; ++k) fill(grid, first + k * (count / 8), count / 8, choices);
}

} // namespace

tests::DenseGrid any_grid(int depth, Choices& choices) {
    tests::DenseGrid grid(depth);
    if (choices.done()) return grid;
    fill(grid, 0, grid.size(), choices);
    return grid;
}

Point any_cell(int bits, Choices& choices) {
    Point p = {};
    for (std::int32_t& at : p.at) {
        const std::uint8_t kind = choices.byte();
        at = kind % (1 << bits) * (root_side >> bits);
        if (kind >= 240) at = choices.between(0, root_side - 1);
        if (kind >= 200 && kind < 240) at += kind % 2 == 0 ? 1 : -1;
        at = std::clamp(at, 0, root_side - 1);
    }
    return p;
}

} // namespace osem::fuzz
