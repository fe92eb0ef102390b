// Trees by their leaves, and what the surfaces of their solids have to be by their cells.
#include <cstdlib>
#include <random>

#include "format.hpp"
#include "grid_leaves.hpp"
#include "support/surface.hpp"
#include "support/surface_sheets.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::SolidPart;
using osem::tests::DenseGrid;

class Writer {
  public:
    explicit Writer(VectorFile& file) : file_(file) {}

    /// A record of one tree; each part is a case.
    void add(const DenseGrid& grid) {
        Bytes body;
        put_grid(body, grid);
        for (const SolidPart part : {SolidPart::inner, SolidPart::outer}) {
            put_surface(body, solid_cells(grid, part));
        }
        file_.add_record(std::move(body));
    }

  private:
    void put_surface(Bytes& body, const DenseGrid& solid) {
        std::uint64_t faces[6] = {};
        std::uint64_t squares[6] = {};
        for (const osem::tests::UnitFaces& face : expected_faces(solid)) {
            const auto [x, y, z, axis, positive] = *face.begin();
            const int facing = 2 * axis + (positive ? 1 : 0);
            ++faces[facing];
            squares[facing] += face.size();
        }
        for (int facing = 0; facing < 6; ++facing) {
            body.u16(faces[facing]);
            body.u16(squares[facing]);
        }
        std::uint64_t cells = 0;
        for (std::size_t cell = 0; cell < solid.size(); ++cell) {
            cells += solid[cell] == Colour::black ? 1U : 0U;
        }
        const osem::tests::SheetCounts counts = count_sheets(solid);
        body.u32(cells);
        body.i32(counts.euler);
        body.u32(counts.vertices);
        file_.tally().count(counts.vertices > 8, solid[0] == Colour::black);
    }

    VectorFile& file_;
};

// All solids of eight cells, with boundary cells beside them.
void add_eights(Writer& writer) {
    for (unsigned mask = 0; mask < 256; ++mask) {
        DenseGrid grid(1);
        const unsigned more = 37 * mask + 11;
        for (unsigned cell = 0; cell < 8; ++cell) {
            if (((mask >> cell) & 1U) != 0) {
                grid[cell] = Colour::black;
            } else if (((more >> cell) & 1U) != 0) {
                grid[cell] = Colour::boundary;
            }
        }
        writer.add(grid);
    }
}

// Cell by cell: all that touches in edges and corners only.
void add_cells(Writer& writer) {
    std::mt19937 random(62);
    for (unsigned round = 0; round < 24; ++round) {
        DenseGrid grid(round % 6 == 5 ? 3 : 2);
        const unsigned density = 1 + round % (grid.depth() == 2 ? 4 : 15);
        for (std::size_t cell = 0; cell < grid.size(); ++cell) {
            const bool is_solid = random() % 16 < density;
            if (is_solid) grid[cell] = random() % 2 == 0 ? Colour::black : Colour::boundary;
        }
        writer.add(grid);
    }
}

// Square rings around each other on a floor: holes in holes.
DenseGrid rings() {
    return osem::tests::make_grid(4, [](const osem::Point& p, std::int32_t side) {
        const int ring = std::max(std::abs(2 * (p.x() / side) - 15), std::abs(2 * (p.y() / side) - 15)) / 2;
        const int z = p.z() / side;
        return z < 4 || (z < 6 && ring % 2 == 0) ? Colour::black : Colour::white;
    });
}

// Slabs joined by two columns that share an edge: both of its copies run from one vertex to one other.
DenseGrid columns() {
    return osem::tests::make_grid(2, [](const osem::Point& p, std::int32_t side) {
        const int x = p.x() / side;
        const int y = p.y() / side;
        const int z = p.z() / side;
        const bool column = z == 1 && x == y && (x == 1 || x == 2);
        return z == 0 || z == 2 || column ? Colour::black : Colour::white;
    });
}

} // namespace

void write_surface(const std::string& folder) {
    VectorFile file(osem::cross::Topic::surface);
    Writer writer(file);
    for (const Colour colour : osem::tests::three_colours) writer.add(DenseGrid(1, colour));
    add_eights(writer);
    for (std::uint32_t seed = 0; seed < 64; ++seed) {
        const int depth = seed % 4 == 3 ? 3 : 2;
        writer.add(osem::tests::random_grid(depth, 6000 + seed, osem::tests::three_colours));
    }
    add_cells(writer);
    writer.add(rings());
    writer.add(columns());
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
