#include "cell_grid.hpp"

#include <algorithm>

namespace oracle {

namespace {

// Where an octant's cells stand in the array of a window's cells: in Morton order an octant is one run.
struct Run {
    std::size_t first;
    std::size_t count;
};

Run run_of(const osem::Octant& octant, const osem::Octant& window, int depth) {
    const int cell_shift = osem::lattice_bits - depth;
    std::size_t first = 0;
    for (int bit = 0; bit < depth - window.level; ++bit) {
        for (int axis = 0; axis < 3; ++axis) {
            const int offset = (octant.corner.at[axis] - window.corner.at[axis]) >> (cell_shift + bit);
            first |= static_cast<std::size_t>(offset & 1) << (3 * bit + axis);
        }
    }
    return {first, std::size_t{1} << (3 * (depth - octant.level))};
}

bool contains(const osem::Octant& outer, const osem::Octant& inner) {
    if (outer.level > inner.level) return false;
    for (int axis = 0; axis < 3; ++axis) {
        const int offset = inner.corner.at[axis] - outer.corner.at[axis];
        if (offset < 0 || offset >= outer.side()) return false;
    }
    return true;
}

} // namespace

CellGrid::CellGrid(const ExactSolid& solid, const osem::Octant& window, int depth)
    : window_(window), depth_(depth), cells_(std::size_t{1} << (3 * (depth - window.level))) {
    fill(solid, window);
}

void CellGrid::fill(const ExactSolid& solid, const osem::Octant& octant) {
    const Run run = run_of(octant, window_, depth_);
    if (!solid.meets_open(octant)) {
        std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(run.first), run.count,
                    Cell{false, solid.winding(centre_of(octant))});
    } else if (octant.level == depth_) {
        // A cell of side 1 has no centre on the lattice, and no centre rule either.
        const int winding = octant.side() == 1 ? 0 : solid.winding(perturbed_centre_of(octant));
        cells_[run.first] = Cell{true, winding};
    } else {
        for (unsigned k = 0; k < 8; ++k) fill(solid, octant.child(k));
    }
}

osem::Colour colour_of(const Cell& cell, osem::LeafRule leaves, osem::WindingRule winding) {
    if (cell.met && leaves == osem::LeafRule::conservative) return osem::Colour::boundary;
    bool inside = false;
    switch (winding) {
    case osem::WindingRule::nonzero:
        inside = cell.winding != 0;
        break;
    case osem::WindingRule::odd:
        inside = cell.winding % 2 != 0;
        break;
    case osem::WindingRule::positive:
        inside = cell.winding > 0;
        break;
    }
    return inside ? osem::Colour::black : osem::Colour::white;
}

osem::Colour combined(osem::Operator op, osem::Colour a, osem::Colour b) {
    using osem::Colour;
    const auto negated = [](Colour c) {
        return c == Colour::white ? Colour::black : c == Colour::black ? Colour::white : c;
    };
    const auto either = [](Colour x, Colour y) {
        if (x == Colour::black || y == Colour::black) return Colour::black;
        return x == Colour::white && y == Colour::white ? Colour::white : Colour::boundary;
    };
    const auto both = [&](Colour x, Colour y) { return negated(either(negated(x), negated(y))); };
    switch (op) {
    case osem::Operator::unite:
        return either(a, b);
    case osem::Operator::intersect:
        return both(a, b);
    case osem::Operator::subtract:
        return both(a, negated(b));
    case osem::Operator::exclusive_or:
        break;
    }
    return either(both(a, negated(b)), both(b, negated(a)));
}

Report compare(const osem::Octree& tree, const osem::Octant& window, int depth, const CellColour& expected) {
    Report report;
    const auto blame = [&](const osem::Leaf& leaf, osem::Colour colour, const std::string& what) {
        ++report.wrong_leaves;
        if (!report.first.empty()) return;
        report.first = "leaf " + in_words(leaf.octant) + " is " + name_of(leaf.colour) + ", expected " +
                       name_of(colour) + what;
    };
    std::uint64_t volume = 0;
    std::vector<bool> seen(std::size_t{1} << (3 * (depth - window.level)));
    osem::LeafWalk walk(tree);
    for (osem::Leaf leaf{}; walk.next(leaf);) {
        ++report.leaves;
        volume += osem::volume_at(leaf.octant.level);
        if (leaf.octant.level > depth) {
            blame(leaf, osem::Colour::grey, ": smaller than the depth allows");
            continue;
        }
        const bool outside = !contains(window, leaf.octant);
        if (outside && leaf.colour != osem::Colour::white) blame(leaf, osem::Colour::white, ": outside");
        if (outside && !contains(leaf.octant, window)) continue;
        const Run run = outside ? Run{0, seen.size()} : run_of(leaf.octant, window, depth);
        report.cells += run.count;
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            if (seen[i]) blame(leaf, leaf.colour, ": a cell in two leaves");
            seen[i] = true;
            if (const osem::Colour colour = expected(i); colour != leaf.colour) {
                blame(leaf, colour, " in its cell " + std::to_string(i));
                break;
            }
        }
    }
    if (report.good() && volume != osem::root_volume) report.first = "the leaves do not tile the root";
    if (report.good() && report.cells != seen.size()) report.first = "a cell in no leaf";
    return report;
}

Report compare(const osem::Octree& tree, const CellGrid& grid, const osem::ConvertOptions& options) {
    return compare(tree, grid.window(), grid.depth(),
                   [&](std::size_t i) { return colour_of(grid[i], options.leaves, options.winding); });
}

const char* name_of(osem::Colour colour) {
    constexpr const char* names[] = {"white", "boundary", "grey", "black"};
    return names[static_cast<unsigned>(colour)];
}

const char* name_of(osem::LeafRule rule) {
    return rule == osem::LeafRule::conservative ? "conservative" : "centre";
}

const char* name_of(osem::WindingRule rule) {
    constexpr const char* names[] = {"nonzero", "odd", "positive"};
    return names[static_cast<unsigned>(rule)];
}

const char* name_of(osem::Operator op) {
    constexpr const char* names[] = {"unite", "intersect", "subtract", "exclusive or"};
    return names[static_cast<unsigned>(op)];
}

std::string in_words(const osem::Octant& octant) {
    return "(" + std::to_string(octant.corner.x()) + ", " + std::to_string(octant.corner.y()) + ", " +
           std::to_string(octant.corner.z()) + ") of level " + std::to_string(octant.level);
}

} // namespace oracle
