#include "support/slices.hpp"

#include <set>

namespace osem::tests {

namespace {

Colour pixel_of(const DenseGrid& grid, const Slice& slice, int row, int column) {
    const int cells = 1 << (grid.depth() - slice.level);
    std::set<Colour> seen;
    for (int v = row * cells; v < (row + 1) * cells; ++v) {
        for (int u = column * cells; u < (column + 1) * cells; ++u) {
            Point cell = {{slice.cell, slice.cell, slice.cell}};
            cell.at[slice_along[slice.axis]] = u * grid.cell_side();
            cell.at[slice_across[slice.axis]] = v * grid.cell_side();
            seen.insert(grid.at(cell));
        }
    }
    return seen.size() == 1 ? *seen.begin() : Colour::boundary;
}

} // namespace

Rows expected_rows(const DenseGrid& grid, const Slice& slice) {
    const int pixels = 1 << slice.level;
    Rows rows;
    for (int row = 0; row < pixels; ++row) {
        rows.emplace_back();
        for (int column = 0; column < pixels; ++column) {
            rows.back().push_back(pixel_of(grid, slice, row, column));
        }
    }
    return rows;
}

std::vector<PixelRun> runs_of(const Row& row, int number, bool white) {
    std::vector<PixelRun> runs;
    int start = 0;
    for (int i = 1; i <= static_cast<int>(row.size()); ++i) {
        const Colour colour = row[static_cast<std::size_t>(start)];
        if (i < static_cast<int>(row.size()) && row[static_cast<std::size_t>(i)] == colour) continue;
        if (white || colour != Colour::white) runs.push_back({number, start, i - start, colour});
        start = i;
    }
    return runs;
}

std::vector<std::uint8_t> bits_of(const Row& row, bool inner) {
    std::vector<std::uint8_t> bytes((row.size() + 7) / 8);
    for (std::size_t i = 0; i < row.size(); ++i) {
        const bool set = inner ? row[i] == Colour::black : row[i] != Colour::white;
        if (set) bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | (0x80 >> (i % 8)));
    }
    return bytes;
}

} // namespace osem::tests
