#include "osem/stream_boolean.hpp"

#include "stream/codes.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

namespace {

std::uint16_t low_bits(std::uint32_t bits) { return static_cast<std::uint16_t>(bits); }

// Kleene's connectives, on as many codes as there are; exclusive or is (a and not b) or (not a and b).
std::uint32_t connected(Operator op, std::uint32_t a, std::uint32_t b) {
    switch (op) {
    case Operator::unite:
        return a | b;
    case Operator::intersect:
        return a & b;
    case Operator::subtract:
        return a & complemented(b);
    default: // exclusive or
        return (a & complemented(b)) | (complemented(a) & b);
    }
}

constexpr unsigned all_children = 0x5555U; // times a code: that code eight times

// One leaf of each colour, and what a complement makes of them.
constexpr std::uint32_t each_colour = 0b110100;
constexpr std::uint32_t each_complement = 0b000111;
constexpr std::uint32_t three_codes = 0b111111;

} // namespace

// In line, as codes_of is: an octant where both operands are divided goes through each of them twice, and
// calls would be a tenth of its instructions.
[[gnu::always_inline]] inline bool StreamCombination::check(const StreamCursor& cursor,
                                                            std::uint8_t operand) {
    if (cursor.status() == Status::ok) return true;
    fail(cursor.status(), operand, cursor.offset());
    return false;
}

Status StreamCombination::begin(Operator op, const Source& a, const Source& b, const Sink& sink) {
    return start(op, a, &b, sink);
}

Status StreamCombination::begin_complement(const Source& a, const Sink& sink) {
    return start(Operator::exclusive_or, a, nullptr, sink); // with black throughout
}

Status StreamCombination::start(Operator op, const Source& a, const Source* b, const Sink& sink) {
    op_ = op;
    source_a_ = a;
    unary_ = b == nullptr;
    if (!unary_) source_b_ = *b;
    sink_ = sink;
    decided_ = 0;
    outcome_ = StreamCombinationOutcome{Status::unfinished, 0, 0, {}};
    phase_ = Phase::counting;
    builder_.begin();
    if (begin_pass() && in_one_pass()) begin_writing();
    return phase_ == Phase::done ? outcome_.status : Status::ok;
}

bool StreamCombination::begin_pass() {
    held_ = unary_ ? Held::b : Held::none;
    held_level_ = 0;
    way_ = Way::each;
    a_.begin(source_a_);
    if (!check(a_, 0)) return false;
    if (unary_) return true;
    b_.begin(source_b_);
    return check(b_, 1);
}

void StreamCombination::fail(Status status, std::uint8_t operand, std::uint64_t offset) {
    decided_ = decided_cells();
    outcome_.status = status;
    outcome_.operand = operand;
    outcome_.offset = offset;
    phase_ = Phase::done;
}

bool StreamCombination::step(std::uint32_t octants) {
    while (phase_ == Phase::counting || phase_ == Phase::writing) {
        if (octants == 0) return true;
        if (way_ == Way::each) {
            --octants;
            visit();
        } else {
            octants -= pass(octants);
        }
    }
    return false;
}

// The codes of the eight children, where they are known to be leaves: those of a leaf are its own.
[[gnu::always_inline]] inline std::uint16_t StreamCombination::codes_of(const StreamCursor& cursor,
                                                                        bool& known) const {
    std::uint16_t codes = 0;
    if (unary_ && &cursor == &b_) return 0xffffU;
    if (cursor.colour() != Colour::grey) {
        return low_bits(all_children * static_cast<unsigned>(cursor.colour()));
    }
    known = known && cursor.leaf_children(codes);
    return codes;
}

void StreamCombination::visit() {
    const bool grey_a = a_.colour() == Colour::grey;
    const bool grey_b = !unary_ && b_.colour() == Colour::grey;
    bool known = true;
    const std::uint32_t codes_a = codes_of(a_, known);
    const std::uint32_t codes_b = codes_of(b_, known);
    if (known) { // two leaves, or all that is below them
        builder_.leaves(low_bits(connected(op_, codes_a, codes_b)));
    } else if (grey_a != grey_b) {
        begin_below(grey_a ? connected(op_, each_colour, codes_b) : connected(op_, codes_a, each_colour));
    } else {
        builder_.open();
    }
    if (held_ == Held::none && grey_a != grey_b) {
        held_ = grey_a ? Held::b : Held::a;
        held_level_ = static_cast<std::uint8_t>(grey_a ? a_.level() : b_.level());
    }
    if (!builder_.taken()) return fail(Status::sink_refused, 0, 0);
    if (way_ == Way::each) advance(known);
}

// What is done below a grey octant beside a leaf that makes `colours` of one leaf of each colour.
void StreamCombination::begin_below(std::uint32_t colours) {
    colours &= three_codes;
    if (colours == each_colour || colours == each_complement) {
        way_ = colours == each_colour ? Way::copied : Way::inverted;
        builder_.begin_copy();
    } else if (colours == (colours & 3U) * 0b010101U) {
        way_ = Way::skipped;
        builder_.leaf(static_cast<Colour>(colours & 3U));
    } else {
        builder_.open();
    }
}

