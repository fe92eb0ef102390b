// Two trees of one pool, and the streams of both: operands of Osem's Booleans.
#ifndef OSEM_BENCH_OSEM_PAIR_HPP
#define OSEM_BENCH_OSEM_PAIR_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "bench/solids.hpp"
#include "files/host_pool.hpp"
#include "osem/boolean.hpp"
#include "osem/convert.hpp"
#include "osem/stream_boolean.hpp"

namespace osem::bench {

using Bytes = std::vector<std::uint8_t>;

/// The bytes of a tree's stream.
Bytes stream_of(const Octree& tree);

/// Two solids converted to one depth. The pool has room for both trees and for one result at a time, which
/// takes the place of the one before.
class OsemPair {
  public:
    OsemPair(const BenchSolid& a, const BenchSolid& b, int depth, LeafRule leaves);

    /// Makes room for the result of `op`, and touches that room.
    void prepare(Operator op);
    Octree combine_in_pool(Operator op);
    /// Nodes that the result of the last combination added to the pool.
    std::uint64_t nodes_added() const { return pool_->pool().used() - mark_; }

    /// The result's stream, in memory that is used again; of operands that are checked on the way, or have
    /// been checked before.
    const Bytes& combine_streams(Operator op) {
        return combine_streams(op, memory_source(stream_a_.data(), stream_a_.size()),
                               memory_source(stream_b_.data(), stream_b_.size()));
    }
    const Bytes& combine_checked_streams(Operator op) {
        Source a = memory_source(stream_a_.data(), stream_a_.size());
        Source b = memory_source(stream_b_.data(), stream_b_.size());
        a.checked = b.checked = true;
        return combine_streams(op, a, b);
    }

    std::uint64_t stream_bytes() const { return stream_a_.size() + stream_b_.size(); }

    /// Nodes of both operands.
    std::uint64_t nodes() const { return measure(a_).nodes + measure(b_).nodes; }

  private:
    Octree converted(const BenchSolid& solid, const ConvertOptions& options);
    const Bytes& combine_streams(Operator op, const Source& a, const Source& b);
    void grow(std::uint64_t nodes);

    std::unique_ptr<host::HostPool> pool_ = std::make_unique<host::HostPool>(0);
    Octree a_;
    Octree b_;
    std::uint32_t mark_ = 0;
    Bytes stream_a_;
    Bytes stream_b_;
    Bytes result_;
    std::unique_ptr<Combination> job_ = std::make_unique<Combination>();
    std::unique_ptr<StreamCombination> stream_job_ = std::make_unique<StreamCombination>();
};

} // namespace osem::bench

#endif
