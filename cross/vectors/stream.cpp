// Pairs of streams laid out by hand, and their Booleans and queries by the colours of cells.
#include "format.hpp"
#include "grid_leaves.hpp"
#include "support/byte_stream.hpp"
#include "topics.hpp"
#include "tree_truth.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::LeafRule;
using osem::tests::DenseGrid;

constexpr int damages = 6;

ColouredCells cells_of(const DenseGrid& grid) {
    ColouredCells cells{osem::root_octant, grid.depth(), {}};
    for (std::size_t cell = 0; cell < grid.size(); ++cell) cells.colours.push_back(grid[cell]);
    return cells;
}

DenseGrid result_of(std::uint8_t operation, const DenseGrid& a, const DenseGrid& b) {
    if (operation == osem::cross::operation_complement) return complemented(a);
    return combined(static_cast<osem::Operator>(operation), a, b);
}

bool same_cells(const DenseGrid& a, const DenseGrid& b) {
    const int depth = std::max(a.depth(), b.depth());
    return refined(a, depth) == refined(b, depth);
}

class StreamWriter {
  public:
    explicit StreamWriter(VectorFile& file) : file_(file) {}

    void add(const DenseGrid& a, const DenseGrid& b, LeafRule rule) {
        Bytes body;
        const std::size_t size_a = put_stream(body, a, rule);
        const std::size_t size_b = put_stream(body, b, rule);
        body.u8(osem::cross::operation_count);
        for (std::uint8_t operation = 0; operation < osem::cross::operation_count; ++operation) {
            const DenseGrid result = result_of(operation, a, b);
            body.u8(operation);
            body.u8(same_cells(result, a) ? 1 : 0);
            TreeTruth(cells_of(result)).put(body, rule, random_);
            file_.tally().count(same_cells(result, a), a.depth() != b.depth());
        }
        body.u8(damages);
        for (int i = 0; i < damages; ++i) {
            put_damage(body, i % 2, i % 2 == 0 ? size_a : size_b);
        }
        file_.add_record(std::move(body));
    }

  private:
    static std::size_t put_stream(Bytes& body, const DenseGrid& grid, LeafRule rule) {
        osem::tests::StreamModel model(grid.depth(), preorder_masks(grid));
        model.leaf_rule = static_cast<std::uint8_t>(rule == LeafRule::centre ? 1 : 0);
        for (int i = 0; i < 4; ++i) model.frame[i] = osem::cross::stream_frame[i];
        const osem::tests::Bytes stream = model.bytes();
        body.u32(stream.size());
        for (const std::uint8_t byte : stream) body.u8(byte);
        return stream.size();
    }

    // One bit turned over: a checksum of 32 bits sees it wherever it is.
    void put_damage(Bytes& body, int operand, std::size_t size) {
        const int byte = random_.below(static_cast<int>(size));
        body.u8(static_cast<std::uint64_t>(operand));
        body.u32(static_cast<std::uint64_t>(byte));
        body.u8(static_cast<std::uint64_t>(random_.below(8)));
        file_.tally().count(false, byte == 0 || static_cast<std::size_t>(byte) + 1 == size);
    }

    VectorFile& file_;
    Random random_{51};
};

} // namespace

void write_stream(const std::string& folder) {
    VectorFile file(osem::cross::Topic::stream);
    StreamWriter writer(file);
    for (const Colour a : osem::tests::three_colours) {
        for (const Colour b : osem::tests::three_colours) {
            writer.add(DenseGrid(1, a), DenseGrid(2, b), LeafRule::conservative);
        }
        const DenseGrid grid = osem::tests::random_grid(2, 9, osem::tests::three_colours);
        writer.add(grid, DenseGrid(1, a), LeafRule::conservative);
        writer.add(DenseGrid(1, a), grid, LeafRule::conservative);
    }
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        const bool centre = seed % 3 == 0;
        const auto& palette = centre ? osem::tests::two_colours : osem::tests::three_colours;
        const int depth = 1 + static_cast<int>(seed % 4);
        const DenseGrid a = osem::tests::random_grid(depth, 4000 + seed, palette);
        const DenseGrid b =
            osem::tests::random_grid(1 + static_cast<int>(seed / 4 % 3), 4500 + seed, palette);
        writer.add(a, seed % 10 == 9 ? a : b, centre ? LeafRule::centre : LeafRule::conservative);
    }
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
