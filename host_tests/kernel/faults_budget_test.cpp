// Jobs that neither build a tree nor write to a sink, in steps of several sizes and given up on the way:
// measures, components, collisions. Their results are worked out cell by cell.
#include <gtest/gtest.h>

#include <random>

#include "osem/collide.hpp"
#include "osem/components.hpp"
#include "osem/measure.hpp"
#include "support/cell_measures.hpp"
#include "support/dense_grid.hpp"
#include "support/effort.hpp"
#include "support/heap_pool.hpp"
#include "support/leaf_list.hpp"
#include "support/query_oracles.hpp"

namespace osem::tests {

namespace {

struct Tree {
    DenseGrid grid;
    HeapPool pool{4000};
    Octree tree;
    explicit Tree(std::uint32_t seed)
        : grid(random_grid(3, seed, three_colours)), tree(planted(grid, *pool)) {}
};

void expect_surface(const SurfaceMeasures& got, const DenseGrid& grid, std::uint8_t colours) {
    const SurfaceMeasures truth = cell_surface(CellSet(grid, colours));
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(got.area[axis], truth.area[axis]);
    EXPECT_EQ(got.euler_closed, truth.euler_closed);
    EXPECT_EQ(got.euler_open, truth.euler_open);
}

TEST(BudgetFaults, SurfaceMeasurement) {
    Tree of(91);
    const PoolImage before(of.pool);
    SurfaceMeasurement job;
    for (const std::uint32_t budget : step_budgets) {
        for (std::uint64_t steps = 0; steps < 40; ++steps) {
            job.begin(of.tree);
            drive(job, {budget, steps});
            if (job.step(0)) {
                ASSERT_EQ(job.finish().status, Status::unfinished);
            }
        }
        job.begin(of.tree);
        drive(job, {budget});
        const SurfaceOutcome outcome = job.finish();
        ASSERT_EQ(outcome.status, Status::ok);
        expect_surface(outcome.inner, of.grid, inner_solid);
        expect_surface(outcome.outer, of.grid, outer_solid);
    }
    EXPECT_TRUE(before.same_nodes(of.pool));
}

TEST(BudgetFaults, ComponentLabelling) {
    Tree of(92);
    const PoolImage before(of.pool);
    ComponentLabelling job;
    for (const std::uint8_t colours : {inner_solid, outer_void}) {
        const CellComponents truth = cell_components(of.grid, colours, Connectivity::faces);
        std::vector<std::uint32_t> scratch(
            static_cast<std::size_t>(component_scratch(measure(of.tree), colours)));
        const auto begin = [&] {
            job.begin(of.tree, colours, Connectivity::faces, scratch.data(),
                      static_cast<std::uint32_t>(scratch.size()));
        };
        for (const std::uint32_t budget : step_budgets) {
            for (std::uint64_t steps = 0; steps < 40; ++steps) {
                begin();
                drive(job, {budget, steps});
                if (job.step(0)) {
                    ASSERT_EQ(job.finish().status, Status::unfinished);
                }
            }
            begin();
            drive(job, {budget});
            const ComponentOutcome outcome = job.finish();
            ASSERT_EQ(outcome.status, Status::ok);
            ASSERT_EQ(outcome.components, truth.components.size());
            for (std::size_t cell = 0; cell < of.grid.size(); ++cell) {
                ASSERT_EQ(job.component_of(of.grid.corner(cell)), truth.labels[cell]);
            }
        }
    }
    EXPECT_TRUE(before.same_nodes(of.pool));
}

TEST(BudgetFaults, Collision) {
    Tree a(93);
    Tree b(94);
    const std::vector<Leaf> cells_a = cells_of(a.grid, outer_solid);
    const std::vector<Leaf> cells_b = cells_of(b.grid, outer_solid);
    std::mt19937 random(95);
    Collision job;
    for (int trial = 0; trial < 60; ++trial) {
        Point offset = {{0, 0, 0}};
        for (std::int32_t& at : offset.at) {
            at = (static_cast<std::int32_t>(random() % 19) - 9) * (root_side / 8);
        }
        const Contact truth = expected_contact(cells_a, cells_b, offset);
        for (const std::uint32_t budget : step_budgets) {
            job.begin(a.tree, b.tree, offset);
            while (job.step(budget)) {
                const CollisionOutcome outcome = job.finish();
                ASSERT_EQ(outcome.status, Status::unfinished);
                ASSERT_LE(outcome.contact, truth) << "a lower bound";
            }
            const CollisionOutcome outcome = job.finish();
            ASSERT_EQ(outcome.status, Status::ok);
            ASSERT_EQ(outcome.contact, truth) << "trial " << trial << ", budget " << budget;
        }
    }
}

} // namespace

} // namespace osem::tests
