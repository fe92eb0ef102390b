// Solids, the options of their conversions, and the trees by CGAL's cells.
#include <cstdio>

#include "cell_grid.hpp"
#include "directed_edges.hpp"
#include "refusals.hpp"
#include "sources.hpp"
#include "topics.hpp"
#include "tree_truth.hpp"
#include "vector_file.hpp"

namespace vectors {

namespace {

using osem::LeafRule;
using osem::WindingRule;

// All rules of leaves and winding numbers, or for great trees the leaf rules alone.
enum class Rules { all, leaves };

std::vector<osem::ConvertOptions> jobs_of(int depth, Rules rules) {
    std::vector<osem::ConvertOptions> jobs;
    for (const auto winding : {WindingRule::nonzero, WindingRule::odd, WindingRule::positive}) {
        if (rules == Rules::leaves && winding != WindingRule::nonzero) continue;
        for (const auto leaves : {LeafRule::conservative, LeafRule::centre}) {
            // A leaf of side 1 has no centre.
            if (leaves == LeafRule::conservative || depth < osem::max_depth) {
                jobs.push_back({depth, leaves, winding});
            }
        }
    }
    return jobs;
}

class ConversionWriter {
  public:
    explicit ConversionWriter(VectorFile& file) : file_(file) {}

    void add(const osem::Solid& solid, const oracle::ExactSolid& exact, const osem::Octant& window, int depth,
             Rules rules) {
        const oracle::CellGrid grid(exact, window, depth);
        const std::vector<osem::ConvertOptions> jobs = jobs_of(depth, rules);
        const bool degenerate = is_aligned(solid, depth);
        const bool extreme = reaches_end(solid);
        Bytes body;
        body.solid(solid);
        body.u8(static_cast<std::uint64_t>(osem::Status::ok));
        body.u32(0);
        file_.tally().count(degenerate, extreme);
        body.u8(jobs.size());
        for (const osem::ConvertOptions& options : jobs) {
            body.options(options);
            TreeTruth(coloured(grid, options.leaves, options.winding)).put(body, options.leaves, random_);
            file_.tally().count(degenerate, extreme);
        }
        file_.add_record(std::move(body));
    }

  private:
    VectorFile& file_;
    Random random_{17};
};

void add_library(ConversionWriter& writer) {
    unsigned seed = 6000;
    for (const oracle::Grid* grid : {&oracle::aligned_grid, &oracle::crooked_grid}) {
        std::size_t number = 0;
        for (const oracle::TestSolid& solid : all_solids(*grid, 20, seed)) {
            const oracle::ExactSolid exact(solid.view());
            for (int depth = 1; depth <= 4; ++depth) {
                if (depth < 3 && number % 8 != 0) continue;
                writer.add(solid.view(), exact, osem::root_octant, depth, Rules::all);
            }
            if (number++ % 3 == 0) {
                writer.add(solid.view_with_tables(), exact, osem::root_octant, 5, Rules::leaves);
            }
        }
        seed += 100;
    }
}

// Down to leaves of side 1.
void add_tiny(ConversionWriter& writer) {
    int depth = 17;
    for (const oracle::TestSolid& solid : oracle::every(3, all_solids(oracle::tiny_grid, 10, 6200))) {
        writer.add(solid.view(), oracle::ExactSolid(solid.view()), oracle::tiny_window, depth, Rules::leaves);
        depth = depth == osem::max_depth ? 17 : depth + 1;
    }
}

void add_mesh_conversions(ConversionWriter& writer) {
    struct Mesh {
        const char* name;
        int depth;
    };
    constexpr Mesh meshes[] = {{"star", 4},  {"tripod", 5}, {"cross", 5},    {"sphere", 5}, {"eight", 5},
                               {"rotor", 6}, {"knot", 6},   {"elephant", 6}, {"cow", 6},    {"armadillo", 6}};
    for (const Mesh& entry : meshes) {
        const oracle::TriangleMesh mesh = real_mesh(entry.name, oracle::whole_root);
        const osem::Solid solid = mesh.view();
        if (!oracle::DirectedEdges(solid).closed()) {
            throw std::logic_error(std::string(entry.name) + " is not closed");
        }
        std::fprintf(stderr, "  %s, %u faces\n", entry.name, solid.face_count);
        writer.add(solid, oracle::ExactSolid(solid), osem::root_octant, entry.depth, Rules::leaves);
    }
}

} // namespace

void write_conversion(const std::string& folder) {
    VectorFile file(osem::cross::Topic::conversion);
    ConversionWriter writer(file);
    add_library(writer);
    add_tiny(writer);
    add_mesh_conversions(writer);
    add_refusals(file);
    file.sort_by_size();
    file.write(folder);
}

} // namespace vectors
