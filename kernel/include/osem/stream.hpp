// Trees as bytes: the form that lies in flash, crosses a wire or is written to a file.
//
// A stream is a header, a payload and a trailer; every number is little-endian.
//
//     offset  bytes  header
//          0      4  'O' 'S' 'E' 'M'
//          4      1  version, 2
//          5      1  depth, 1 to 20
//          6      1  leaf rule the tree was converted with (0 conservative, 1 centre)
//          7      1  0
//          8     32  frame: origin x, y, z and side of the world cube that the root covers, each the bits of
//                    an IEEE 754 binary64 (the kernel carries them unread)
//         40      4  node count n: the grey octants; 0 when the root is a leaf
//         44      4  CRC-32 of bytes 0 to 43
//         48 2n + 1  payload: the colours of the 8n + 1 octants, two bits each
//     49 + 2n     4  CRC-32 of the payload
//
// The payload is the tree's depth-first expression (Kawaguchi and Endo, "On a method of binary-picture
// representation and its application to data compression", IEEE PAMI 2(1), 1980): the octants in preorder,
// the eight children of a grey one behind it in Morton order. A colour's code is its number (white 0,
// boundary 1, grey 2, black 3); four codes are packed to a byte, the first one lowest, and the six bits that
// the last byte has left are 0. So a node costs 16 bits, and a tree can be written as it is found, before it
// is known as a whole.
//
// The CRC-32 is that of IEEE 802.3 (polynomial 0x04c11db7, reflected).
#ifndef OSEM_STREAM_HPP
#define OSEM_STREAM_HPP

#include <cstddef>
#include <cstdint>

#include "osem/checksum.hpp"
#include "osem/octree.hpp"
#include "osem/preorder_path.hpp"
#include "osem/tree_builder.hpp"

