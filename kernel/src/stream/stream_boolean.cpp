#include "osem/stream_boolean.hpp"

#include "stream/connectives.hpp"
#include "tree/run_to_end.hpp"

namespace osem {

// The octant that is next: the codes of its children, for a leaf its own eight times, and what is known of
// it. It is hidden where it is not in the buffer, where there is none, and where it must be refused.
inline std::uint32_t StreamCursor::look() const {
    const unsigned left = path_.left_[path_.level_];
    if (left == 0 || at_ >= limit_) return hidden_bit;
    const auto codes = static_cast<std::uint32_t>(codes_at(bytes(), 2 * at_));
    if ((codes & 3U) != static_cast<unsigned>(Colour::grey)) {
        return left == 1 && !path_.may_end() ? hidden_bit : (codes & 3U) * 0x5555U | known_bit;
    }
    if (!path_.may_open()) return hidden_bit;
    const auto below = static_cast<std::uint16_t>(codes >> 2);
    if (!eight_leaves(grey_codes(below))) return below | grey_bit;
    return below | (eight_alike(below) ? grey_bit | alike_bit : grey_bit | known_bit);
}

bool StreamCombination::check(const StreamCursor& cursor, unsigned operand) {
    if (cursor.status() == Status::ok) return true;
    fail(cursor.status(), static_cast<std::uint8_t>(operand), cursor.offset());
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
    checked_ = !unary_ && source_a_.checked && source_b_.checked;
    decided_ = 0;
    outcome_ = StreamCombinationOutcome{Status::unfinished, 0, 0, {}};
    phase_ = Phase::counting;
    builder_.begin();
    if (begin_pass() && in_one_pass()) begin_writing(0);
    if (in_progress()) step_back();
    return phase_ == Phase::done ? outcome_.status : Status::ok;
}

bool StreamCombination::begin_pass() {
    held_ = unary_ ? Held::b : Held::none;
    held_level_ = 0;
    way_ = unary_ ? Way::below : Way::each;
    b_.colour_ = Colour::black;
    a_.begin(source_a_);
    if (!check(a_, 0)) return false;
    if (unary_) return true;
    b_.begin(source_b_);
    return check(b_, 1);
}

void StreamCombination::fail(Status status, std::uint8_t operand, std::uint64_t offset) {
    decided_ = cells_before_fault();
    outcome_.status = status;
    outcome_.operand = operand;
    outcome_.offset = offset;
    phase_ = Phase::done;
}

// The cells before the octant that was arrived at last, or behind what has gone by of one.
std::uint64_t StreamCombination::cells_before_fault() const {
    if (!in_progress() || checked_) return decided_cells();
    const StreamCursor& cursor = walker();
    if (cursor.done() && cursor.path_.whole()) return decided_ + root_volume; // what is behind is wrong
    // Without a read nothing has been arrived at.
    const bool one_by_one =
        (way_ == Way::each || way_ == Way::below) && cursor.status() != Status::source_failed;
    return one_by_one ? decided_ + cursor.path_.volume_before(cursor.level()) : decided_cells();
}

bool StreamCombination::step(std::uint32_t octants) {
    while (in_progress()) {
        if (checked_ || (way_ != Way::each && way_ != Way::below)) { // many at a time, the last of them whole
            if (octants == 0) return true;
            const std::uint32_t steps = checked_ ? step_checked(octants) : pass(octants);
            octants -= steps < octants ? steps : octants;
        } else if (!(way_ == Way::each ? visit(octants != 0) : visit_below(octants != 0))) {
            arrive();
        } else {
            if (octants == 0) return true;
            --octants;
            if (!builder_.taken()) fail(Status::sink_refused, 0, 0);
        }
    }
    return false;
}

// Visits the octants that are next in both operands, if it may; false where one is hidden. In line: calls
// would be a tenth of its instructions.
[[gnu::always_inline]] inline bool StreamCombination::visit(bool may) {
    const std::uint32_t next_a = a_.look();
    const std::uint32_t next_b = b_.look();
    if (((next_a | next_b) & StreamCursor::hidden_bit) != 0) return false;
    if (!may) return true;
    const bool grey_a = (next_a & StreamCursor::grey_bit) != 0;
    const bool grey_b = (next_b & StreamCursor::grey_bit) != 0;
    held_ = grey_a == grey_b ? Held::none : grey_a ? Held::b : Held::a;
    const bool known = (next_a & next_b & StreamCursor::known_bit) != 0; // two leaves, or all that is below
    a_.take(next_a, known);
    b_.take(next_b, known);
    if (known) {
        builder_.leaves(low_bits(connected(op_, next_a, next_b)));
    } else if (grey_a == grey_b) {
        builder_.open();
    } else {
        hold(grey_a ? next_b : next_a);
        begin_below();
    }
    return true;
}

// The held operand stays at this leaf while the other one walks below it.
void StreamCombination::hold(std::uint32_t leaf) {
    StreamCursor& held = held_ == Held::a ? a_ : b_;
    held.colour_ = static_cast<Colour>(leaf & 3U);
    held_level_ = held.level_;
}

// The same below a leaf of the held operand.
bool StreamCombination::visit_below(bool may) {
    StreamCursor& cursor = held_ == Held::a ? b_ : a_;
    const std::uint32_t next = cursor.look();
    if ((next & StreamCursor::hidden_bit) != 0) return false;
    if (!may) return true;
    const bool known = (next & StreamCursor::known_bit) != 0;
    cursor.take(next, known);
    if (known) {
        builder_.leaves(low_bits(connected_with_held(next)));
    } else {
        begin_below();
    }
    if (cursor.path_.level() <= held_level_) way_ = Way::each;
    return true;
}

// What becomes of codes beside the leaf of the held operand.
std::uint32_t StreamCombination::connected_with_held(std::uint32_t codes) const {
    const bool is_a = held_ == Held::a;
    const std::uint32_t held = all_children * static_cast<std::uint32_t>(is_a ? a_.colour_ : b_.colour_);
    return is_a ? connected(op_, held, codes) : connected(op_, codes, held);
}

// What is done below a grey octant beside a leaf of the held operand.
void StreamCombination::begin_below() {
    const bool is_a = held_ == Held::a;
    choose_way(becomes_beside_leaf(op_, is_a, static_cast<unsigned>(is_a ? a_.colour_ : b_.colour_)));
    if (way_ == Way::below) {
        builder_.open();
    } else if (way_ != Way::skipped) {
        builder_.begin_copy();
    }
}

void StreamCombination::choose_way(Becomes becomes) {
    colour_ = static_cast<Colour>(static_cast<unsigned>(becomes) & 3U);
    way_ = becomes == Becomes::copied      ? Way::copied
           : becomes == Becomes::inverted  ? Way::inverted
           : becomes == Becomes::connected ? Way::below
                                           : Way::skipped;
}

// Goes on below a grey octant beside a leaf, where none of its parts need be looked at by itself. Returns the
// nodes passed.
std::uint32_t StreamCombination::pass(std::uint32_t most) {
    StreamCursor& walker = held_ == Held::a ? b_ : a_;
    const bool read = way_ != Way::skipped && builder_.writing_;
    StreamCursor::Passage passage;
    if (checked_) {
        passage = walker.pass_checked(most, read, walker.may_jump(read) ? builder_.behind_next() : 0);
    } else {
        passage = walker.pass(held_level_, most, read);
    }
    if (!check(walker, held_ == Held::a ? 1 : 0)) return 0;
    if (way_ != Way::skipped) {
        builder_.copy(passage.bytes, passage.at, passage.codes, passage.nodes, way_ == Way::inverted);
    }
    const bool over = checked_ ? walker.to_come_ == 0 : walker.path_.level() <= held_level_;
    if (over) end_below();
    if (!builder_.taken()) {
        if (over && !checked_) advance();
        fail(Status::sink_refused, 0, 0);
    }
    return passage.nodes;
}

// Behind what went by as a whole.
void StreamCombination::end_below() {
    way_ == Way::skipped ? builder_.leaf(colour_) : builder_.end_child();
    way_ = Way::each;
}

// Lets the cursors meet what is next: they read on, find a fault, or the end. Then all but the end of a pass
// is as before, so that it can be looked at.
void StreamCombination::arrive() {
    advance();
    if (in_progress()) step_back();
}

// Goes on in both operands, first in the one that was grey, or in that one alone as long as it is below a
// leaf of the held one.
void StreamCombination::advance() {
    const unsigned held = held_ == Held::a ? 0 : 1; // if none is, it is all the same
    StreamCursor& first = held == 0 ? b_ : a_;
    StreamCursor& second = held == 0 ? a_ : b_;
    first.next();
    if (held_ == Held::none) second.next();
    if (!check(first, 1 - held)) return;
    if (!unary_ && way_ != Way::below) { // there what is next is below the leaf
        if (held_ != Held::none) second.next();
        held_ = Held::none;
        way_ = Way::each;
        if (!check(second, held)) return;
    }
    if (first.done()) end_pass();
}

// Back before the octants at which the cursors stand.
void StreamCombination::step_back() {
    if (held_ != Held::a) a_.step_back();
    if (held_ != Held::b) b_.step_back();
}

// The cells before what is next, in this pass and the one before.
std::uint64_t StreamCombination::decided_cells() const {
    if (!in_progress()) return decided_;
    if (checked_) return decided_ + builder_.volume();
    const PreorderPath& path = walker().path_;
    const int level = path.level();
    return decided_ + (level == 0 ? 0 : path.volume_before(level) + volume_at(level));
}

// The cursors are at the operands' beginning, and the nodes are counted, if they are to be.
void StreamCombination::begin_writing(std::uint64_t nodes) {
    StreamHeader& header = outcome_.header;
    header = a_.header();
    if (!unary_ && b_.header().depth > header.depth) header.depth = b_.header().depth;
    header.nodes = static_cast<std::uint32_t>(nodes);
    phase_ = Phase::writing;
    builder_.begin(header, sink_);
    if (!builder_.taken()) fail(Status::sink_refused, 0, 0);
}

void StreamCombination::end_pass() {
    if (phase_ == Phase::writing && !in_one_pass() && !is_unchanged()) return;
    decided_ += root_volume;
    if (phase_ == Phase::writing) {
        phase_ = Phase::done;
        outcome_.header.nodes = static_cast<std::uint32_t>(builder_.nodes());
        outcome_.status = builder_.finish();
        return;
    }
    // unreachable: by a test in reasonable time, as it takes two streams of gigabytes.
    if (builder_.nodes() > UINT32_MAX) return fail(Status::stream_count_mismatch, 0, 0);
    checksum_a_ = a_.checksum();
    checksum_b_ = b_.checksum();
    const std::uint64_t nodes = builder_.nodes();
    builder_.begin(); // as far as it is whole nothing of the next pass is decided
    if (begin_pass()) begin_writing(nodes);
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
