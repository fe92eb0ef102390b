// Conversions by labelling and at the finest depth that fits, by CGAL's cells at every depth; and trees
// coarsened to a number of nodes, against the best of all ways to do so.
#include <algorithm>
#include <set>

#include "cell_grid.hpp"
#include "format.hpp"
#include "grid_leaves.hpp"
#include "sources.hpp"
#include "support/losses.hpp"
#include "topics.hpp"
#include "tree_truth.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::Colour;
using osem::LeafRule;
using osem::WindingRule;
using osem::tests::DenseGrid;

class FitWriter {
  public:
    explicit FitWriter(VectorFile& file) : file_(file) {}

    /// A record of one solid: labellings of every depth up to a limit, and fittings under both leaf rules.
    void add(const oracle::TestSolid& solid, int limit, WindingRule winding) {
        const oracle::ExactSolid exact(solid.view());
        std::vector<oracle::CellGrid> grids;
        grids.reserve(static_cast<std::size_t>(limit));
        for (int depth = 1; depth <= limit; ++depth) grids.emplace_back(exact, osem::root_octant, depth);
        Bytes jobs;
        std::uint64_t count = 0;
        for (int depth = 1; depth <= limit; ++depth) {
            const oracle::CellGrid& grid = grids[static_cast<std::size_t>(depth) - 1];
            const TreeTruth truth(coloured(grid, LeafRule::conservative, winding));
            jobs.u8(osem::cross::job_labelling);
            jobs.options({depth, LeafRule::conservative, winding});
            put_job(jobs, truth.pool_nodes(), depth, truth, LeafRule::conservative);
            file_.tally().count(is_aligned(solid.view(), depth), reaches_end(solid.view()));
            ++count;
        }
        for (const LeafRule rule : {LeafRule::conservative, LeafRule::centre}) {
            count += put_fittings(jobs, solid, grids, {limit, rule, winding});
        }
        Bytes body;
        body.u8(osem::cross::operand_solid);
        body.solid(solid.view());
        body.u8(count);
        body.append(jobs);
        file_.add_record(std::move(body));
    }

    /// A record of one tree, coarsened to some budgets.
    void add(const DenseGrid& grid) {
        const osem::tests::Losses least = osem::tests::least_losses(grid);
        std::set<std::size_t> budgets = {0, 1, least.size() - 1, least.size()};
        for (std::size_t part = 1; part < 8; ++part) budgets.insert(part * least.size() / 8);
        Bytes body;
        body.u8(osem::cross::operand_tree);
        put_grid(body, grid);
        body.u64(grid.volume(Colour::black));
        body.u64(grid.volume(Colour::black) + grid.volume(Colour::boundary));
        body.u8(budgets.size());
        for (const std::size_t budget : budgets) {
            body.u32(budget);
            body.u64(least[std::min(budget, least.size() - 1)]);
            file_.tally().count(budget + 1 >= least.size(), budget == 0);
        }
        file_.add_record(std::move(body));
    }

  private:
    void put_job(Bytes& jobs, std::uint32_t room, int depth, const TreeTruth& truth, LeafRule rule) {
        jobs.u32(room);
        jobs.u8(static_cast<std::uint64_t>(depth));
        truth.put(jobs, rule, random_);
    }

    // With room for each depth's tree, and for a node less.
    std::uint64_t put_fittings(Bytes& jobs, const oracle::TestSolid& solid,
                               const std::vector<oracle::CellGrid>& grids,
                               const osem::ConvertOptions& options) {
        std::vector<TreeTruth> trees;
        trees.reserve(grids.size());
        for (const oracle::CellGrid& grid : grids) {
            trees.emplace_back(coloured(grid, options.leaves, options.winding));
        }
        std::set<std::uint32_t> rooms;
        for (const TreeTruth& tree : trees) {
            rooms.insert(tree.pool_nodes());
            if (tree.pool_nodes() > 0) rooms.insert(tree.pool_nodes() - 1);
        }
        for (const std::uint32_t room : rooms) {
            std::size_t finest = trees.size();
            while (trees[finest - 1].pool_nodes() > room) --finest; // the first depth takes no node
            jobs.u8(osem::cross::job_fitting);
            jobs.options(options);
            put_job(jobs, room, static_cast<int>(finest), trees[finest - 1], options.leaves);
            file_.tally().count(is_aligned(solid.view(), options.depth), reaches_end(solid.view()));
        }
        return rooms.size();
    }

    VectorFile& file_;
    Random random_{71};
};

} // namespace

void write_fit(const std::string& folder) {
    VectorFile file(osem::cross::Topic::fit);
    FitWriter writer(file);
    constexpr WindingRule windings[] = {WindingRule::nonzero, WindingRule::odd, WindingRule::positive};
    std::size_t number = 0;
    for (const oracle::Grid* grid : {&oracle::aligned_grid, &oracle::crooked_grid}) {
        for (const oracle::TestSolid& solid : all_solids(*grid, 4, 7500)) {
            writer.add(solid, number % 8 == 7 ? 4 : 3, windings[number % 3]);
            ++number;
        }
    }
    for (const Colour colour : osem::tests::three_colours) writer.add(DenseGrid(1, colour));
    for (std::uint32_t seed = 0; seed < 90; ++seed) {
        const int depth = 2 + static_cast<int>(seed % 3 / 2);
        writer.add(osem::tests::random_grid(depth, 7000 + seed, osem::tests::three_colours));
    }
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
