// The vector files: cases with the answers of exact arithmetic, written on a host by cross/vectors and
// replayed on every target. A file holds one topic; every number is little-endian.
//
//     bytes  header
//         4  'O' 'S' 'V' 'F'
//         1  version, 1
//         1  topic
//         2  0
//         4  number of cases in all records together
//
//     bytes  record, any number of them
//         4  length of the body; 0xffffffff: no record, the file ends here
//         2  number of cases in the record, 1 or more
//         n  body
//
//     bytes  end
//         4  0xffffffff
//         4  CRC-32 (IEEE 802.3) of all bytes before it
//
// A file that is cut off or changed is noticed by its end. Bodies, where a point is three i32, and a status,
// an axis or a rule is the u8 of the kernel's enumeration (writer and reader are of the same sources):
//
//     solid        u32 vertices, corners, rings, faces; u8 1 with ring tables, else 0; the vertices as
//                  points; the corners as u32; with ring tables rings + 1 and faces + 1 entries as u32
//     leaf         u8: 4 * level + colour
//     tree         u32 nodes (the top included), u32 white, black and boundary leaves; u64 inner and outer
//                  volume; u64 digest; u32 CRC-32 of the tree's stream with the frame of `stream_frame`;
//                  u32 leaves, then the leaves in Morton order; u8 queries, each a point, u8 status and leaf
//     options      u8 depth, u8 leaf rule, u8 winding rule
//
//     orientation  two points a, b; a case is a point q and, for projection along x, y, z and the
//                  `diagonals`, an i64: the value
//     plane        solid of one face, u8 1 if its corners are collinear; a case is a point q and an i64: the
//                  plane's value
//     classify     solid of one face; a case is an octant (point, u8 level) and u8: bit 0 the face meets the
//                  open octant, bit 1 their bounding boxes do not overlap
//     crossing     solid of one face; a case is a point, u8 axis, i32 length and i32: the change of winding
//     frame        origin as a point, i8 shift; a case is a world point, u8 status, the lattice point (0 when
//                  refused), another lattice point, u8 status, its world point (0 when refused)
//     conversion   solid, u8 status of check, u32 where (see below), u8 jobs, each options and a tree. The
//                  check is one case, each job another
//     boolean      u32 pool nodes, two operands (options, solid), u8 rows, each u8 operation and a
//                  tree. A row is a case; its operation is an Operator, or 4: the complement of the first
//     measure      u8 depth, u32 leaves, the leaves in Morton order; for the inner and for the outer solid:
//                  u64 volume, three and six moments as two u64 (the high one first), three u64 areas, i64
//                  Euler characteristic closed and open; u8 labellings, each u8 colours, u8 connectivity, u32
//                  components, each u64 volume, its box as two points, u8 whether it touches the border. The
//                  measures are one case, each labelling another
//     query        two trees, each u8 depth, u32 leaves, the leaves in Morton order; then four lists, each
//                  a u8 count and so many cases. Segments in the first tree: two points, u8 crossings, each
//                  i32 numerator, i32 denominator, u8 axis, u8 colour before, u8 after. Nearest leaves in
//                  it: a point, u8 colours, u8 found, u64 squared distance, a point: the first cell of the
//                  leaf. Neighbours in it: an octant (point, u8 level), u8 axis, u8 high, u8 outside, an
//                  octant, u8 colour. Collisions of the two: the offset as a point, u8 contact
//     csg          options, u8 4, four operands: u8 0 and a tree (u8 depth, u32 leaves, the leaves in
//                  Morton order), or u8 1 and a solid; u32 pool nodes, u8 rows, each u8 tokens and so many
//                  u8: an operand's number, 16 + an Operator, or 32: the complement; then a tree. A row is a
//                  case
//     transform    u32 pool nodes that a result takes at most, u8 depth, u32 leaves, the leaves in Morton
//                  order; u8 cases, each u8 Transform and: place: the vector and the box to keep as three
//                  points, u8 cut at the root, u8 depth, u8 mixed as boundary; reorient: three u8 from, u8
//                  flips; coarsen: u8 depth, u8 mode; enlarge and reduce: an octant (point, u8 level); then
//                  u8 status and, if it is ok, u8 depth, u32 leaves, the leaves and u64 digest
//     slice        u8 depth, u32 leaves, the leaves in Morton order; u8 cases, each u8 axis, i32 cell, u8
//                  level, u8 status, u16 bytes that follow: for each row the bytes of the outer and of the
//                  inner bitmap, u8 runs (white ones too), each u8 pixels and u8 colour
//     stream       two streams, each u32 bytes and the bytes; u8 rows, each u8 operation (as in boolean), u8
//                  whether the result is the first operand, and a tree; u8 damages, each u8 operand, u32
//                  byte, u8 bit: turned over, the operand is refused. A row or a damage is a case
//     surface      u8 depth, u32 leaves, the leaves in Morton order; for the inner and the outer solid, each
//                  a case: for each facing (2 * axis + 1 if to the positive side) u16 faces and u16
//                  squares; u32 cells, i32 Euler characteristic, u32 vertices at which three edges or more
//                  meet
//     fit          u8 1: a solid, u8 jobs, each u8 0 (labelling) or 1 (fitting), options, u32 pool nodes,
//                  u8 depth of the result and a tree. u8 0: u8 depth, u32 leaves, the leaves in Morton order;
//                  u64 inner and outer volume; u8 prunings, each u32 budget, u64 the least volume that any
//                  tree within it loses
//
// `where` is the face for face_not_planar, the vertex for coordinate_off_lattice, the corner for
// index_out_of_range, the ring for ring_too_short, and 0 otherwise.
#ifndef OSEM_CROSS_REPLAY_FORMAT_HPP
#define OSEM_CROSS_REPLAY_FORMAT_HPP

