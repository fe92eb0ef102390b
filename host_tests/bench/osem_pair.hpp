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

/// What is known of streams before they are combined: nothing, that they are streams, where subtrees end.
enum class Known { nothing, checked, indexed };

/// A stream in memory, and its index.
struct StreamInMemory {
    explicit StreamInMemory(const Octree& tree);
    Source source(Known known) const;
    std::uint64_t size(Known known) const {
        return bytes.size() + (known == Known::indexed ? index.size() : 0);
    }

    Bytes bytes;
    Bytes index;
};

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

    /// The result's stream, in memory that is used again.
    const Bytes& combine_streams(Operator op, Known known);

    /// Bytes of both streams, and of their indexes if they have any.
    std::uint64_t stream_bytes(Known known) const {
        return a_in_stream_.size(known) + b_in_stream_.size(known);
    }

    /// Nodes of both operands.
    std::uint64_t nodes() const { return measure(a_).nodes + measure(b_).nodes; }

  private:
    Octree converted(const BenchSolid& solid, const ConvertOptions& options);
    void grow(std::uint64_t nodes);

    std::unique_ptr<host::HostPool> pool_ = std::make_unique<host::HostPool>(0);
    Octree a_;
    Octree b_;
    std::uint32_t mark_ = 0;
    StreamInMemory a_in_stream_;
    StreamInMemory b_in_stream_;
    Bytes result_;
    std::unique_ptr<Combination> job_ = std::make_unique<Combination>();
    std::unique_ptr<StreamCombination> stream_job_ = std::make_unique<StreamCombination>();
};

} // namespace osem::bench

#endif
