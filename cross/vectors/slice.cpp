// Trees by their leaves and slices of them, every pixel found by looking at its cells one by one.
#include "format.hpp"
#include "grid_leaves.hpp"
#include "random.hpp"
#include "support/slices.hpp"
#include "topics.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Slice;
using osem::Status;
using osem::tests::DenseGrid;

constexpr int slices = 12;

void put_rows(Bytes& body, const DenseGrid& grid, const Slice& slice) {
    const osem::tests::Rows rows = expected_rows(grid, slice);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (const bool inner : {false, true}) {
            for (const std::uint8_t byte : osem::tests::bits_of(rows[row], inner)) body.u8(byte);
        }
        const auto runs = osem::tests::runs_of(rows[row], static_cast<int>(row), true);
        body.u8(runs.size());
        for (const osem::PixelRun& run : runs) {
            body.u8(static_cast<std::uint64_t>(run.length));
            body.u8(static_cast<std::uint64_t>(run.colour));
        }
    }
}

class Writer {
  public:
    explicit Writer(VectorFile& file) : file_(file) {}

    /// A record of one tree.
    void add(const DenseGrid& grid) {
        Bytes body;
        put_grid(body, grid);
        body.u8(slices + 3);
        for (int i = 0; i < slices; ++i) {
            const auto level =
                static_cast<std::uint8_t>(i % 4 == 0 ? grid.depth() : random_.between(0, grid.depth()));
            put_slice(body, grid, {static_cast<osem::Axis>(i % 3), height(grid), level});
        }
        put_refusal(body, {osem::axis_x, -1, 0}, Status::point_off_root);
        put_refusal(body, {osem::axis_y, osem::root_side, 1}, Status::point_off_root);
        put_refusal(body, {osem::axis_z, 0, static_cast<std::uint8_t>(grid.depth() + 1)},
                    Status::level_out_of_range);
        file_.add_record(std::move(body));
    }

  private:
    // Often the first or the last cell of side 1 in a layer of the grid's cells.
    std::int32_t height(const DenseGrid& grid) {
        const std::int32_t at = random_.between(0, osem::root_side - 1);
        const std::int32_t first = at / grid.cell_side() * grid.cell_side();
        const int which = random_.below(3);
        if (which == 0) return at;
        return which == 1 ? first : first + grid.cell_side() - 1;
    }

    static void put_question(Bytes& body, const Slice& slice, Status status, std::size_t bytes) {
        body.u8(slice.axis);
        body.i32(slice.cell);
        body.u8(slice.level);
        body.u8(static_cast<std::uint64_t>(status));
        body.u16(bytes);
    }

    void put_slice(Bytes& body, const DenseGrid& grid, const Slice& slice) {
        Bytes rows;
        put_rows(rows, grid, slice);
        put_question(body, slice, Status::ok, rows.data().size());
        body.append(rows);
        const std::int32_t within = slice.cell % grid.cell_side();
        file_.tally().count(within == 0 || within == grid.cell_side() - 1,
                            slice.cell == 0 || slice.cell == osem::root_side - 1);
    }

    void put_refusal(Bytes& body, const Slice& slice, Status status) {
        put_question(body, slice, status, 0);
        file_.tally().count(false, status == Status::point_off_root);
    }

    VectorFile& file_;
    Random random_{41};
};

} // namespace

void write_slice(const std::string& folder) {
    VectorFile file(osem::cross::Topic::slice);
    Writer writer(file);
    for (const osem::Colour colour : osem::tests::three_colours) writer.add(DenseGrid(1, colour));
    for (std::uint32_t seed = 0; seed < 160; ++seed) writer.add(osem::tests::grid_of(3000 + seed));
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
