// The ways in which `osem convert` comes to a tree.
#ifndef OSEM_HOST_CONVERSION_HPP
#define OSEM_HOST_CONVERSION_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "console/progress.hpp"
#include "files/host_pool.hpp"
#include "osem/bintree.hpp"
#include "osem/convert.hpp"

namespace osem::host {

struct Converted {
    std::unique_ptr<HostPool> pool;
    Octree tree;
    double seconds;        ///< of the pass that made the tree; on several threads of all
    StageCounts stages;    ///< all 0 by grids
    std::uint64_t visited; ///< grids, octants or blocks
    std::uint64_t memory;  ///< bytes of job, scratch and pool
    /// What else the technique counts, by name.
    std::vector<std::pair<std::string, std::uint64_t>> counts;
};

/// Throws BadInput with the status's description unless it is ok.
void require_converted(Status status);

/// Words of scratch for grids of any faces of a solid. Throws BadInput when they are more than a job takes.
std::size_t grid_words(const Solid& solid, int depth);

/// A pool with room for so many nodes, or as many as a pool can hold; with none if there is not so much
/// memory. Only the room that is used takes memory.
std::unique_ptr<HostPool> roomy_pool(std::uint64_t nodes);

inline const TreeOutcome& tree_of(const TreeOutcome& outcome) { return outcome; }
inline const TreeOutcome& tree_of(const LabellingOutcome& outcome) { return outcome.built; }

/// Runs a pass in a pool that is mostly large enough. If it is not, the pass has counted the nodes all the
/// same, and another one has exactly the room it needs, in a pool that takes the first one's place.
template <class PoolPointer, class Run>
auto run_with_room(PoolPointer& pool, Run run) {
    auto outcome = run(pool->pool());
    if (tree_of(outcome).status == Status::pool_exhausted) {
        pool = nullptr;
        pool = std::make_unique<HostPool>(tree_of(outcome).nodes_needed);
        outcome = run(pool->pool());
    }
    return outcome;
}

/// Grids of octants.
Converted convert_by_grids(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress);

/// Divide and conquer.
Converted divide(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress);

/// Divide and conquer at the finest depth, up to that of the options, of at most so many nodes.
Converted divide_to_fit(const CheckedSolid& solid, const ConvertOptions& options, std::uint32_t nodes,
                        Progress& progress);

/// A bintree and the labelling of its components. The leaf rule is not looked at.
Converted label(const CheckedSolid& solid, const ConvertOptions& options, Progress& progress);

} // namespace osem::host

#endif
