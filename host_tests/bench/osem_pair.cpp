#include "bench/osem_pair.hpp"

#include <algorithm>

#include "bench/agreement.hpp"

namespace osem::bench {

namespace {

bool append(void* context, const std::uint8_t* bytes, std::size_t count) {
    auto& to = *static_cast<Bytes*>(context);
    to.insert(to.end(), bytes, bytes + count);
    return true;
}

bool replace(void* context, const std::uint8_t* bytes, std::size_t count) {
    std::copy_n(bytes, count, static_cast<Bytes*>(context)->begin());
    return true;
}

void require_ok(Status status) { require(status == Status::ok, describe(status)); }

} // namespace

Bytes stream_of(const Octree& tree) {
    Bytes bytes;
    bytes.reserve(stream_size(measure(tree).nodes));
    require_ok(write_stream(tree, StreamHeader{}, Sink{append, &bytes, replace}));
    return bytes;
}

StreamInMemory::StreamInMemory(const Octree& tree)
    : bytes(stream_of(tree)), index(subtree_index_size(measure(tree).nodes)) {
    require_ok(check_stream(memory_source(bytes.data(), bytes.size()), index.data(), index.size()).status);
}

Source StreamInMemory::source(Known known) const {
    Source source = memory_source(bytes.data(), bytes.size());
    source.checked = known != Known::nothing;
    source.index = known == Known::indexed ? index.data() : nullptr;
    return source;
}

OsemPair::OsemPair(const BenchSolid& a, const BenchSolid& b, int depth, LeafRule leaves)
    : a_(converted(a, {depth, leaves, WindingRule::nonzero})),
      b_(converted(b, {depth, leaves, WindingRule::nonzero})), a_in_stream_(pool_->adopted(a_)),
      b_in_stream_(b_) {
    a_ = pool_->adopted(a_);
    mark_ = pool_->pool().used();
    result_.reserve(stream_bytes(Known::nothing));
}

// A tree behind those that the pool holds.
Octree OsemPair::converted(const BenchSolid& solid, const ConvertOptions& options) {
    const auto job = std::make_unique<Conversion>();
    std::vector<std::uint32_t> scratch(convert_scratch(solid.checked().view()));
    const auto run = [&](NodePool* pool) {
        const TreeOutcome outcome = convert(*job, solid.checked(), options, scratch.data(),
                                            static_cast<std::uint32_t>(scratch.size()), pool);
        require_ok(outcome.status);
        return outcome;
    };
    grow(run(nullptr).nodes_needed);
    return run(&pool_->pool()).tree;
}

void OsemPair::grow(std::uint64_t nodes) {
    pool_ = std::make_unique<host::HostPool>(*pool_, pool_->pool().used() + nodes);
}

void OsemPair::prepare(Operator op) {
    pool_->pool().roll_back(mark_);
    require_ok(job_->begin(op, a_, b_, pool_->pool(), true));
    while (job_->step(UINT32_MAX)) continue;
    const TreeOutcome counted = job_->finish();
    require_ok(counted.status);
    grow(counted.nodes_needed);
    a_ = pool_->adopted(a_);
    b_ = pool_->adopted(b_);
    combine_in_pool(op);
}

Octree OsemPair::combine_in_pool(Operator op) {
    pool_->pool().roll_back(mark_);
    const TreeOutcome outcome = combine(*job_, op, a_, b_, pool_->pool());
    require_ok(outcome.status);
    return outcome.tree;
}

const Bytes& OsemPair::combine_streams(Operator op, Known known) {
    result_.clear();
    const StreamCombinationOutcome outcome =
        combine(*stream_job_, op, a_in_stream_.source(known), b_in_stream_.source(known),
                Sink{append, &result_, replace});
    require_ok(outcome.status);
    return result_;
}

} // namespace osem::bench
