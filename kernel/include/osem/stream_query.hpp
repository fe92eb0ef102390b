// What can be asked of a tree that lies in a stream, with O(depth) memory and no pool.
#ifndef OSEM_STREAM_QUERY_HPP
#define OSEM_STREAM_QUERY_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/query.hpp"
#include "osem/stream.hpp"

namespace osem {

/// Outcome of a point query in a stream.
struct StreamPointOutcome {
    /// As leaf_at on the tree, but `visited` are the octants and leaf groups read; of a checked source the
    /// octants that hold the cell, and their children before.
    PointOutcome point;
    std::uint64_t offset; ///< the byte of the leaf's code, or of the fault
};

/// The leaf that holds the cell [x, x + 1) x [y, y + 1) x [z, z + 1). Status: ok; point_off_root; the faults
/// of StreamCursor up to the leaf (what lies behind it is not read, and the checksum is not compared). Cost:
/// O(nodes before the leaf); of an indexed source two bytes for 32 of them, and O(depth) nodes.
StreamPointOutcome leaf_at(const Source& stream, const Point& cell);

/// Outcome of measuring a stream.
struct StreamMeasures {
    Status status;
    std::uint64_t offset; ///< the byte of the fault
    Measures measures;    ///< meaningful when status is ok; as measure gives them of the tree
};

/// Counts leaves, nodes and volumes. Status: ok; the faults of StreamCursor. Cost: O(nodes).
StreamMeasures measure(const Source& stream);

/// Outcome of a digest of a stream.
struct StreamDigest {
    Status status;
    std::uint64_t offset; ///< the byte of the fault
    std::uint64_t digest; ///< meaningful when status is ok; that of the tree
};

/// The digest of the tree. It takes the colours of all eight children before what is below them, so each
/// octant looks ahead over its subtree: O(nodes x depth). Status: ok; the faults of StreamCursor.
StreamDigest digest(const Source& stream);

/// Outcome of comparing two trees, one or both in streams.
struct StreamComparison {
    Status status;        ///< of the stream with the fault
    bool in_second;       ///< which one that is
    std::uint64_t offset; ///< the byte of the fault
    bool same;            ///< meaningful when status is ok
};

/// Whether two trees have the same leaves, whatever depth their headers state. Ends at the first difference;
/// so the checksums are compared only if there is none. Status: ok; the faults of StreamCursor. Cost:
/// O(nodes).
StreamComparison same_leaves(const Source& a, const Source& b);
StreamComparison same_leaves(const Source& a, const Octree& b);

} // namespace osem

#endif
