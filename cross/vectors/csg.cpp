// Expressions over solids and random trees: CGAL's colours of the cells, and every value tried on them.
#include <algorithm>
#include <random>

#include "cell_grid.hpp"
#include "format.hpp"
#include "grid_leaves.hpp"
#include "sources.hpp"
#include "support/expressions.hpp"
#include "topics.hpp"
#include "tree_truth.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::CsgToken;
using osem::CsgTokenKind;
using osem::LeafRule;
using osem::WindingRule;
using osem::tests::DenseGrid;
using osem::tests::Tokens;

constexpr unsigned operands = 4; // two solids, two trees
constexpr std::uint8_t rows = 6;

std::uint8_t encoded(const CsgToken& token) {
    if (token.kind == CsgTokenKind::operand) return token.operand;
    if (token.kind == CsgTokenKind::complement) return osem::cross::token_complement;
    return static_cast<std::uint8_t>(osem::cross::token_combine + static_cast<int>(token.op));
}

class CsgWriter {
  public:
    explicit CsgWriter(VectorFile& file) : file_(file) {}

    /// A record for either leaf rule.
    void add(const oracle::TestSolid& a, const oracle::TestSolid& b, int depth, std::uint32_t seed) {
        constexpr WindingRule windings[] = {WindingRule::nonzero, WindingRule::odd, WindingRule::positive};
        const WindingRule winding = windings[seed % 3];
        const oracle::CellGrid cells_a(oracle::ExactSolid(a.view()), osem::root_octant, depth);
        const oracle::CellGrid cells_b(oracle::ExactSolid(b.view()), osem::root_octant, depth);
        degenerate_ = is_aligned(a.view(), depth) || is_aligned(b.view(), depth);
        extreme_ = reaches_end(a.view()) || reaches_end(b.view());
        for (const LeafRule rule : {LeafRule::conservative, LeafRule::centre}) {
            const auto& palette =
                rule == LeafRule::centre ? osem::tests::two_colours : osem::tests::three_colours;
            const DenseGrid c = osem::tests::random_grid(depth, seed, palette);
            const DenseGrid d = osem::tests::random_grid(depth - 1, seed + 500, palette);
            Bytes body;
            body.options({depth, rule, winding});
            body.u8(operands);
            put_solid(body, a);
            put_solid(body, b);
            put_tree(body, c);
            put_tree(body, d);
            put_rows(body, rule,
                     {coloured(cells_a, rule, winding).colours, coloured(cells_b, rule, winding).colours,
                      colours_of(c), colours_of(osem::tests::refined(d, depth))},
                     depth);
            file_.add_record(std::move(body));
        }
    }

  private:
    using Colours = std::vector<Colour>;

    static void put_solid(Bytes& body, const oracle::TestSolid& solid) {
        body.u8(osem::cross::operand_solid);
        body.solid(solid.view());
    }
    static void put_tree(Bytes& body, const DenseGrid& grid) {
        body.u8(osem::cross::operand_tree);
        put_grid(body, grid);
    }
    static Colours colours_of(const DenseGrid& grid) {
        Colours colours;
        for (std::size_t cell = 0; cell < grid.size(); ++cell) colours.push_back(grid[cell]);
        return colours;
    }

    void put_rows(Bytes& body, LeafRule rule, const std::vector<Colours>& operand_colours, int depth) {
        Bytes trees;
        std::uint32_t most_nodes = 0;
        for (unsigned row = 0; row < rows; ++row) {
            const Tokens tokens = row % 2 == 0 ? osem::tests::read_once_expression(operands, random_tokens_)
                                               : osem::tests::any_expression(6, operands, random_tokens_);
            ColouredCells result{osem::root_octant, depth, {}};
            for (std::size_t cell = 0; cell < operand_colours[0].size(); ++cell) {
                Colours at_cell;
                for (const Colours& colours : operand_colours) at_cell.push_back(colours[cell]);
                result.colours.push_back(osem::tests::colour_at(tokens, at_cell));
            }
            const TreeTruth truth(result);
            most_nodes = std::max(most_nodes, truth.pool_nodes());
            trees.u8(tokens.size());
            for (const CsgToken& token : tokens) trees.u8(encoded(token));
            truth.put(trees, rule, random_);
            file_.tally().count(degenerate_, extreme_);
        }
        body.u32(most_nodes);
        body.u8(rows);
        body.append(trees);
    }

    VectorFile& file_;
    Random random_{19};
    std::mt19937 random_tokens_{20};
    bool degenerate_ = false;
    bool extreme_ = false;
};

} // namespace

void write_csg(const std::string& folder) {
    VectorFile file(osem::cross::Topic::csg);
    CsgWriter writer(file);
    for (const oracle::Grid* grid : {&oracle::aligned_grid, &oracle::crooked_grid}) {
        const std::vector<oracle::TestSolid> solids = all_solids(*grid, 16, 7300);
        const std::size_t count = solids.size();
        for (std::size_t i = 0; i < count; ++i) {
            const int depth = i % 8 == 7 ? 4 : 3;
            writer.add(solids[i], solids[(7 * i + 3) % count], depth, static_cast<std::uint32_t>(i));
        }
    }
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
