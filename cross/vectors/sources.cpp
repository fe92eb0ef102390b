#include "sources.hpp"

#include <stdexcept>

#include "random.hpp"

namespace vectors {

std::vector<oracle::TestSolid> all_solids(const oracle::Grid& grid, unsigned random_count, unsigned seed) {
    std::vector<oracle::TestSolid> solids = oracle::library(grid);
    for (oracle::TestSolid& solid : oracle::random_solids(grid, random_count, seed)) {
        solids.push_back(std::move(solid));
    }
    return solids;
}

bool is_aligned(const osem::Solid& solid, int depth) {
    const std::int32_t side = osem::root_side >> depth;
    for (std::uint32_t v = 0; v < solid.vertex_count; ++v) {
        for (const std::int32_t c : solid.vertices[v].at) {
            if (c % side == 0) return true;
        }
    }
    return false;
}

bool reaches_end(const osem::Solid& solid) {
    for (std::uint32_t v = 0; v < solid.vertex_count; ++v) {
        if (is_extreme(solid.vertices[v])) return true;
    }
    return false;
}

oracle::TriangleMesh real_mesh(const std::string& name, const oracle::Fit& fit) {
    if (auto mesh = oracle::read_off(name, fit)) return std::move(*mesh);
    throw std::runtime_error("no mesh " + name + " in the folder OSEM_CGAL_DATA: " + oracle::mesh_folder());
}

} // namespace vectors
