// Boolean operators from stream to stream, with O(depth) memory whatever the size of the trees.
#ifndef OSEM_STREAM_BOOLEAN_HPP
#define OSEM_STREAM_BOOLEAN_HPP

#include <cstdint>

#include "osem/boolean.hpp"
#include "osem/stream.hpp"
#include "osem/stream_builder.hpp"
#include "osem/stream_cursor.hpp"

namespace osem {

enum class Becomes : std::uint8_t;

/// Outcome of a Boolean on streams.
struct StreamCombinationOutcome {
    Status status;
    std::uint8_t operand; ///< with a fault of an operand: 0 for a, 1 for b
    std::uint64_t offset; ///< the byte of that fault; else 0
    StreamHeader header;  ///< of the result; meaningful when status is ok
};

/// A Boolean from streams to a stream in progress: begin, step until done, finish. The bytes are those that
/// write_stream gives of Combination's result; colours follow Kleene's three-valued logic as there. The
/// sources are read twice: the first pass checks them whole, if they have not been checked before, and counts
/// the result's nodes, only then is the sink written to. Where the sink can replace, they are read once, in
/// half of the time: what has been written when a fault is met begins without a header then, and is no
/// stream. All state is in the object.
class StreamCombination {
  public:
    /// Starts `a op b`. The result has the greater depth, frame and leaf rule of `a`; whether `b` has the
    /// same frame and rule is the caller's to compare. Status: ok; a fault of an operand's header or first
    /// octant, as StreamCursor::begin; sink_refused, where the sink can replace.
    Status begin(Operator op, const Source& a, const Source& b, const Sink& sink);

    /// Starts the complement of `a` in the root octant.
    Status begin_complement(const Source& a, const Sink& sink);

    /// Visits up to `octants` pairs of octants, nodes of eight leaves counting as one; below a grey octant
    /// that goes by as a whole beside a leaf only the grey ones count. False when nothing is left. In all at
    /// most the octants of both operands, in each pass. An octant costs O(1) and at times a read of at most
    /// 64 bytes or a write of at most 64, or 512 where registers are wide. Of a checked operand's grey
    /// octants up to 48 go by at once, so at times 46 more than asked for; of an indexed one's up to 50.
    bool step(std::uint32_t octants);

    /// Exact progress: each of two passes decides half of the root's volume (2^60 cells), a single one all of
    /// it. What goes by as a whole of a checked operand counts when it is over. Cost: O(depth).
    std::uint64_t decided_volume() const { return decided_cells() / (in_one_pass() ? 1 : 2); }

    /// Status: ok; unfinished; the faults of StreamCursor, the operand named; sink_refused, after which
    /// nothing more was written; source_failed with offset 0 when the second pass read another payload from
    /// the operand than the first one; stream_count_mismatch, operand 0 and offset 0, when the result has
    /// more than 2^32 - 1 nodes.
    StreamCombinationOutcome finish();

  private:
    enum class Phase : std::uint8_t { idle, done, counting, writing };
    enum class Held : std::uint8_t { none, a, b };
    enum class Way : std::uint8_t { each, below, skipped, copied, inverted };

    class CheckedWalk;
    struct Subtree;

    Status start(Operator op, const Source& a, const Source* b, const Sink& sink);
    bool begin_pass();
    void begin_writing(std::uint64_t nodes);
    void end_pass();
    bool in_one_pass() const { return sink_.replace != nullptr; }
    bool is_unchanged();
    bool in_progress() const { return phase_ >= Phase::counting; }
    const StreamCursor& walker() const { return held_ == Held::a ? b_ : a_; }
    std::uint64_t decided_cells() const;
    std::uint64_t cells_before_fault() const;
    inline bool visit(bool may);
    bool visit_below(bool may);
    void hold(std::uint32_t leaf);
    std::uint32_t connected_with_held(std::uint32_t codes) const;
    std::uint32_t step_checked(std::uint32_t most);
    std::uint32_t visit_checked(std::uint32_t most);
    bool end_octants(bool below);
    void begin_rest(const Subtree& subtree);
    void end_checked();
    void begin_below();
    void choose_way(Becomes becomes);
    std::uint32_t pass(std::uint32_t most);
    void end_below();
    void arrive();
    void advance();
    void step_back();
    bool check(const StreamCursor& cursor, unsigned operand);
    void fail(Status status, std::uint8_t operand, std::uint64_t offset);

    StreamCursor a_;
    StreamCursor b_;
    StreamBuilder builder_;
    Source source_a_ = {};
    Source source_b_ = {};
    Sink sink_ = {};
    StreamCombinationOutcome outcome_ = {Status::unfinished, 0, 0, {}};
    std::uint64_t decided_ = 0;    ///< cells, by the passes that are over
    std::uint32_t checksum_a_ = 0; ///< of the first pass
    std::uint32_t checksum_b_ = 0;
    Operator op_ = Operator::unite;
    Phase phase_ = Phase::idle;
    Held held_ = Held::none; ///< the operand that is at a leaf beside a grey octant, and stays there below it
    Way way_ = Way::each;    ///< both operands go on, or what is done below an octant beside a leaf
    bool checked_ =
        false; ///< both operands are: the builder's octants are theirs, and nothing else is followed
    Colour colour_ = Colour::white; ///< of what is skipped
    bool unary_ = false;            ///< there is no b: it is black throughout, and held for good
    std::uint8_t held_level_ = 0;
};

/// In one call: begin, step to the end, finish; status and cost are theirs. `job` is the working memory.
StreamCombinationOutcome combine(StreamCombination& job, Operator op, const Source& a, const Source& b,
                                 const Sink& sink);
StreamCombinationOutcome complement(StreamCombination& job, const Source& a, const Sink& sink);

} // namespace osem

#endif
