#include "support/transforms.hpp"

#include <algorithm>

namespace osem::tests {

namespace {

// The cells of an octant of a depth, by their colours.
struct Counts {
    std::size_t white = 0;
    std::size_t boundary = 0;
    std::size_t black = 0;
};

Colour coarse_colour(const Counts& n, Coarse mode) {
    const bool all_white = n.boundary + n.black == 0;
    const bool all_black = n.boundary + n.white == 0;
    if (mode == Coarse::inner) return all_black ? Colour::black : Colour::white;
    if (mode == Coarse::outer) return all_white ? Colour::white : Colour::black;
    if (mode == Coarse::majority) return n.black > n.white ? Colour::black : Colour::white;
    return all_white ? Colour::white : all_black ? Colour::black : Colour::boundary;
}

// Of a range of whole steps of the root's side / 2^bits.
std::int32_t steps(std::mt19937& random, int bits, std::int32_t low, std::int32_t high) {
    return (low + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(high - low + 1))) *
           (root_side >> bits);
}

} // namespace

bool holds(const CellBox& box, const Point& cell) {
    for (int axis = 0; axis < 3; ++axis) {
        if (cell.at[axis] < box.low.at[axis] || cell.at[axis] >= box.high.at[axis]) return false;
    }
    return true;
}

Point minus(const Point& a, const Point& b) {
    return {{a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]}};
}
Point plus(const Point& a, const Point& b) {
    return {{a.at[0] + b.at[0], a.at[1] + b.at[1], a.at[2] + b.at[2]}};
}

DenseGrid placed(const DenseGrid& grid, const Placement& placement, int depth) {
    return make_grid(depth, [&](const Point& corner, std::int32_t) {
        const Point source = minus(corner, placement.by);
        return holds(whole_root, source) && holds(placement.keep, corner) ? grid.at(source) : Colour::white;
    });
}

int exact_depth(const DenseGrid& grid, const Placement& placement) {
    int depth = grid.depth();
    for (int axis = 0; axis < 3; ++axis) {
        for (const std::int32_t at :
             {placement.by.at[axis], placement.keep.low.at[axis], placement.keep.high.at[axis]}) {
            while (at % (root_side >> depth) != 0) ++depth;
        }
    }
    return depth;
}

bool leaves_root(const DenseGrid& grid, const Point& by) {
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
        if (grid[cell] == Colour::white) continue;
        const Point low = plus(grid.corner(cell), by);
        for (const std::int32_t at : low.at) {
            if (at < 0 || at > root_side - grid.cell_side()) return true;
        }
    }
    return false;
}

DenseGrid reoriented(const DenseGrid& grid, const Symmetry& symmetry) {
    const std::int32_t last = root_side - grid.cell_side();
    return make_grid(grid.depth(), [&](const Point& corner, std::int32_t) {
        Point source = {{0, 0, 0}};
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool flipped = ((unsigned{symmetry.flips} >> axis) & 1U) != 0;
            source.at[symmetry.from[axis]] = flipped ? last - corner.at[axis] : corner.at[axis];
        }
        return grid.at(source);
    });
}

// Cells of an octant stand side by side in Morton order.
DenseGrid coarse(const DenseGrid& grid, int depth, Coarse mode) {
    DenseGrid result(std::min(depth, grid.depth()));
    const std::size_t cells = grid.size() / result.size();
    for (std::size_t i = 0; i < result.size(); ++i) {
        Counts n;
        for (std::size_t cell = i * cells; cell < (i + 1) * cells; ++cell) {
            const Colour colour = grid[cell];
            ++(colour == Colour::white ? n.white : colour == Colour::black ? n.black : n.boundary);
        }
        result[i] = coarse_colour(n, mode);
    }
    return result;
}

DenseGrid enlarged_grid(const DenseGrid& grid, const Octant& octant) {
    return make_grid(std::max(1, grid.depth() - octant.level), [&](const Point& corner, std::int32_t) {
        Point source = octant.corner;
        for (int axis = 0; axis < 3; ++axis) source.at[axis] += corner.at[axis] >> octant.level;
        return grid.at(source);
    });
}

DenseGrid reduced_grid(const DenseGrid& grid, const Octant& octant) {
    const std::int32_t side = octant.side();
    const CellBox box = {octant.corner, plus(octant.corner, {{side, side, side}})};
    return make_grid(grid.depth() + octant.level, [&](const Point& corner, std::int32_t) {
        if (!holds(box, corner)) return Colour::white;
        Point source = minus(corner, octant.corner);
        for (std::int32_t& at : source.at) at <<= octant.level;
        return grid.at(source);
    });
}

Point random_vector(std::mt19937& random, int bits, std::int32_t most) {
    const std::int32_t x = steps(random, bits, -most, most);
    const std::int32_t y = steps(random, bits, -most, most);
    return {{x, y, random() % 3 == 0 ? 0 : steps(random, bits, -most, most)}};
}

CellBox random_box(std::mt19937& random, int bits) {
    CellBox box = whole_root;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t a = steps(random, bits, 0, (1 << bits) - 1);
        const std::int32_t b = steps(random, bits, 1, 1 << bits);
        box.low.at[axis] = std::min(a, b);
        box.high.at[axis] = a == b ? a + (root_side >> bits) : std::max(a, b);
    }
    return box;
}

} // namespace osem::tests
