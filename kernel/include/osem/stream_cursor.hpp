// A walk over a tree that lies in a stream, without reading it into a pool: octant by octant in preorder.
#ifndef OSEM_STREAM_CURSOR_HPP
#define OSEM_STREAM_CURSOR_HPP

#include <cstddef>
#include <cstdint>

#include "osem/checksum.hpp"
#include "osem/lattice.hpp"
#include "osem/node_pool.hpp"
#include "osem/preorder_path.hpp"
#include "osem/register_word.hpp"
#include "osem/status.hpp"
#include "osem/stream.hpp"

namespace osem {

/// Stands at an octant of a stream and goes on through its payload, reading 64 bytes at a time (fewer at the
/// end), each byte once; what is checked and lies in memory is looked at there, and of what an index leads
/// past nothing is read, or some bytes again. All of its state is in the object, O(depth).
///
/// Faults are found as the walk reaches them: the cursor is then done, and status() names the fault. What
/// lies behind the cursor is well formed, but only a walk to the end has compared the checksum. Of a
/// checked source the payload's faults are not looked for. A cursor may be copied; both then walk on for
/// themselves.
class StreamCursor {
  public:
    /// Reads the header and stands at the root octant. Status: ok; source_failed; stream_truncated or
    /// stream_trailing_bytes when the source's size is not that of the header's node count; the header's
    /// faults and those of the first octant, as StreamReader::finish. When not ok the cursor is done.
    Status begin(const Source& source);

    /// What the header says; meaningful when begin was ok.
    const StreamHeader& header() const { return header_; }

    /// Whether there is no octant to stand at: the walk is over, a fault was met, or nothing was begun.
    bool done() const { return done_; }

    /// The octant it stands at: colour, octant and level. Precondition: not done().
    Colour colour() const { return colour_; }
    /// Cost of octant(): O(level).
    Octant octant() const { return path_.taken(level_); }
    int level() const { return level_; }

    /// Whether the octant is grey and its children are eight leaves, of more than one colour; `codes` is then
    /// their colours, two bits each, child 0 lowest. Cost: O(1).
    bool leaf_children(std::uint16_t& codes) const;

    /// Goes on to the next octant in preorder: the first child of a grey one. Behind the last octant it
    /// compares the checksum and is done. Precondition: not done(). Cost: O(1) and a read every 256 octants.
    void next();

    /// Goes on behind the octant's subtree, whose form is checked on the way. Precondition: not done(). Cost:
    /// O(nodes of the subtree), those of eight leaves in one piece. Of a checked source the form is not
    /// looked at, and up to 32 octants are one piece (16 where pointers have 32 bits). Of an indexed source
    /// two bytes of the index are read for each 64 of the subtree, and of the stream at most 192.
    void skip();

    /// Goes on as next(), but where leaf_children says so behind all eight children.
    void next_or_leaves();

    /// Status: ok; source_failed; stream_too_deep; stream_not_canonical; stream_count_mismatch;
    /// stream_payload_damaged; what begin answered.
    Status status() const { return status_; }

    /// The byte of the stream at which the fault was seen; without a fault the byte of the octant's code.
    std::uint64_t offset() const { return done_ ? offset_ : byte_of(at_ - 1); }

    /// The checksum of the payload read so far; of a walk to the end it is the stream's own. Of a checked
    /// source it is 0 until then. Cost: O(1), but with wide registers some thousand instructions.
    std::uint32_t checksum() const { return checksum_.value(); }

  private:
    friend class StreamCombination;

    /// Codes that went by; where they may be read they are still in the buffer or in memory.
    struct Passage {
        const std::uint8_t* bytes;
        unsigned at;         ///< the first code
        unsigned codes;      ///< how many
        std::uint32_t nodes; ///< how many of them are grey
    };

    /// What a look ahead may touch behind what is read.
    static constexpr unsigned bytes_behind = sizeof(RegisterWord) + 1;

    /// Where the codes that come next are: in a buffer, or in memory where the source's bytes lie.
    struct Window {
        Window() = default;
        Window(const Window& other) { *this = other; }
        Window& operator=(const Window& other);

        /// What is left, what is read, and what a look ahead may touch.
        std::uint8_t buffer[4 + 64 + bytes_behind] = {};
        const std::uint8_t* bytes = nullptr; ///< from begin on
    };

    /// What look says beside the codes of eight children: the octant is grey; it is a leaf, or all of its
    /// children are, of more than one colour; they are of one colour; it cannot be seen from here.
    static constexpr std::uint32_t grey_bit = 1U << 16;
    static constexpr std::uint32_t known_bit = 1U << 17;
    static constexpr std::uint32_t alike_bit = 1U << 18;
    static constexpr std::uint32_t hidden_bit = 1U << 19;

    const std::uint8_t* bytes() const { return window_.bytes; }
    bool is_in_place() const { return window_.bytes != window_.buffer; }
    void fail(Status status, std::uint64_t offset);
    Status read_header();
    bool load();
    bool look_in_place();
    /// Sees to it that the codes of a look ahead, or all that are left, are in the buffer.
    [[gnu::always_inline]] bool is_ready() { return at_ < limit_ || load(); }
    void arrive();
    void pass_leaves();
    void step_back();
    inline std::uint32_t look() const;
    inline void take(std::uint32_t next, bool known);
    Passage pass(int floor, std::uint32_t most, bool read);
    Passage pass_checked(std::uint32_t most, bool read, std::uint32_t behind);
    /// Whether there is an index to go on by. Where codes are to be read they must be in memory.
    bool may_jump(bool read) const { return source_.index != nullptr && (!read || is_in_place()); }
    void jump(std::uint32_t behind, std::uint32_t most, Passage& passage);
    void end();
    void end_checked();
    std::uint64_t byte_of(unsigned code) const { return loaded_ - filled_ + code / 4; }

    Source source_ = {};
    StreamHeader header_ = {};
    PreorderPath path_;
    std::uint64_t loaded_ = 0; ///< the stream's bytes up to here have been read
    std::uint64_t offset_ = 0; ///< of a fault, or of the end
    Checksum checksum_;
    unsigned at_ = 0;           ///< the next code in the buffer
    unsigned limit_ = 0;        ///< before this one, what a look ahead needs is in the buffer
    unsigned filled_ = 0;       ///< bytes of the buffer
    std::uint32_t to_come_ = 0; ///< groups of codes, of a checked subtree that goes by
    Colour colour_ = Colour::white;
    Status status_ = Status::unfinished;
    std::uint8_t level_ = 0;
    bool done_ = true;
    Window window_;
};

// In line: calls would be a tenth of the instructions of a Boolean.
[[gnu::always_inline]] inline void StreamCursor::take(std::uint32_t next, bool known) {
    const bool grey = (next & grey_bit) != 0;
    level_ = static_cast<std::uint8_t>(path_.level_);
    at_ += 1;
    --path_.left_[path_.level_];
    if (grey) {
        --path_.nodes_left_;
        if (!known) return path_.enter(next, (next & alike_bit) != 0);
        at_ += 8;
    }
    if (path_.left_[path_.level_] == 0) path_.close();
}

} // namespace osem

#endif
