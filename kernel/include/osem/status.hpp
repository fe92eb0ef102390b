// What a public function answers when data, memory or a range stands in the way.
#ifndef OSEM_STATUS_HPP
#define OSEM_STATUS_HPP

#include <cstdint>

namespace osem {

enum class Status : std::uint8_t {
    ok,

    // Frame.
    point_outside_frame, ///< a world point maps to no lattice point of the root octant
    shift_out_of_range,  ///< a frame's shift is outside [-31, 20]

    // Solid.
    scratch_too_small,  ///< the caller's scratch is shorter than the stated equation
    ring_table_invalid, ///< a table descends or runs past what it indexes, a face has no ring, or only one
                        ///< of the two tables is there, or a triangle mesh's corners are not 3 a face
    index_out_of_range, ///< a corner names a vertex that does not exist
    coordinate_off_lattice, ///< a vertex coordinate is below 0 or above 2^20
    ring_too_short,         ///< a ring has fewer than three corners
    face_not_planar,        ///< a corner lies off the plane of its face
    surface_not_closed,     ///< an edge is used more often in one direction than in the other

    // Octree.
    depth_out_of_range, ///< depth outside [1, 20], or above 19 with centre leaves
    pool_exhausted,     ///< the pool has too few free nodes; the number missing is reported beside it
    unfinished,         ///< finish was called before step had said that nothing is left
    pools_differ,       ///< operands or result live in different pools
    pool_read_only,     ///< the pool's nodes are constants and cannot be moved
    point_off_root,     ///< a query point or a bound of a query box lies outside the root octant
    box_empty,          ///< a query box holds no cell

    // Stream.
    stream_truncated,       ///< the stream ends before its node count is reached
    stream_not_osem,        ///< the first bytes are not an Osem header of a known version
    stream_header_damaged,  ///< the header's checksum does not match, or a field has a value no writer gives
                            ///< it
    stream_payload_damaged, ///< the payload's checksum does not match, or bits behind its last code are not 0
    stream_too_deep,        ///< a grey octant stands at the stated depth
    stream_not_canonical,   ///< a grey octant has eight leaves of one colour
    stream_count_mismatch,  ///< the payload holds more or fewer grey octants than the header says
    stream_trailing_bytes,  ///< bytes follow the end of the stream
    sink_refused,           ///< the caller's sink did not take a write

    // Slice.
    level_out_of_range, ///< pixels smaller than the tree's leaves at its depth

    // Query.
    coordinate_out_of_range, ///< a query's coordinate, offset or distance is outside its stated range

    // Source of a stream.
    source_failed, ///< the caller's source did not give the bytes asked for

    // Transform.
    part_leaves_root, ///< a leaf that is not white would come to lie outside the root octant
    depth_too_coarse, ///< the result is not exact at the depth asked for
    octant_invalid,   ///< an octant's level is above 20, or its corner no multiple of its side in the root
    symmetry_invalid, ///< the axes of a symmetry are no permutation, or its flips are out of range

    // Expression.
    expression_invalid, ///< a token takes more values than there are, or the tokens leave more than one value
    expression_too_large, ///< more tokens, operands or repeated operands than the stated bounds
    operand_repeated,     ///< two operands of an expression are the same object
};

/// One short lower-case English phrase for a status, without a full stop; never null.
const char* describe(Status status);

} // namespace osem

#endif
