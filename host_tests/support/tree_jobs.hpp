// Every job and function of the kernel that builds a tree in a pool, each with what it has to build, worked
// out on dense grids and by interval arithmetic.
#ifndef OSEM_SUPPORT_TREE_JOBS_HPP
#define OSEM_SUPPORT_TREE_JOBS_HPP

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "support/dense_grid.hpp"
#include "support/effort.hpp"

namespace osem::tests {

struct TreeJob {
    std::string name;
    std::vector<DenseGrid> operands; ///< trees that stand in the pool
    DenseGrid result;
    /// Begins, drives and finishes. All runs use one job object, so each follows what the one before left.
    std::function<TreeOutcome(const std::vector<Octree>&, NodePool&, const Effort&)> run;
    Status given_up = Status::unfinished; ///< what a job answers that is not driven to its end
};

inline void PrintTo(const TreeJob& job, std::ostream* out) { *out << job.name; }

std::vector<TreeJob> tree_jobs();

} // namespace osem::tests

#endif
