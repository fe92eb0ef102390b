// What several topics' records have in common.
#ifndef OSEM_CROSS_REPLAY_RECORDS_HPP
#define OSEM_CROSS_REPLAY_RECORDS_HPP

#include "arena.hpp"
#include "osem/osem.hpp"
#include "reader.hpp"
#include "report.hpp"

namespace osem::cross {

/// Reads a solid into the arena; false when it does not fit.
bool read_solid(Reader& reader, Arena& arena, Solid& solid);

ConvertOptions read_options(Reader& reader);

/// What a tree record says before its leaves.
struct TreeTruth {
    std::uint32_t nodes;
    std::uint32_t white_leaves;
    std::uint32_t black_leaves;
    std::uint32_t boundary_leaves;
    std::uint64_t inner_volume;
    std::uint64_t outer_volume;
    std::uint64_t digest;
    std::uint32_t stream_crc;
    std::uint32_t leaves;

    /// Nodes that it takes from a pool, unshared.
    std::uint32_t pool_nodes() const { return nodes - 1; }
};
TreeTruth read_tree_truth(Reader& reader);

/// Goes over the leaves and queries of a tree record.
void skip_tree(Reader& reader, const TreeTruth& truth);

/// Compares what was measured of a tree with the record.
void compare_measures(Report& report, const TreeTruth& truth, const Measures& found, std::uint64_t digest);

/// A query of a tree record: a cell, and the leaf (4 * level + colour) that holds it if the status is ok.
struct PointQuery {
    Point cell;
    Status status;
    std::uint8_t leaf;
};
PointQuery read_query(Reader& reader);
void compare_query(Report& report, const PointQuery& query, const PointOutcome& found);

/// Compares a tree with the record, which is read to its end: measures, digest, the bytes of its stream,
/// every leaf as it is read, and point queries.
void compare_tree(Reader& reader, Report& report, const TreeTruth& truth, const Octree& tree, LeafRule rule);

/// Compares a tree with u8 depth, u32 leaves, the leaves in Morton order and u64 digest.
void compare_leaves(Reader& reader, Report& report, const Octree& tree);

/// Writes the tree as a stream straight into a reader of streams: into `pool`, or a null one, which only
/// validates and counts.
StreamOutcome copied(const Octree& tree, LeafRule rule, StreamReader& copy, NodePool* pool);

/// Nodes at the back of the arena; null when they do not fit there or no pool can hold so many.
Node* take_nodes(Arena& arena, std::uint32_t count);

} // namespace osem::cross

#endif
