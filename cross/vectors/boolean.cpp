// Pairs of solids and the trees of their combinations, combined on CGAL's cells.
#include <algorithm>
#include <map>
#include <memory>

#include "cell_grid.hpp"
#include "format.hpp"
#include "sources.hpp"
#include "topics.hpp"
#include "tree_truth.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::LeafRule;
using osem::WindingRule;

// A solid and its cells at the depths asked for so far.
class Source {
  public:
    explicit Source(osem::Solid solid) : solid_(solid), exact_(std::make_unique<oracle::ExactSolid>(solid)) {}

    const osem::Solid& solid() const { return solid_; }

    ColouredCells cells(const osem::ConvertOptions& options) {
        const auto found = grids_.find(options.depth);
        const auto& grid =
            found != grids_.end()
                ? found->second
                : grids_.try_emplace(options.depth, *exact_, osem::root_octant, options.depth).first->second;
        return coloured(grid, options.leaves, options.winding);
    }

  private:
    osem::Solid solid_;
    std::unique_ptr<oracle::ExactSolid> exact_;
    std::map<int, oracle::CellGrid> grids_;
};

// The same colours on the cells of a greater depth.
ColouredCells refined(const ColouredCells& cells, int depth) {
    ColouredCells fine{cells.window, depth, {}};
    const std::size_t parts = std::size_t{1} << (3 * (depth - cells.depth));
    for (const Colour colour : cells.colours) fine.colours.insert(fine.colours.end(), parts, colour);
    return fine;
}

ColouredCells combined(std::uint8_t operation, const ColouredCells& a, const ColouredCells& b) {
    if (operation == osem::cross::operation_complement) {
        ColouredCells result = a;
        for (Colour& c : result.colours) c = oracle::combined(osem::Operator::subtract, Colour::black, c);
        return result;
    }
    const int depth = std::max(a.depth, b.depth);
    ColouredCells result = refined(a, depth);
    const ColouredCells other = refined(b, depth);
    for (std::size_t i = 0; i < result.colours.size(); ++i) {
        result.colours[i] =
            oracle::combined(static_cast<osem::Operator>(operation), result.colours[i], other.colours[i]);
    }
    return result;
}

class BooleanWriter {
  public:
    explicit BooleanWriter(VectorFile& file) : file_(file) {}

    /// A record for either leaf rule.
    void add(Source& a, int depth_a, Source& b, int depth_b, WindingRule winding) {
        for (const auto rule : {LeafRule::conservative, LeafRule::centre}) {
            add_record(a, {depth_a, rule, winding}, b, {depth_b, rule, winding});
        }
    }

  private:
    void add_record(Source& a, const osem::ConvertOptions& options_a, Source& b,
                    const osem::ConvertOptions& options_b) {
        const ColouredCells cells_a = a.cells(options_a);
        const ColouredCells cells_b = b.cells(options_b);
        const bool degenerate =
            is_aligned(a.solid(), options_a.depth) || is_aligned(b.solid(), options_b.depth);
        const bool extreme = reaches_end(a.solid()) || reaches_end(b.solid());
        Bytes rows;
        std::uint32_t most_nodes = 0;
        for (std::uint8_t operation = 0; operation < osem::cross::operation_count; ++operation) {
            const TreeTruth truth(combined(operation, cells_a, cells_b));
            most_nodes = std::max(most_nodes, truth.pool_nodes());
            rows.u8(operation);
            truth.put(rows, options_a.leaves, random_);
            file_.tally().count(degenerate, extreme);
        }
        Bytes body;
        body.u32(TreeTruth(cells_a).pool_nodes() + TreeTruth(cells_b).pool_nodes() + most_nodes);
        body.options(options_a);
        body.solid(a.solid());
        body.options(options_b);
        body.solid(b.solid());
        body.u8(osem::cross::operation_count);
        body.append(rows);
        file_.add_record(std::move(body));
    }

    VectorFile& file_;
    Random random_{18};
};

// Each solid with another one, some with themselves; operands of different depths among them.
void add_pairs(BooleanWriter& writer, std::vector<Source>& sources) {
    constexpr int depths[][2] = {{3, 3}, {4, 4}, {3, 4}, {4, 2}};
    constexpr WindingRule windings[] = {WindingRule::nonzero, WindingRule::odd, WindingRule::positive};
    const std::size_t count = sources.size();
    for (std::size_t i = 0; i < count; ++i) {
        Source& other = sources[i % 10 == 9 ? i : (5 * i + 11) % count];
        const int* depth = depths[i % 4];
        writer.add(sources[i], depth[0], other, depth[1], windings[i % 3]);
        if (i % 6 == 0) writer.add(sources[i], 5, sources[(i + 7) % count], 5, WindingRule::nonzero);
    }
}

void add_meshes(BooleanWriter& writer) {
    const oracle::TriangleMesh first = real_mesh("elephant", oracle::whole_root);
    const oracle::TriangleMesh second = real_mesh("rotor", oracle::Fit{{{200003, 150001, 99991}}, 700001});
    Source a(first.view());
    Source b(second.view());
    writer.add(a, 6, b, 6, WindingRule::nonzero);
    writer.add(b, 5, a, 6, WindingRule::nonzero);
}

} // namespace

void write_boolean(const std::string& folder) {
    VectorFile file(osem::cross::Topic::boolean);
    BooleanWriter writer(file);
    std::vector<oracle::TestSolid> solids = all_solids(oracle::aligned_grid, 16, 7000);
    for (oracle::TestSolid& solid : all_solids(oracle::crooked_grid, 16, 7100)) {
        solids.push_back(std::move(solid));
    }
    std::vector<Source> sources;
    for (const oracle::TestSolid& solid : solids) sources.emplace_back(solid.view());
    add_pairs(writer, sources);
    add_meshes(writer);
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