// Goes on below a grey octant beside a leaf, where none of its parts need be looked at by itself. Returns the
// nodes passed.
std::uint32_t StreamCombination::pass(std::uint32_t most) {
    StreamCursor& walker = held_ == Held::a ? b_ : a_;
    const StreamCursor::Passage passage = walker.pass(held_level_, most);
    if (!check(walker, held_ == Held::a ? 1 : 0)) return 0;
    if (way_ != Way::skipped) {
        builder_.copy(passage.bytes, passage.at, passage.codes, passage.nodes, way_ == Way::inverted);
    }
    if (walker.path_.level() <= held_level_) {
        if (way_ != Way::skipped) builder_.end_copy();
        way_ = Way::each;
        advance(false);
    }
    if (!builder_.taken()) fail(Status::sink_refused, 0, 0);
    return passage.nodes < most ? passage.nodes : most;
}

// Goes on in both, or below a leaf of the held one; behind the children of grey octants, if these are known
// to be leaves. And when that subtree is over, in the held one as well.
void StreamCombination::advance(bool past_leaves) {
    const auto go_on = [past_leaves](StreamCursor& cursor) {
        const bool behind = past_leaves && cursor.colour() == Colour::grey;
        behind ? cursor.pass_leaves() : cursor.next();
    };
    if (held_ != Held::a) go_on(a_);
    if (held_ != Held::b) go_on(b_);
    if (held_ != Held::a && !check(a_, 0)) return;
    if (held_ != Held::b && !check(b_, 1)) return;
    release();
}

void StreamCombination::release() {
    if (held_ != Held::none && !unary_) {
        const StreamCursor& walker = held_ == Held::a ? b_ : a_;
        if (!walker.done() && walker.level() > held_level_) return;
        StreamCursor& held = held_ == Held::a ? a_ : b_;
        const std::uint8_t operand = held_ == Held::a ? 0 : 1;
        held_ = Held::none;
        held.next();
        if (!check(held, operand)) return;
    }
    if (a_.done()) end_pass();
}

// The cells before the octant where the walk stands, in this pass and the one before.
std::uint64_t StreamCombination::decided_cells() const {
    if (phase_ != Phase::counting && phase_ != Phase::writing) return decided_;
    const StreamCursor& walker = held_ == Held::a ? b_ : a_;
    if (walker.done() && walker.path_.whole()) return decided_ + root_volume; // what is behind is wrong
    const int inner = walker.path_.level();
    return decided_ + (way_ == Way::each ? walker.path_.volume_before(walker.level())
                                         : walker.path_.volume_before(inner) + volume_at(inner));
}

// The cursors are at the operands' beginning, and the nodes are counted, if they are to be.
void StreamCombination::begin_writing() {
    StreamHeader& header = outcome_.header;
    header = a_.header();
    if (!unary_ && b_.header().depth > header.depth) header.depth = b_.header().depth;
    header.nodes = static_cast<std::uint32_t>(builder_.nodes());
    phase_ = Phase::writing;
    builder_.begin(header, sink_);
    if (!builder_.taken()) fail(Status::sink_refused, 0, 0);
}

void StreamCombination::end_pass() {
    decided_ += root_volume;
    if (phase_ == Phase::writing) {
        if (!in_one_pass() && !is_unchanged()) return;
        phase_ = Phase::done;
        outcome_.header.nodes = static_cast<std::uint32_t>(builder_.nodes());
        outcome_.status = builder_.finish();
        return;
    }
    // unreachable: by a test in reasonable time, as it takes two streams of gigabytes.
    if (builder_.nodes() > UINT32_MAX) return fail(Status::stream_count_mismatch, 0, 0);
    checksum_a_ = a_.checksum();
    checksum_b_ = b_.checksum();
    if (begin_pass()) begin_writing();
}

// Whether the second pass has read what the first one read, as far as checksums tell.
bool StreamCombination::is_unchanged() {
    const bool same_a = a_.checksum() == checksum_a_;
    const bool same_b = unary_ || b_.checksum() == checksum_b_;
    if (same_a && same_b && builder_.nodes() == outcome_.header.nodes) return true;
    fail(Status::source_failed, same_a && !same_b ? 1 : 0, 0);
    return false;
}

StreamCombinationOutcome StreamCombination::finish() {
    const StreamCombinationOutcome outcome = outcome_;
    phase_ = Phase::idle;
    outcome_.status = Status::unfinished;
    return outcome;
}

StreamCombinationOutcome combine(StreamCombination& job, Operator op, const Source& a, const Source& b,
                                 const Sink& sink) {
    static_cast<void>(job.begin(op, a, b, sink)); // a refusal is finish's as well
    run_to_end(job);
    return job.finish();
}

StreamCombinationOutcome complement(StreamCombination& job, const Source& a, const Sink& sink) {
    static_cast<void>(job.begin_complement(a, sink));
    run_to_end(job);
    return job.finish();
}

} // namespace osem