#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"

namespace osem::cross {

constexpr std::uint8_t magic[4] = {'O', 'S', 'V', 'F'};
constexpr std::uint8_t format_version = 1;

/// The diagonals (1, y, z) of a cube, by y and z.
constexpr std::int8_t diagonals[4][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
constexpr std::uint32_t end_marker = 0xffffffff;

enum class Topic : std::uint8_t {
    orientation,
    plane,
    classify,
    crossing,
    frame,
    conversion,
    boolean,
    measure,
    query,
    csg,
    transform,
    slice,
    stream,
    surface,
    fit
};
constexpr std::uint8_t topic_count = 15;
constexpr const char* topic_names[topic_count] = {"orientation", "plane",   "classify", "crossing", "frame",
                                                  "conversion",  "boolean", "measure",  "query",    "csg",
                                                  "transform",   "slice",   "stream",   "surface",  "fit"};

/// The bits of a `classify` answer.
constexpr std::uint8_t answer_meets = 1;
constexpr std::uint8_t answer_minimax = 2;

/// The row of a `boolean` record that is no operator.
constexpr std::uint8_t operation_complement = 4;
constexpr std::uint8_t operation_count = 5;

/// What a `csg` operand or a `fit` record is.
constexpr std::uint8_t operand_tree = 0;
constexpr std::uint8_t operand_solid = 1;

/// The jobs of a solid's `fit` record.
constexpr std::uint8_t job_labelling = 0;
constexpr std::uint8_t job_fitting = 1;

/// The tokens of a `csg` record.
constexpr std::uint8_t token_combine = 16;
constexpr std::uint8_t token_complement = 32;

/// The questions of a `transform` record.
enum class Transform : std::uint8_t { place, reorient, coarsen, enlarge, reduce };

/// What a stream's header says of the world: 1, -2, 0.5 and 1048576 as binary64.
constexpr std::uint64_t stream_frame[4] = {0x3ff0000000000000, 0xc000000000000000, 0x3fe0000000000000,
                                           0x4130000000000000};

constexpr std::uint8_t encoded(int level, Colour colour) {
    return static_cast<std::uint8_t>(4 * level + static_cast<int>(colour));
}
constexpr int encoded_level(std::uint8_t leaf) { return leaf >> 2; }

} // namespace osem::cross

#endif
