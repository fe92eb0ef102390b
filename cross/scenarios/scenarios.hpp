// The fixed list of scenarios whose digests are pinned in cross/digests.txt. Each one is a pure function of
// the kernel: the same digest on every architecture, from every compiler, at every optimisation level.
#ifndef OSEM_SCENARIOS_HPP
#define OSEM_SCENARIOS_HPP

#include <cstdint>

namespace osem::cross {

struct Scenario {
    const char* name;
    std::uint64_t (*digest)();
};

// predicates.cpp
std::uint64_t frame_mapping();
std::uint64_t classified_faces();
std::uint64_t refused_solids();

// conversions.cpp
std::uint64_t plate_conservative();
std::uint64_t plate_centre();
std::uint64_t octahedron_deep();
std::uint64_t shells_by_winding();
std::uint64_t soups();
std::uint64_t unit_leaves();
std::uint64_t small_steps();
std::uint64_t small_pools();
std::uint64_t conversions_by_grids();
std::uint64_t work_of_grids();

// booleans.cpp
std::uint64_t booleans_conservative();
std::uint64_t booleans_centre();
std::uint64_t shared_operands();
std::uint64_t compaction();

// streams.cpp
std::uint64_t stream_bytes();
std::uint64_t damaged_streams();
std::uint64_t combined_streams();
std::uint64_t indexed_streams();

// csg.cpp
std::uint64_t expressions_conservative();
std::uint64_t expressions_centre();
std::uint64_t expressions_of_damaged_streams();
std::uint64_t evaluated_expressions();

// queries.cpp
std::uint64_t point_queries();
std::uint64_t box_queries();
std::uint64_t measures_and_leaves();
std::uint64_t segment_walks();
std::uint64_t neighbours_and_nearest_leaves();
std::uint64_t collisions();

// measures.cpp
std::uint64_t moments_and_surfaces();
std::uint64_t labelled_components();

// boundary.cpp
std::uint64_t surfaces_of_eight_cells();
std::uint64_t surface_with_holes();
std::uint64_t surfaces_counted();

// fits.cpp
std::uint64_t labelled_blocks();
std::uint64_t finest_fits();
std::uint64_t pruned_trees();

// transforms.cpp
std::uint64_t placed_trees();
std::uint64_t cropped_trees();
std::uint64_t symmetric_trees();
std::uint64_t coarser_trees();
std::uint64_t scaled_trees();

// slices.cpp
std::uint64_t slices_as_runs();
std::uint64_t slices_as_bitmaps();

} // namespace osem::cross

#endif