namespace osem {

constexpr std::size_t stream_header_size = 48;
constexpr std::size_t stream_trailer_size = 4;

/// Bytes of a stream of `nodes` grey octants (0 when the root is a leaf): exact. They are those of
/// measure(tree).nodes: one more than the tree takes from a pool, which does not hold its top node.
constexpr std::uint64_t stream_size(std::uint64_t nodes) {
    return stream_header_size + (2 * nodes + 1) + stream_trailer_size;
}

/// What a header says beside the tree.
struct StreamHeader {
    std::uint8_t depth;
    std::uint8_t leaf_rule;
    std::uint64_t frame[4]; ///< origin x, y, z and side, as the bits of binary64 numbers
    std::uint32_t nodes;    ///< grey octants, the root included; 0 when the root is a leaf
};

/// Takes bytes from the writer; false refuses. `context` is the caller's.
///
/// Where what was written can be written over (memory, a file), `replace` does that with the first `count`
/// bytes of those written for this stream: once at most, behind the last write; a null pointer says that it
/// cannot be. With it the header, which holds the node count, comes
/// last: so what would take a pass to count nodes does without. Until then there are 0s in its place, which
/// no reader takes for a stream.
struct Sink {
    bool (*write)(void* context, const std::uint8_t* bytes, std::size_t count);
    void* context;
    bool (*replace)(void* context, const std::uint8_t* bytes, std::size_t count) = nullptr;
};

/// Reads bytes at any offset of a stream that can be read again: memory, flash, a file. false when they
/// cannot be had. Nobody asks for bytes at or behind `size`. `context` is the caller's.
struct Source {
    bool (*read)(void* context, std::uint64_t offset, std::uint8_t* bytes, std::size_t count);
    void* context;
    std::uint64_t size; ///< bytes of the whole stream
    /// Whether these bytes are known to be a stream, and to be read without a fault: from check_stream, a
    /// StreamReader without a pool, or a host that checked what it put into flash. Then no checksum is
    /// compared, and subtrees that go by as a whole are not looked at octant by octant. What a check would
    /// refuse is undefined behaviour here.
    bool checked = false;
    /// With a checked source: an index of its subtrees, from check_stream; null if there is none. Then most
    /// of a large subtree that goes by as a whole is not even read, unless it is copied.
    const std::uint8_t* index = nullptr;
};

/// Bytes of an index of the subtrees of a stream of `nodes` grey octants: two for 64 of its payload.
constexpr std::uint64_t subtree_index_size(std::uint64_t nodes) { return 2 * ((2 * nodes + 64) / 64); }

/// A stream in memory, which may be flash: the bytes are only read. Where it is checked they are looked at
/// where they lie: they must stay as they are until a job with it is over.
Source memory_source(const std::uint8_t* bytes, std::size_t size);

/// What check_stream found.
struct StreamCheckOutcome {
    Status status;
    std::uint64_t offset; ///< of the byte at which a fault was seen; else of the end
    Source source;        ///< the same, as a checked one if status is ok
};

/// Decides whether bytes, none of which are trusted, are a stream: what is read often is checked once.
/// Status: ok; the faults of StreamCursor. Cost: O(nodes), each byte is read once; O(depth) memory.
StreamCheckOutcome check_stream(const Source& source);

/// The same, and makes an index of the stream's subtrees by the way: `size` bytes at `index` hold it, which
/// must stay there as long as the checked source is used. It may be kept beside the stream, and given to
/// sources of the same bytes. Status: those of check_stream; scratch_too_small where `size` is less than
/// subtree_index_size((source.size - stream_header_size - stream_trailer_size) / 2); nothing is read then.
/// Cost: a third more. Source: one level of the range min-max tree of K. Sadakane and G. Navarro,
/// "Fully-functional succinct trees" (SODA 2010).
StreamCheckOutcome check_stream(const Source& source, std::uint8_t* index, std::size_t size);

/// Writes a tree of up to 2^32 - 1 nodes (shared ones counted as often as they are reached); depth and node
/// count of `header` are filled in from it. Precondition: header.leaf_rule is 0 or 1. Status: ok;
/// sink_refused, after which nothing more is written; stream_count_mismatch for more nodes, if the sink can
/// replace: no header is written then. Cost: O(nodes of the tree), which are walked over
/// twice, or once where the sink can replace; O(depth) memory.
Status write_stream(const Octree& tree, StreamHeader header, const Sink& sink);

/// Outcome of reading a stream. `offset` is that of the byte at which a fault was seen.
struct StreamOutcome {
    TreeOutcome built;
    std::uint64_t offset;
};

/// Reads a stream in chunks of any size: begin, feed until the bytes end, finish. O(depth) memory. It
/// accepts exactly what write_stream writes; on any fault the pool is as it was at begin.
class StreamReader {
  public:
    /// Starts reading into `pool`; null: only validates and counts. Reading that was not finished is given up
    /// first, so its pool must still be there.
    void begin(NodePool* pool);

    /// Takes the next bytes. Status: ok so far; or the first fault, which then stays; unfinished, and nothing
    /// taken, when no reading was begun.
    Status feed(const std::uint8_t* bytes, std::size_t count);

    /// Whether a whole, undamaged header has been read; header() is meaningful from then on.
    bool has_header() const { return has_header_; }
    const StreamHeader& header() const { return header_; }

    /// Ends the stream. Status: ok; stream_truncated, stream_not_osem, stream_header_damaged,
    /// depth_out_of_range, stream_too_deep, stream_not_canonical, stream_count_mismatch,
    /// stream_payload_damaged, stream_trailing_bytes; pool_exhausted with the nodes missing; unfinished when
    /// no reading was begun.
    StreamOutcome finish();

  private:
    void take(std::uint8_t byte);
    void take_header_byte(std::uint8_t byte);
    void take_payload(const std::uint8_t* bytes, std::size_t count);
    unsigned take_codes(std::uint32_t codes, unsigned ready);
    void take_code(Colour code);
    void close_to(int level);
    void take_trailer_byte(std::uint8_t byte);
    void fail(Status status);

    TreeBuilder builder_;
    PreorderPath path_;
    StreamHeader header_ = {};
    std::uint64_t position_ = 0; ///< of the next byte, or of the fault
    Checksum checksum_;
    std::uint32_t crc_read_ = 0;
    Status status_ = Status::unfinished; ///< until begun
    bool has_header_ = false;
    std::uint8_t trailer_left_ = 0;
    std::uint8_t bytes_[stream_header_size] = {};
};

} // namespace osem

#endif
