// Real meshes, rounded to the lattice: closed ones leaf for leaf at depth 7, open ones refused.
#include <gtest/gtest.h>

#include <cstdio>

#include "cell_grid.hpp"
#include "converted.hpp"
#include "directed_edges.hpp"
#include "level.hpp"
#include "off_mesh.hpp"

namespace oracle {

namespace {

constexpr const char* fast_meshes[] = {"tripod", "star", "cross", "eight", "sphere", "patch-01", "pig"};
constexpr const char* full_meshes[] = {"star",      "tripod",
                                       "cross",     "3torus",
                                       "mpi",       "sphere",
                                       "eight",     "oblong",
                                       "anchor",    "rotor",
                                       "spool",     "handle",
                                       "hand",      "couplingdown",
                                       "blobby",    "bones",
                                       "knot",      "elephant",
                                       "cow",       "retinal",
                                       "fandisk",   "pig",
                                       "patch-01",  "blobby-shuffled",
                                       "head",      "lion-head",
                                       "armadillo", "mech-holes-shark",
                                       "mask_cone", "elephant-with-holes"};

std::vector<std::string> mesh_names() {
    if (is_full()) return {std::begin(full_meshes), std::end(full_meshes)};
    return {std::begin(fast_meshes), std::end(fast_meshes)};
}

struct Line {
    std::uint64_t leaves = 0;
    std::uint64_t wrong = 0;
};

Line test_leaves(const std::string& name, const osem::CheckedSolid& solid, int depth) {
    Line line;
    const ExactSolid exact(solid.view());
    const CellGrid grid(exact, osem::root_octant, depth);
    HeapPool pool(1U << 19);
    for (const auto leaves : {osem::LeafRule::conservative, osem::LeafRule::centre}) {
        const osem::ConvertOptions options{depth, leaves, osem::WindingRule::nonzero};
        const osem::TreeOutcome outcome = converted(solid, options, *pool);
        EXPECT_EQ(outcome.status, osem::Status::ok) << name;
        if (outcome.status != osem::Status::ok) continue;
        const Report report = compare(outcome.tree, grid, options);
        EXPECT_TRUE(report.good()) << name << ", " << name_of(leaves) << ": " << report.wrong_leaves
                                   << " wrong leaves; " << report.first;
        line.leaves += report.leaves;
        line.wrong += report.wrong_leaves;
    }
    return line;
}

TEST(RealMeshOracle, EveryLeafOrRefused) {
    if (mesh_folder().empty()) FAIL() << "OSEM_CGAL_DATA names no folder";
    const int depth = is_full() ? 7 : 5;
    unsigned accepted = 0;
    unsigned refused = 0;
    std::printf("%-22s %8s %10s %6s\n", "mesh", "faces", "leaves", "wrong");
    for (const std::string& name : mesh_names()) {
        const std::optional<TriangleMesh> mesh = read_off(name, whole_root);
        ASSERT_TRUE(mesh.has_value()) << name << " is not in " << mesh_folder();
        const DirectedEdges edges(mesh->view());
        const osem::CheckOutcome outcome = checked(mesh->view());
        if (!edges.closed()) {
            EXPECT_EQ(outcome.status, osem::Status::surface_not_closed) << name;
            EXPECT_TRUE(edges.has(outcome.edge)) << name;
            EXPECT_GT(edges.excess(mesh->view(), outcome.edge), 0) << name;
            std::printf("%-22s %8u %10s\n", name.c_str(), mesh->view().face_count, "refused");
            ++refused;
            continue;
        }
        ASSERT_EQ(outcome.status, osem::Status::ok) << name << ": " << osem::describe(outcome.status);
        const Line line = test_leaves(name, outcome.solid, depth);
        std::printf("%-22s %8u %10llu %6llu\n", name.c_str(), mesh->view().face_count,
                    static_cast<unsigned long long>(line.leaves),
                    static_cast<unsigned long long>(line.wrong));
        std::fflush(stdout);
        ++accepted;
    }
    EXPECT_GE(accepted, is_full() ? 10U : 3U);
    EXPECT_GE(refused, 1U);
}

} // namespace

} // namespace oracle
