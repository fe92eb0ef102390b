#include "support/cell_measures.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace osem::tests {

namespace {

using Cell = std::array<int, 3>;

Cell cell_at(const Point& corner, std::int32_t side) {
    return {corner.x() / side, corner.y() / side, corner.z() / side};
}

std::uint64_t cube(std::uint64_t n) { return n * n * n; }

unsigned log2_of(std::int32_t side) {
    unsigned bits = 0;
    while ((side >> bits) > 1) ++bits;
    return bits;
}

template <class Visit>
void for_each_cell(const CellSet& set, const Visit& visit) {
    for (int z = 0; z < set.side(); ++z) {
        for (int y = 0; y < set.side(); ++y) {
            for (int x = 0; x < set.side(); ++x) {
                if (set.has(x, y, z)) visit(Cell{x, y, z});
            }
        }
    }
}

} // namespace

CellSet::CellSet(const DenseGrid& grid, std::uint8_t colours)
    : side_(1 << grid.depth()), outside_((colours & colour_bit(Colour::white)) != 0), cells_(grid.size()) {
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Cell c = cell_at(grid.corner(i), grid.cell_side());
        const bool counts = (colours & colour_bit(grid[i])) != 0;
        cells_[static_cast<std::size_t>((c[2] * side_ + c[1]) * side_ + c[0])] = counts ? 1 : 0;
    }
}

bool CellSet::has(int x, int y, int z) const {
    const auto inside = [this](int at) { return at >= 0 && at < side_; };
    if (!inside(x) || !inside(y) || !inside(z)) return outside_;
    return cells_[static_cast<std::size_t>((z * side_ + y) * side_ + x)] != 0;
}

Wide shifted(std::uint64_t value, unsigned shift) {
    Wide wide = {0, value};
    for (; shift > 0; --shift) wide = Wide{2 * wide.high + (wide.low >> 63), 2 * wide.low};
    return wide;
}

// Sums in units of the grid's cells, scaled at the end: integrals of degree n have the unit side^(3 + n).
Moments cell_moments(const CellSet& set) {
    std::uint64_t volume = 0;
    std::uint64_t first[3] = {};
    std::uint64_t second[6] = {};
    for_each_cell(set, [&](const Cell& c) {
        ++volume;
        for (unsigned a = 0; a < 3; ++a) {
            const auto x = static_cast<std::uint64_t>(c[a]);
            const auto y = static_cast<std::uint64_t>(c[(a + 1) % 3]);
            first[a] += (x + 1) * (x + 1) - x * x;
            second[a] += 4 * (cube(x + 1) - cube(x));
            second[3 + a] += 3 * ((x + 1) * (x + 1) - x * x) * ((y + 1) * (y + 1) - y * y);
        }
    });
    const unsigned bits = log2_of(set.cell_side());
    Moments m = {};
    m.volume = volume << (3 * bits);
    for (unsigned a = 0; a < 3; ++a) m.first[a] = shifted(first[a], 4 * bits);
    for (unsigned p = 0; p < 6; ++p) m.second[p] = shifted(second[p], 5 * bits);
    return m;
}

// On the lattice of twice the cells' coordinates a piece is a point: odd where it has extent.
SurfaceMeasures cell_surface(const CellSet& set) {
    SurfaceMeasures m = {};
    const int points = 2 * set.side() + 1;
    const auto area =
        static_cast<std::uint64_t>(set.cell_side()) * static_cast<std::uint64_t>(set.cell_side());
    for (int z = 0; z < points; ++z) {
        for (int y = 0; y < points; ++y) {
            for (int x = 0; x < points; ++x) {
                const Cell p = {x, y, z};
                int around = 0;
                int solid = 0;
                for (int i = 0; i < 8; ++i) {
                    Cell c = {};
                    bool twice = false;
                    for (unsigned a = 0; a < 3; ++a) {
                        const int high = (i >> a) & 1;
                        twice = twice || (p[a] % 2 == 1 && high == 1);
                        c[a] = p[a] % 2 == 1 ? p[a] / 2 : p[a] / 2 - 1 + high;
                    }
                    if (twice) continue;
                    ++around;
                    solid += set.has(c[0], c[1], c[2]) ? 1 : 0;
                }
                const int extents = x % 2 + y % 2 + z % 2;
                const int sign = extents % 2 == 0 ? 1 : -1;
                if (solid > 0) m.euler_closed += sign;
                if (solid == around) m.euler_open -= sign;
                if (around == 2 && solid == 1) m.area[x % 2 == 0 ? 0 : y % 2 == 0 ? 1 : 2] += area;
            }
        }
    }
    return m;
}

namespace {

bool are_neighbours(const Cell& offset, Connectivity connectivity) {
    const int axes = std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2]);
    return axes > 0 && axes <= static_cast<int>(connectivity);
}

// The cells and a ring around them.
class Flood {
  public:
    Flood(const CellSet& set, Connectivity connectivity)
        : set_(set), connectivity_(connectivity), width_(set.side() + 2),
          labels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(width_) *
                      static_cast<std::size_t>(width_),
                  no_component) {}

    std::uint32_t& label(const Cell& c) {
        return labels_[static_cast<std::size_t>(((c[2] + 1) * width_ + c[1] + 1) * width_ + c[0] + 1)];
    }

    void fill(const Cell& start, std::uint32_t label_given) {
        std::vector<Cell> open{start};
        label(start) = label_given;
        while (!open.empty()) {
            const Cell c = open.back();
            open.pop_back();
            for (int i = 0; i < 27; ++i) {
                const Cell offset = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
                const Cell to = {c[0] + offset[0], c[1] + offset[1], c[2] + offset[2]};
                const auto [low, high] = std::minmax({to[0], to[1], to[2]});
                if (!are_neighbours(offset, connectivity_) || low < -1 || high > set_.side()) continue;
                if (!set_.has(to[0], to[1], to[2]) || label(to) != no_component) continue;
                label(to) = label_given;
                open.push_back(to);
            }
        }
    }

  private:
    const CellSet& set_;
    Connectivity connectivity_;
    int width_;
    std::vector<std::uint32_t> labels_;
};

void add_cell(Component& component, const Point& corner, std::int32_t side) {
    const bool first = component.volume == 0;
    component.volume += cube(static_cast<std::uint64_t>(side));
    for (int a = 0; a < 3; ++a) {
        const std::int32_t low = corner.at[a];
        const std::int32_t high = low + side;
        component.box.low.at[a] = first ? low : std::min(low, component.box.low.at[a]);
        component.box.high.at[a] = first ? high : std::max(high, component.box.high.at[a]);
        component.touches_border = component.touches_border || low == 0 || high == root_side;
    }
}

} // namespace

CellComponents cell_components(const DenseGrid& grid, std::uint8_t colours, Connectivity connectivity) {
    const CellSet set(grid, colours);
    Flood flood(set, connectivity);
    CellComponents found;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Cell c = cell_at(grid.corner(i), grid.cell_side());
        if (set.has(c[0], c[1], c[2]) && flood.label(c) == no_component) {
            flood.fill(c, static_cast<std::uint32_t>(found.components.size()));
            found.components.push_back(Component{});
        }
        found.labels.push_back(flood.label(c));
        if (found.labels.back() != no_component) {
            add_cell(found.components[found.labels.back()], grid.corner(i), grid.cell_side());
        }
    }
    return found;
}

} // namespace osem::tests
