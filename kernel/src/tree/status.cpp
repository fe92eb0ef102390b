#include "osem/status.hpp"

namespace osem {

const char* describe(Status status) {
    switch (status) {
    case Status::ok:
        return "ok";
    case Status::point_outside_frame:
        return "point lies outside the frame";
    case Status::shift_out_of_range:
        return "frame shift is out of range";
    case Status::scratch_too_small:
        return "scratch memory is too small";
    case Status::ring_table_invalid:
        return "ring table is invalid";
    case Status::index_out_of_range:
        return "vertex index is out of range";
    case Status::coordinate_off_lattice:
        return "coordinate is off the lattice";
    case Status::ring_too_short:
        return "ring has fewer than three corners";
    case Status::face_not_planar:
        return "face is not planar";
    case Status::surface_not_closed:
        return "surface is not closed";
    case Status::depth_out_of_range:
        return "depth is out of range";
    case Status::pool_exhausted:
        return "pool has too few free nodes";
    case Status::unfinished:
        return "work was given up before it was done";
    case Status::pools_differ:
        return "trees are of different pools";
    case Status::pool_read_only:
        return "pool is read only";
    case Status::point_off_root:
        return "point lies outside the root octant";
    case Status::box_empty:
        return "box holds no cell";
    case Status::stream_truncated:
        return "stream ends too early";
    case Status::stream_not_osem:
        return "not an Osem stream of a known version";
    case Status::stream_header_damaged:
        return "header is damaged";
    case Status::stream_payload_damaged:
        return "payload is damaged";
    case Status::stream_too_deep:
        return "an octant is divided below the stated depth";
    case Status::stream_not_canonical:
        return "a node has eight equal leaves";
    case Status::stream_count_mismatch:
        return "node count does not match the nodes";
    case Status::stream_trailing_bytes:
        return "bytes follow the end of the stream";
    case Status::sink_refused:
        return "sink refused a write";
    case Status::level_out_of_range:
        return "level is deeper than the tree";
    case Status::coordinate_out_of_range:
        return "coordinate is out of range";
    case Status::source_failed:
        return "source could not be read";
    case Status::part_leaves_root:
        return "a part would leave the root octant";
    case Status::depth_too_coarse:
        return "result is not exact at that depth";
    case Status::octant_invalid:
        return "not an octant of the root";
    case Status::symmetry_invalid:
        return "not a symmetry of the cube";
    case Status::expression_invalid:
        return "expression is not well formed";
    case Status::expression_too_large:
        return "expression is too large";
    case Status::operand_repeated:
        return "two operands are the same object";
    }
    return "unknown status";
}

} // namespace osem
