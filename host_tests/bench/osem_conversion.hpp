// Osem's conversions as jobs with memory of their own.
#ifndef OSEM_BENCH_OSEM_CONVERSION_HPP
#define OSEM_BENCH_OSEM_CONVERSION_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bench/solids.hpp"
#include "files/host_pool.hpp"
#include "osem/convert.hpp"

namespace osem::bench {

/// A conversion that may be run again and again. Making it takes a counting pass, so that the pool is as
/// large as the tree and no larger, and runs it once, so that the pool's pages have been touched.
class OsemConversion {
  public:
    OsemConversion(const BenchSolid& solid, int depth, LeafRule leaves);

    /// Converts into the pool, which holds this tree alone.
    void run();
    /// The tree that the last run gave.
    const Octree& tree() const { return tree_; }

    std::uint64_t octants_visited() const { return job_->octants_visited(); }
    std::uint64_t result_bytes() const { return nodes_ * sizeof(Node); }
    /// Pool, scratch and the job itself.
    std::uint64_t memory_bytes() const {
        return result_bytes() + scratch_.size() * sizeof scratch_[0] + sizeof(Conversion);
    }

  private:
    CheckedSolid solid_;
    ConvertOptions options_;
    std::vector<std::uint32_t> scratch_;
    std::unique_ptr<Conversion> job_ = std::make_unique<Conversion>();
    std::uint64_t nodes_ = 0;
    std::unique_ptr<host::HostPool> pool_;
    Octree tree_{};
};

/// The conversion of a solid, kept until that of another solid or depth by the same rule is asked for:
/// benchmarks of one solid and depth follow each other.
OsemConversion& conversion_of(const std::string& solid, int depth, LeafRule leaves);

} // namespace osem::bench

#endif
