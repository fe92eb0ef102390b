#include "support/tree_jobs.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "osem/bintree.hpp"
#include "osem/csg.hpp"
#include "osem/fit.hpp"
#include "osem/grid_convert.hpp"
#include "osem/stream.hpp"
#include "osem/transform.hpp"
#include "support/byte_stream.hpp"
#include "support/small_solids.hpp"
#include "support/transforms.hpp"

namespace osem::tests {

namespace {

using Jobs = std::vector<TreeJob>;
using Words = std::vector<std::uint32_t>;

constexpr int solid_depth = 3;

std::uint32_t length(const Words& words) { return static_cast<std::uint32_t>(words.size()); }

// Adds a job whose `begin` takes the job object, the operands and the pool.
template <class Job, class Begin>
void add(Jobs& jobs, const std::string& name, const std::vector<DenseGrid>& operands, const DenseGrid& result,
         const Begin& begin) {
    const auto job = std::make_shared<Job>();
    jobs.push_back(
        {name, operands, result, [=](const std::vector<Octree>& trees, NodePool& pool, const Effort& effort) {
             EXPECT_EQ(begin(*job, trees, pool), Status::ok);
             drive(*job, effort);
             return job->finish();
         }});
}

// Two overlapping boxes; faces with holes, a tunnel. Neither lies on planes of octants.
std::vector<Box> crooked_boxes() {
    return {{{{100001, 90003, 220005}}, {{600007, 500009, 400011}}},
            {{{300001, 200003, 250005}}, {{900007, 700009, 800011}}, -1}};
}
Tunnel crooked_tunnel() {
    return {{{{100001, 90003, 120005}}, {{900007, 800009, 700011}}},
            {{{300001, 250003, 0}}, {{650007, 600009, 0}}},
            axis_z};
}

struct SolidCase {
    std::string name;
    SmallSolid solid;
    DenseGrid conservative;
    DenseGrid centre;
    const DenseGrid& grid(LeafRule leaves) const {
        return leaves == LeafRule::centre ? centre : conservative;
    }
};

std::vector<std::shared_ptr<const SolidCase>> solid_cases() {
    const auto boxes = [](const Point& p, std::int32_t side) {
        return box_colour(crooked_boxes(), WindingRule::nonzero, p, side);
    };
    const auto box_centres = [](const Point& p, std::int32_t side) {
        return box_centre_colour(crooked_boxes(), WindingRule::nonzero, p, side);
    };
    const auto tunnel = [](const Point& p, std::int32_t side) {
        return tunnel_colour(crooked_tunnel(), p, side);
    };
    const auto tunnel_centres = [](const Point& p, std::int32_t side) {
        return tunnel_centre_colour(crooked_tunnel(), p, side);
    };
    std::vector<std::shared_ptr<const SolidCase>> cases;
    cases.push_back(std::make_shared<SolidCase>(SolidCase{"boxes", boxes_solid(crooked_boxes()),
                                                          make_grid(solid_depth, boxes),
                                                          make_grid(solid_depth, box_centres)}));
    cases.push_back(std::make_shared<SolidCase>(SolidCase{"tunnel", tunnel_solid(crooked_tunnel()),
                                                          make_grid(solid_depth, tunnel),
                                                          make_grid(solid_depth, tunnel_centres)}));
    return cases;
}

void add_conversions(Jobs& jobs) {
    for (const auto& of : solid_cases()) {
        for (const LeafRule leaves : {LeafRule::conservative, LeafRule::centre}) {
            const std::string name = of->name + (leaves == LeafRule::centre ? ", centres" : "");
            const ConvertOptions options = {solid_depth, leaves};
            const auto scratch = std::make_shared<Words>(convert_scratch(of->solid.view()));
            add<Conversion>(jobs, "convert " + name, {}, of->grid(leaves),
                            [=](Conversion& job, const std::vector<Octree>&, NodePool& pool) {
                                return job.begin(of->solid.checked(), options, scratch->data(),
                                                 length(*scratch), &pool);
                            });
            for (const int last : {1, 2, 3}) {
                const auto words = std::make_shared<Words>(grid_scratch(of->solid.view(), solid_depth, last));
                add<GridConversion>(jobs, "convert by grids of " + std::to_string(last) + " levels " + name,
                                    {}, of->grid(leaves),
                                    [=](GridConversion& job, const std::vector<Octree>&, NodePool& pool) {
                                        return job.begin(of->solid.checked(), options, words->data(),
                                                         length(*words), &pool, {last, root_octant});
                                    });
            }
            const Octant octant = root_octant.child(3);
            const auto words = std::make_shared<Words>(grid_scratch(of->solid.view(), solid_depth, 1));
            add<GridConversion>(jobs, "convert an octant by grids " + name, {},
                                enlarged_grid(of->grid(leaves), octant),
                                [=](GridConversion& job, const std::vector<Octree>&, NodePool& pool) {
                                    return job.begin(of->solid.checked(), options, words->data(),
                                                     length(*words), &pool, {1, octant});
                                });
        }
    }
}

void add_labellings(Jobs& jobs) {
    for (const auto& of : solid_cases()) {
        const auto job = std::make_shared<Labelling>();
        const auto faces = std::make_shared<Words>(of->solid.face_count());
        const LabellingOutcome counted =
            convert_by_labelling(*job, of->solid.checked(), solid_depth, WindingRule::nonzero, faces->data(),
                                 length(*faces), nullptr, 0, nullptr);
        const auto blocks = std::make_shared<Words>(counted.blocks_needed);
        jobs.push_back({"label blocks of " + of->name,
                        {},
                        of->conservative,
                        [=](const std::vector<Octree>&, NodePool& pool, const Effort& effort) {
                            EXPECT_EQ(job->begin(of->solid.checked(), solid_depth, WindingRule::nonzero,
                                                 faces->data(), length(*faces), blocks->data(),
                                                 length(*blocks), &pool),
                                      Status::ok);
                            drive(*job, effort);
                            return job->finish().built;
                        }});
    }
}

// A solid less a tree, and that together with what a stream leaves free: every operand stands once, so the
// colours are Kleene's, cell by cell.
void add_expression(Jobs& jobs) {
    const auto of = solid_cases()[0];
    const DenseGrid tree = random_grid(solid_depth, 41, three_colours);
    const DenseGrid stream = random_grid(solid_depth, 42, two_colours);
    const auto bytes =
        std::make_shared<const Bytes>(StreamModel(solid_depth, preorder_masks(stream)).bytes());
    const auto scratch = std::make_shared<Words>(of->solid.face_count());
    const auto job = std::make_shared<CsgConversion>();
    const DenseGrid result = combined(
        Operator::exclusive_or, combined(Operator::subtract, of->conservative, tree), complemented(stream));
    jobs.push_back({"an expression over a solid, a tree and a stream",
                    {tree},
                    result,
                    [=](const std::vector<Octree>& trees, NodePool& pool, const Effort& effort) {
                        CsgSolid a(of->solid.checked(), WindingRule::nonzero, scratch->data(),
                                   length(*scratch));
                        CsgTree b(trees[0]);
                        CsgStream c(memory_source(bytes->data(), bytes->size()));
                        const CsgToken tokens[] = {
                            CsgToken::of(0U), CsgToken::of(1U),       CsgToken::of(Operator::subtract),
                            CsgToken::of(2U), CsgToken::complement(), CsgToken::of(Operator::exclusive_or)};
                        const CsgOperand operands[] = {a, b, c};
                        CsgOptions options;
                        options.depth = solid_depth;
                        EXPECT_EQ(job->begin(tokens, 6, operands, 3, options, &pool).status, Status::ok);
                        drive(*job, effort);
                        return job->finish().built;
                    }});
}

void add_booleans(Jobs& jobs) {
    const std::vector<DenseGrid> operands = {random_grid(3, 51, three_colours),
                                             random_grid(4, 52, three_colours)};
    const DenseGrid a = refined(operands[0], 4);
    for (const Operator op :
         {Operator::unite, Operator::intersect, Operator::subtract, Operator::exclusive_or}) {
        add<Combination>(jobs, "operator " + std::to_string(static_cast<int>(op)), operands,
                         combined(op, a, operands[1]),
                         [op](Combination& job, const std::vector<Octree>& trees, NodePool& pool) {
                             return job.begin(op, trees[0], trees[1], pool);
                         });
    }
    const auto job = std::make_shared<Combination>();
    jobs.push_back({"complement",
                    {operands[1]},
                    complemented(operands[1]),
                    [=](const std::vector<Octree>& trees, NodePool& pool, const Effort&) {
                        return complement(*job, trees[0], pool);
                    }});
}

void add_moves(Jobs& jobs) {
    const DenseGrid grid = random_grid(3, 61, three_colours);
    constexpr std::int32_t cell = root_side / 8;
    std::vector<Placement> placements(4);
    placements[0].by = {{cell, -2 * cell, 3 * cell}};
    placements[1].by = {{cell / 2, 0, -cell}};
    placements[2].keep = {{{cell, 0, 2 * cell}}, {{7 * cell, 5 * cell, 8 * cell}}};
    placements[3].by = {{root_side / 2, 0, 0}};
    for (Placement& placement : placements) {
        placement.cut_at_root = true;
        add<Translation>(jobs, "placement " + std::to_string(&placement - placements.data()), {grid},
                         placed(grid, placement, exact_depth(grid, placement)),
                         [placement](Translation& job, const std::vector<Octree>& trees, NodePool& pool) {
                             return job.begin(trees[0], placement, pool);
                         });
    }
    const Symmetry turn = Symmetry::nth(29);
    add<Reorientation>(jobs, "symmetry", {grid}, reoriented(grid, turn),
                       [turn](Reorientation& job, const std::vector<Octree>& trees, NodePool& pool) {
                           return job.begin(trees[0], turn, pool);
                       });
}

void add_scales(Jobs& jobs) {
    const DenseGrid fine = random_grid(4, 62, three_colours);
    for (const Coarse mode : {Coarse::certified, Coarse::inner, Coarse::outer, Coarse::majority}) {
        add<Coarsening>(jobs, "coarsening " + std::to_string(static_cast<int>(mode)), {fine},
                        coarse(fine, 3, mode),
                        [mode](Coarsening& job, const std::vector<Octree>& trees, NodePool& pool) {
                            return job.begin(trees[0], 3, mode, pool);
                        });
    }
    const DenseGrid grid = random_grid(2, 63, three_colours);
    const Octant octant = root_octant.child(6).child(1).child(5);
    jobs.push_back({"reduction",
                    {grid},
                    reduced_grid(grid, octant),
                    [octant](const std::vector<Octree>& trees, NodePool& pool, const Effort&) {
                        return reduced(trees[0], octant, pool);
                    }});
    const Octant part = root_octant.child(2);
    jobs.push_back({"enlargement",
                    {fine},
                    enlarged_grid(fine, part),
                    [part](const std::vector<Octree>& trees, NodePool&, const Effort&) {
                        return enlarged(trees[0], part);
                    }});
}

// With room for all of its nodes a tree is kept as it is, written anew.
void add_pruning(Jobs& jobs) {
    const DenseGrid grid = random_grid(3, 71, three_colours);
    const auto budget = static_cast<std::uint32_t>(preorder_masks(grid).size());
    const auto job = std::make_shared<Pruning>();
    jobs.push_back({"pruning",
                    {grid},
                    grid,
                    [=](const std::vector<Octree>& trees, NodePool& pool, const Effort& effort) {
                        job->begin(trees[0], budget, &pool);
                        drive(*job, effort);
                        return job->finish().built;
                    }});
}

// A step is a chunk of as many bytes as the budget says.
void add_reader(Jobs& jobs) {
    const DenseGrid grid = random_grid(4, 72, three_colours);
    const auto bytes = std::make_shared<const Bytes>(StreamModel(4, preorder_masks(grid)).bytes());
    const auto reader = std::make_shared<StreamReader>();
    jobs.push_back({"reading a stream",
                    {},
                    grid,
                    [=](const std::vector<Octree>&, NodePool& pool, const Effort& effort) {
                        reader->begin(&pool);
                        std::size_t at = 0;
                        for (std::uint64_t i = 0; i < effort.steps && at < bytes->size(); ++i) {
                            const std::size_t count =
                                std::min<std::size_t>(effort.budget, bytes->size() - at);
                            reader->feed(bytes->data() + at, count);
                            at += count;
                        }
                        return reader->finish().built;
                    },
                    Status::stream_truncated});
}

void add_builders(Jobs& jobs) {
    const DenseGrid grid = random_grid(3, 73, three_colours);
    jobs.push_back(
        {"building octants of more than one colour",
         {},
         grid,
         [grid](const std::vector<Octree>&, NodePool& pool, const Effort&) { return plant(grid, &pool); }});
    jobs.push_back({"building every octant",
                    {},
                    grid,
                    [grid](const std::vector<Octree>&, NodePool& pool, const Effort&) {
                        return plant_by_cells(grid, &pool);
                    }});
}

} // namespace

std::vector<TreeJob> tree_jobs() {
    Jobs jobs;
    add_conversions(jobs);
    add_labellings(jobs);
    add_expression(jobs);
    add_booleans(jobs);
    add_moves(jobs);
    add_scales(jobs);
    add_pruning(jobs);
    add_reader(jobs);
    add_builders(jobs);
    return jobs;
}

} // namespace osem::tests
