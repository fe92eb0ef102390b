// Slices: one layer of cells of a tree, row by row, as packed bitmaps or as runs, for printers, lasers,
// milling machines and displays. Whatever the depth, no more than one row is ever held.
//
// A row is found by going down to it from the root, choosing children by the bits of the layer's and the
// row's coordinates: the row of a quadtree (Samet, "Applications of Spatial Data Structures", 1990, on raster
// output), the quadtree being the tree's section.
#ifndef OSEM_SLICE_HPP
#define OSEM_SLICE_HPP

#include <cstddef>
#include <cstdint>

#include "osem/lattice.hpp"
#include "osem/octree.hpp"
#include "osem/status.hpp"

namespace osem {

/// The layer of cells [cell, cell + 1) along `axis`, in pixels of `level`: squares of root_side >> level
/// cells a side, one cell thick; a row has 2^level pixels and the slice as many rows. At the tree's depth a
/// pixel lies in one leaf and has its colour. A pixel of several leaves is white or black only if the layer's
/// part in it is so throughout, else boundary.
///
/// The first of the two other axes runs along a row, the second from row to row: axis x has y along the row
/// and rows upwards in z, axis y x and z, axis z x and y.
struct Slice {
    Axis axis;
    std::int32_t cell;  ///< in [0, 2^20)
    std::uint8_t level; ///< in [0, the tree's depth]
};

/// Pixels of one colour side by side in a row. Runs are maximal: neighbours differ in colour.
struct PixelRun {
    std::int32_t row;    ///< in pixels
    std::int32_t start;  ///< the first pixel
    std::int32_t length; ///< pixels, 1 or more
    Colour colour;       ///< never grey
};

/// Walks the runs of one row at a time, with O(depth) state, white ones included:
/// for (walk.enter(row); walk.next(run);) ...
class RowWalk {
  public:
    /// Starts a slice, with no row entered: next answers false. Status: ok; point_off_root when the cell is
    /// outside [0, 2^20); level_out_of_range when the level is above the tree's depth.
    Status begin(const Octree& tree, const Slice& slice);

    /// Goes to the start of a row in [0, rows()); what was left of another one is dropped.
    void enter(std::int32_t row);

    /// Takes the row's next run; false at its end. All of a row's runs together visit only the nodes whose
    /// octants meet the row, each once.
    bool next(PixelRun& run);

    /// Rows of the slice, and pixels of each.
    std::int32_t rows() const { return std::int32_t{1} << slice_.level; }

    /// Nodes visited since begin.
    std::uint64_t nodes_visited() const { return visited_; }

  private:
    struct Frame {
        Node node;
        std::uint8_t left; ///< children of the row, or of the pixel, that are not done
    };
    std::uint8_t in_layer(int level) const;
    std::uint8_t in_row(int level) const;
    bool next_piece(std::int32_t& length, Colour& colour);
    Colour pixel_of(const Node& node, int level);

    const NodePool* pool_ = nullptr;
    Node top_ = {};
    Slice slice_ = {};
    int level_ = -1; ///< of the frame in use
    std::int32_t row_ = 0;
    std::int32_t at_ = 0;           ///< the first pixel that no run has taken
    std::int32_t piece_length_ = 0; ///< of a piece that was looked at and not taken; 0: none
    Colour piece_colour_ = Colour::white;
    std::uint64_t visited_ = 0;
    Frame frames_[max_depth] = {};
};

/// Outcome of handing out a slice.
struct SliceOutcome {
    Status status;
    std::int32_t rows;     ///< rows handed out in full
    std::uint64_t visited; ///< nodes visited
};

/// Takes runs; false refuses. `context` is the caller's.
struct RunSink {
    bool (*take)(void* context, const PixelRun& run);
    void* context;
};

/// A slice as runs, rows ascending and runs from left to right. White runs are left out: what no run covers
/// is white, and a white row gives none. Memory: O(depth), all of it in the job.
class RunSlicing {
  public:
    /// Status: as RowWalk::begin. The tree is read only and has to stay until the slice is finished.
    Status begin(const Octree& tree, const Slice& slice, const RunSink& sink);

    /// Hands out up to `rows` rows; false when none is left or the sink has refused. Cost: O(nodes that meet
    /// the rows), a row at least one node.
    bool step(std::uint32_t rows);

    /// Status: ok; sink_refused (the sink is not called again); unfinished, also without a begin.
    SliceOutcome finish();

  private:
    RowWalk walk_;
    RunSink sink_ = {};
    std::int32_t row_ = 0;
    Status status_ = Status::unfinished;
};

/// Which pixels a bitmap sets. The masks of a node's children are the same two bits.
enum class Bits : std::uint8_t {
    outer, ///< black and boundary: what can hold solid (`may`)
    inner, ///< black: what is solid throughout (`must`)
    both,  ///< two bitmaps of the row: first outer, then inner
};

/// Bytes of one row of one bitmap: a bit a pixel.
constexpr std::size_t slice_row_bytes(int level) { return ((std::size_t{1} << level) + 7) / 8; }

/// Bytes of buffer that a slice needs: one row, or with Bits::both two bitmaps of one.
constexpr std::size_t slice_buffer(int level, Bits bits) {
    return slice_row_bytes(level) * (bits == Bits::both ? 2 : 1);
}

/// Takes the bytes of a row, slice_buffer(level, bits) of them, which are overwritten afterwards; false
/// refuses. Pixel i is bit 7 - i % 8 of byte i / 8 of its bitmap: the leftmost pixel is the highest bit, as
/// in PBM and PNG. Bits past the last pixel (levels below 3) are 0. `context` is the caller's.
struct RowSink {
    bool (*take)(void* context, std::int32_t row, const std::uint8_t* bytes, std::size_t count);
    void* context;
};

/// A slice as packed bitmaps, rows ascending; white rows are handed out like all others.
class BitmapSlicing {
  public:
    /// `buffer` has to stay until the slice is finished; its first slice_buffer(level, bits) bytes are used.
    /// Status: as RowWalk::begin; scratch_too_small.
    Status begin(const Octree& tree, const Slice& slice, Bits bits, std::uint8_t* buffer,
                 std::size_t buffer_size, const RowSink& sink);

    /// As RunSlicing::step; a row also costs its bytes.
    bool step(std::uint32_t rows);

    /// As RunSlicing::finish.
    SliceOutcome finish();

  private:
    void draw(std::int32_t row);

    RowWalk walk_;
    RowSink sink_ = {};
    Bits bits_ = Bits::outer;
    std::uint8_t* buffer_ = nullptr;
    std::size_t used_ = 0; ///< bytes of the buffer
    std::int32_t row_ = 0;
    Status status_ = Status::unfinished;
};

} // namespace osem

#endif
