// Assembles one canonical stream, octant by octant, in memory fixed beforehand: what TreeBuilder is for
// pools.
#ifndef OSEM_STREAM_BUILDER_HPP
#define OSEM_STREAM_BUILDER_HPP

#include <cstddef>
#include <cstdint>

#include "osem/checksum.hpp"
#include "osem/lattice.hpp"
#include "osem/node_pool.hpp"
#include "osem/register_word.hpp"
#include "osem/status.hpp"
#include "osem/stream.hpp"

namespace osem {

/// The octants are told in preorder; an octant is closed when it has eight children. Eight leaves of one
/// colour become one leaf: while all that an open octant holds are leaves of one colour, it is kept back as
/// one counter a level, so the bytes go out in one pass. The header holds the node count: so there are two
/// passes of the same calls, the first of which counts and the second writes; or one, where the sink can
/// replace the header.
class StreamBuilder {
  public:
    /// Starts a counting pass.
    void begin();
    /// Starts writing to `sink`; header.nodes is the count of a counting pass, unless the sink can replace:
    /// then it means nothing. Precondition: header.leaf_rule is 0 or 1.
    void begin(const StreamHeader& header, const Sink& sink);

    /// The next octant is grey; its eight children follow. Precondition: fewer than max_depth octants are
    /// open, and the root octant is not closed.
    void open();

    /// The next octant is a leaf. Precondition: colour is not grey, and the root octant is not closed.
    void leaf(Colour colour);

    /// The next octant has eight leaf children of these colours, two bits each, child 0 lowest; they may all
    /// be equal. Preconditions: those of open; no code is grey.
    void leaves(std::uint16_t codes);

    /// Whether the root octant is closed.
    bool whole() const { return whole_; }
    /// Level of the next octant.
    int level() const { return level_; }
    /// Grey octants that stand for good.
    std::uint64_t nodes() const { return nodes_; }
    /// Whether the sink has taken everything so far; after a refusal nothing more is written.
    bool taken() const { return taken_; }

    /// Ends the stream. Status: ok; unfinished while the root octant is open; sink_refused;
    /// stream_count_mismatch when there are more than 2^32 - 1 nodes, which no header holds.
    Status finish();

  private:
    friend class StreamCombination;
    friend Status write_stream(const Octree& tree, StreamHeader header, const Sink& sink);

    class Siblings;

    /// Bits that are kept in a register until they are full, and go into the buffer: where registers are wide
    /// a byte, so that what is put out has no branches, else a word.
    static constexpr unsigned unit_bits = has_wide_registers ? 8 : 32;
    /// What goes out at a time.
    static constexpr unsigned piece_size = has_wide_registers ? 512 : 64;

    /// Codes that are on their way into the buffer.
    struct Word {
        RegisterWord bits = 0;
        unsigned used = 0; ///< bits of it in use; fewer than a unit's, between calls
    };

    std::uint32_t behind_next() const;
    std::uint64_t volume() const;
    bool put_canonical(std::uint32_t codes, unsigned count);
    void begin_copy();
    void copy(const std::uint8_t* bytes, unsigned at, unsigned count, std::uint32_t nodes, bool inverted);
    void restart();
    void flush_pending(int end);
    void end_child();
    void close_full();
    void put(RegisterWord codes, unsigned count);
    inline void put(Word& word, RegisterWord codes, unsigned count);
    inline void put_groups(Word& word, RegisterWord codes, unsigned groups, bool stays);
    void end_word(RegisterWord full);
    void write_piece();
    void write(const std::uint8_t* bytes, std::size_t count);

    Sink sink_ = {};
    StreamHeader header_ = {};
    std::uint64_t nodes_ = 0;
    Word word_;
    Checksum checksum_;
    unsigned filled_ = 0; ///< bytes of the buffer; fewer than a piece's, between calls
    int level_ = 0;
    int pending_ = 0;               ///< the open octants from this level on are kept back
    Colour colour_ = Colour::white; ///< of the leaves kept back
    bool has_leaf_ = false;         ///< whether a leaf is kept back
    bool writing_ = false;
    bool taken_ = true;
    bool whole_ = false;
    std::uint8_t children_[max_depth] = {}; ///< complete children of each open octant
    /// A word may begin before a piece's end, and one behind the last copied byte is looked at.
    std::uint8_t buffer_[piece_size + (has_wide_registers ? 2 : 1) * sizeof(RegisterWord)] = {};
};

} // namespace osem

#endif
