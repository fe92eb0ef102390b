// Prints the name and the digest of every scenario, and at last one digest over all of them.
#include "digest.hpp"
#include "memory.hpp"
#include "platform.hpp"
#include "scenarios.hpp"

namespace osem::cross {

using port::print;
using port::print_hexadecimal;

namespace {

constexpr Scenario scenarios[] = {
    {"frame_mapping", frame_mapping},
    {"classified_faces", classified_faces},
    {"refused_solids", refused_solids},
    {"plate_conservative", plate_conservative},
    {"plate_centre", plate_centre},
    {"octahedron_deep", octahedron_deep},
    {"shells_by_winding", shells_by_winding},
    {"soups", soups},
    {"unit_leaves", unit_leaves},
    {"small_steps", small_steps},
    {"small_pools", small_pools},
    {"conversions_by_grids", conversions_by_grids},
    {"work_of_grids", work_of_grids},
    {"booleans_conservative", booleans_conservative},
    {"booleans_centre", booleans_centre},
    {"shared_operands", shared_operands},
    {"compaction", compaction},
    {"stream_bytes", stream_bytes},
    {"damaged_streams", damaged_streams},
    {"combined_streams", combined_streams},
    {"indexed_streams", indexed_streams},
    {"expressions_conservative", expressions_conservative},
    {"expressions_centre", expressions_centre},
    {"expressions_of_damaged_streams", expressions_of_damaged_streams},
    {"evaluated_expressions", evaluated_expressions},
    {"point_queries", point_queries},
    {"box_queries", box_queries},
    {"measures_and_leaves", measures_and_leaves},
    {"segment_walks", segment_walks},
    {"neighbours_and_nearest_leaves", neighbours_and_nearest_leaves},
    {"collisions", collisions},
    {"moments_and_surfaces", moments_and_surfaces},
    {"labelled_components", labelled_components},
    {"surfaces_of_eight_cells", surfaces_of_eight_cells},
    {"surface_with_holes", surface_with_holes},
    {"surfaces_counted", surfaces_counted},
    {"labelled_blocks", labelled_blocks},
    {"finest_fits", finest_fits},
    {"pruned_trees", pruned_trees},
    {"placed_trees", placed_trees},
    {"cropped_trees", cropped_trees},
    {"symmetric_trees", symmetric_trees},
    {"coarser_trees", coarser_trees},
    {"scaled_trees", scaled_trees},
    {"slices_as_runs", slices_as_runs},
    {"slices_as_bitmaps", slices_as_bitmaps},
};

void print_line(const char* name, std::uint64_t digest) {
    print(name);
    print(" ");
    print_hexadecimal(digest);
    print("\n");
}

// What start-up code has to set before main.
volatile std::uint32_t initialised = 0x600df00d;

void run() {
    Digest all;
    for (const Scenario& scenario : scenarios) {
        pool.roll_back(0);
        // Through a pointer that the optimiser knows nothing of: the stack of all scenarios in one is too
        // large.
        std::uint64_t (*const volatile run_scenario)() = scenario.digest;
        const std::uint64_t digest = run_scenario();
        print_line(scenario.name, digest);
        all.add(digest);
    }
    print_line("all", all.value());
}

} // namespace

} // namespace osem::cross

int main() {
    if (osem::cross::initialised != 0x600df00d) {
        osem::port::print("the initialised variables were not set\n");
        return 1;
    }
    osem::cross::run();
    return 0;
}
