// Trees by their leaves, with measures and components found by brute force on their cells.
#include "grid_leaves.hpp"
#include "support/cell_measures.hpp"
#include "support/dense_grid.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::tests::CellComponents;
using osem::tests::CellSet;
using osem::tests::DenseGrid;

class Writer {
  public:
    explicit Writer(VectorFile& file) : file_(file) {}

    /// A record of one tree: its measures are a case, every labelling another.
    void add(const DenseGrid& grid) {
        Bytes body;
        put_grid(body, grid);
        put_solid(body, CellSet(grid, osem::inner_solid));
        put_solid(body, CellSet(grid, osem::outer_solid));
        count(grid);
        constexpr std::uint8_t sets[] = {osem::inner_solid, osem::outer_solid, osem::inner_void,
                                         osem::outer_void};
        body.u8(3 * sizeof sets);
        for (const std::uint8_t colours : sets) {
            for (const auto connectivity :
                 {osem::Connectivity::faces, osem::Connectivity::edges, osem::Connectivity::corners}) {
                put_components(body, grid, colours, connectivity);
                count(grid);
            }
        }
        file_.add_record(std::move(body));
    }

  private:
    // All cells lie on planes of octants, so nothing touches where it need not: only the border is an end.
    void count(const DenseGrid& grid) { file_.tally().count(false, grid[0] != Colour::white); }

    static void put_wide(Bytes& body, const osem::Wide& wide) {
        body.u64(wide.high);
        body.u64(wide.low);
    }

    static void put_solid(Bytes& body, const CellSet& set) {
        const osem::Moments m = cell_moments(set);
        body.u64(m.volume);
        for (const osem::Wide& first : m.first) put_wide(body, first);
        for (const osem::Wide& second : m.second) put_wide(body, second);
        const osem::SurfaceMeasures surface = cell_surface(set);
        for (const std::uint64_t area : surface.area) body.u64(area);
        body.i64(surface.euler_closed);
        body.i64(surface.euler_open);
    }

    static void put_components(Bytes& body, const DenseGrid& grid, std::uint8_t colours,
                               osem::Connectivity connectivity) {
        const CellComponents found = cell_components(grid, colours, connectivity);
        body.u8(colours);
        body.u8(static_cast<std::uint64_t>(connectivity));
        body.u32(found.components.size());
        for (const osem::Component& component : found.components) {
            body.u64(component.volume);
            body.point(component.box.low);
            body.point(component.box.high);
            body.u8(component.touches_border ? 1 : 0);
        }
    }

    VectorFile& file_;
};

} // namespace

void write_measure(const std::string& folder) {
    VectorFile file(osem::cross::Topic::measure);
    Writer writer(file);
    for (const Colour colour : osem::tests::three_colours) writer.add(DenseGrid(1, colour));
    for (std::uint32_t seed = 0; seed < 150; ++seed) writer.add(osem::tests::grid_of(seed));
    for (std::uint32_t seed = 0; seed < 80; ++seed) {
        writer.add(osem::tests::random_grid(3, 1000 + seed, osem::tests::two_colours));
    }
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
