#include "support/surface_sheets.hpp"

#include <array>
#include <vector>

namespace osem::tests {

namespace {

// What is around a point of the lattice: eight cells, bit a of a cell's number saying that it is on the high
// side along axis a, and the squares between cells that differ. A square is named by its axis and its cell on
// the low side.
class Star {
  public:
    explicit Star(const std::array<bool, 8>& solid) : solid_(solid) {
        for (std::size_t square = 0; square < parent_.size(); ++square) parent_[square] = square;
        for (unsigned axis = 0; axis < 3; ++axis) {
            for (const unsigned high : {0U, 1U}) join_around_edge(axis, high);
        }
    }

    int quarters() const;                ///< squares, of each of which one corner is here
    int edges() const { return edges_; } ///< edges that end here
    int sheets() const;
    std::uint32_t vertices() const;

  private:
    static std::size_t square_of(unsigned axis, unsigned cell) { return 8 * axis + (cell & ~(1U << axis)); }
    bool is_surface(unsigned axis, unsigned cell) const {
        return solid_[cell] != solid_[cell ^ (1U << axis)];
    }
    std::size_t sheet_of(std::size_t square) const {
        while (parent_[square] != square) square = parent_[square];
        return square;
    }
    void join(std::size_t a, std::size_t b);
    void join_around_edge(unsigned axis, unsigned high);
    template <class Visit>
    void for_every_square(const Visit& visit) const;

    std::array<bool, 8> solid_;
    std::array<std::size_t, 24> parent_ = {};
    std::vector<std::size_t> bends_; ///< a square of each bend
    int edges_ = 0;
};

template <class Visit>
void Star::for_every_square(const Visit& visit) const {
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (unsigned cell = 0; cell < 8; ++cell) {
            if (((cell >> axis) & 1U) == 0 && is_surface(axis, cell)) visit(square_of(axis, cell));
        }
    }
}

void Star::join(std::size_t a, std::size_t b) {
    ++edges_;
    if (a / 8 != b / 8) bends_.push_back(a);
    parent_[sheet_of(a)] = sheet_of(b);
}

void Star::join_around_edge(unsigned axis, unsigned high) {
    const unsigned u = (axis + 1) % 3;
    const unsigned v = (axis + 2) % 3;
    std::vector<std::size_t> squares;
    for (unsigned cell = 0; cell < 8; ++cell) {
        if (((cell >> axis) & 1U) != high) continue;
        for (const unsigned across : {u, v}) {
            if (((cell >> across) & 1U) == 0 && is_surface(across, cell)) {
                squares.push_back(square_of(across, cell));
            }
        }
    }
    if (squares.size() == 2) join(squares[0], squares[1]);
    if (squares.size() < 4) return;
    for (unsigned cell = 0; cell < 8; ++cell) {
        const bool at_edge = ((cell >> axis) & 1U) == high;
        if (at_edge && solid_[cell]) join(square_of(u, cell), square_of(v, cell));
    }
}

int Star::quarters() const {
    int count = 0;
    for_every_square([&count](std::size_t) { ++count; });
    return count;
}

int Star::sheets() const {
    int count = 0;
    for_every_square([&](std::size_t square) { count += parent_[square] == square ? 1 : 0; });
    return count;
}

std::uint32_t Star::vertices() const {
    std::array<unsigned, 24> bends = {};
    for (const std::size_t square : bends_) ++bends[sheet_of(square)];
    std::uint32_t count = 0;
    for (const unsigned n : bends) count += n > 2 ? 1U : 0U;
    return count;
}

} // namespace

SheetCounts count_sheets(const DenseGrid& solid) {
    const int cells = 1 << solid.depth();
    const auto is_solid = [&](int x, int y, int z) {
        for (const int at : {x, y, z}) {
            if (at < 0 || at >= cells) return false;
        }
        const std::int32_t side = solid.cell_side();
        return solid.at({{x * side, y * side, z * side}}) == Colour::black;
    };
    SheetCounts counts;
    std::int64_t edge_ends = 0;
    std::int64_t quarters = 0;
    for (int z = 0; z <= cells; ++z) {
        for (int y = 0; y <= cells; ++y) {
            for (int x = 0; x <= cells; ++x) {
                std::array<bool, 8> around = {};
                for (int k = 0; k < 8; ++k) {
                    around[static_cast<std::size_t>(k)] =
                        is_solid(x - 1 + k % 2, y - 1 + k / 2 % 2, z - 1 + k / 4);
                }
                const Star star(around);
                counts.euler += star.sheets();
                counts.vertices += star.vertices();
                edge_ends += star.edges();
                quarters += star.quarters();
            }
        }
    }
    counts.euler += quarters / 4 - edge_ends / 2;
    return counts;
}

} // namespace osem::tests
