// Osem's conversions as jobs with memory of their own.
#ifndef OSEM_BENCH_OSEM_CONVERSION_HPP
#define OSEM_BENCH_OSEM_CONVERSION_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bench/solids.hpp"
#include "files/host_pool.hpp"
#include "osem/grid_convert.hpp"

namespace osem::bench {

/// A conversion that may be run again and again, by grids or octant by octant. Making it takes a counting
/// pass, which is not timed, so that the pool is as large as the tree and no larger, and runs it once, so
/// that the pool's pages have been touched.
template <class Job>
class OsemConversion {
  public:
    OsemConversion(const BenchSolid& solid, int depth, LeafRule leaves);

    /// Converts into the pool, which holds this tree alone.
    void run();
    /// The tree that the last run gave.
    const Octree& tree() const { return tree_; }

    const Job& job() const { return *job_; }
    std::uint64_t result_bytes() const { return pool_->pool().used() * sizeof(Node); }
    /// Pool, scratch and the job itself.
    std::uint64_t memory_bytes() const {
        return result_bytes() + scratch_.size() * sizeof scratch_[0] + sizeof(Job);
    }

  private:
    std::unique_ptr<Job> job_ = std::make_unique<Job>();
    CheckedSolid solid_;
    ConvertOptions options_;
    std::vector<std::uint32_t> scratch_;
    std::uint64_t nodes_ = 0;
    std::unique_ptr<host::HostPool> pool_;
    Octree tree_{};
};

/// The conversion of a solid by grids, kept until that of another solid or depth by the same rule is asked
/// for: benchmarks of one solid and depth follow each other.
OsemConversion<GridConversion>& conversion_of(const std::string& solid, int depth, LeafRule leaves);

extern template class OsemConversion<Conversion>;
extern template class OsemConversion<GridConversion>;

} // namespace osem::bench

#endif
