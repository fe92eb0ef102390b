// Booleans of two checked streams. Nothing can be wrong in them, so no path is followed in either: they are
// at the octant at which the builder is.
#include "osem/stream_boolean.hpp"
#include "stream/connectives.hpp"
#include "stream/siblings.hpp"
#include "tree/unaligned.hpp"

namespace osem {

namespace {

// Codes of a subtree that go by here: most subtrees end before.
constexpr unsigned small_codes = 256;

// The lower bits of grey codes among those of an octant and its children.
constexpr Codes family = 0x15555U;

constexpr bool is_grey(Codes greys) { return (greys & 1U) != 0; }

// Whether each of two octants is a leaf, or all of its children are.
constexpr bool are_known(Codes greys, Codes other) {
    if constexpr (!has_wide_registers) {
        return (greys == 1 || !is_grey(greys)) && (other == 1 || !is_grey(other));
    }
    return (chosen(is_grey(greys), greys, Codes{0}) | chosen(is_grey(other), other, Codes{0})) <= 1;
}

constexpr std::uint32_t least(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::uint32_t least_of_two = a < b ? a : b;
    return least_of_two < c ? least_of_two : c;
}

} // namespace

// The codes of an operand that come next; of one that is held, its leaf's for ever. In line: calls would be a
// fifth of the instructions.
class StreamCombination::CheckedWalk {
  public:
    [[gnu::always_inline]] CheckedWalk(StreamCursor& cursor, bool is_held)
        : cursor_(cursor), bytes_(is_held ? held_ : cursor.bytes()), bit_(is_held ? 0 : 2 * cursor.at_),
          limit_(is_held ? UINT32_MAX : 2 * cursor.limit_), step_(is_held ? 0 : 2) {
        put_word(held_, static_cast<Codes>(cursor.colour_) * static_cast<Codes>(0x5555555555555555U));
    }

    CheckedWalk(const CheckedWalk&) = delete; // it points into itself
    CheckedWalk& operator=(const CheckedWalk&) = delete;

    [[gnu::always_inline]] Codes codes() const { return codes_at(bytes_, bit_); }

    /// Octants that may be taken until it must be asked again: each has nine codes at most, so before the
    /// last of them there are some. Precondition: now there are.
    [[gnu::always_inline]] std::uint32_t ready() const { return (limit_ - bit_ - 1) / 32 + 1; }

    /// Whether all that is looked at of a small subtree is there: as long as it does not end, all codes of a
    /// look are taken, so the last look is at fewer than small_codes codes from here.
    [[gnu::always_inline]] bool has_small() const { return limit_ > bit_ + 2 * small_codes; }

    /// Takes an octant's code.
    [[gnu::always_inline]] void take() { bit_ += step_; }

    /// Takes codes that have been looked at elsewhere.
    [[gnu::always_inline]] void pass(unsigned codes) { bit_ += 2 * codes; }
    const std::uint8_t* bytes() const { return bytes_; }
    unsigned bit() const { return bit_; }

    /// Takes an octant that is known; what its children are, for a leaf its own code eight times.
    [[gnu::always_inline]] std::uint32_t take_known(Codes codes, Codes greys) {
        const bool grey = is_grey(greys);
        bit_ += step_ + chosen(grey, 16U, 0U);
        const auto leaf = static_cast<std::uint32_t>(codes & 3U);
        return chosen(grey, static_cast<std::uint32_t>(codes >> 2) & 0xffffU, leaf * 0x5555U);
    }

    [[gnu::always_inline]] void end() {
        if (step_ != 0) cursor_.at_ = bit_ / 2;
    }

  private:
    StreamCursor& cursor_;
    const std::uint8_t* bytes_;
    unsigned bit_;
    unsigned limit_;
    unsigned step_;
    std::uint8_t held_[codes_size] = {};
};

// One operand's octant is grey, that of the other one is a leaf: what becomes of it, and what has gone by of
// it.
struct StreamCombination::Subtree {
    bool grey_a;
    unsigned leaf; // its code
    Becomes becomes;
    unsigned codes = 0;        // that have gone by
    std::uint32_t nodes = 0;   // of them
    std::uint32_t to_come = 1; // groups

    bool copied() const { return becomes >= Becomes::copied; }

    // What is there of it goes by if it is small, or its beginning. Returns whether that was all.
    [[gnu::always_inline]] bool pass(CheckedWalk& a, CheckedWalk& b, StreamBuilder::Siblings& siblings) {
        if (becomes == Becomes::connected || !(grey_a ? a : b).has_small()) return false;
        if (copied()) siblings.make_stand();
        siblings.put_grey(copied());
        pass_groups(grey_a ? a.bytes() : b.bytes(), chosen(grey_a, a.bit(), b.bit()), siblings);
        siblings.add_nodes(chosen<std::uint32_t>(copied(), nodes, 0));
        a.pass(chosen(grey_a, codes, 0U));
        b.pass(chosen(grey_a, 0U, codes));
        return to_come == 0;
    }

    // As many as a register holds at a time.
    [[gnu::always_inline]] void pass_groups(const std::uint8_t* bytes, unsigned bit,
                                            StreamBuilder::Siblings& siblings) {
        const std::uint8_t* from = bytes + bit / 8;
        const bool copies = copied();
        const bool inverts = becomes == Becomes::inverted;
        do {
            const Codes next = all_codes_at(from, bit % 8);
            const CodeGroups groups(next);
            const unsigned taken = groups.to_end(to_come, CodeGroups::count);
            const unsigned greys = groups.greys(taken);
            siblings.put_groups(inverts ? complemented(next) : next, taken, copies);
            from += std::size_t{2} * taken;
            codes += 8 * taken;
            nodes += greys;
            to_come += greys - taken;
        } while (to_come != 0 && codes < small_codes);
    }
};

// Goes on, and looks whether that was all.
std::uint32_t StreamCombination::step_checked(std::uint32_t most) {
    const bool each = way_ == Way::each || way_ == Way::below;
    const std::uint32_t steps = each ? visit_checked(most) : pass(most);
    if (!in_progress()) return steps;
    if (!builder_.taken()) {
        fail(Status::sink_refused, 0, 0);
    } else if (builder_.whole()) {
        end_checked();
    }
    return steps;
}

// Visits the octants that come next in both operands, or in the one that goes on below a leaf of the other.
std::uint32_t StreamCombination::visit_checked(std::uint32_t most) {
    const bool below = way_ == Way::below; // one operand goes on, below the level of a leaf of the other
    const bool holds_a = below && held_ == Held::a;
    const bool holds_b = below && held_ == Held::b;
    if ((!holds_a && !a_.is_ready()) || (!holds_b && !b_.is_ready())) {
        if (check(a_, 0)) check(b_, 1);
        return 1;
    }
    CheckedWalk a(a_, holds_a);
    CheckedWalk b(b_, holds_b);
    StreamBuilder::Siblings siblings(builder_);
    const Operator op = op_;
    std::uint32_t granted = least(most, a.ready(), b.ready());
    std::uint32_t left = granted;
    std::uint32_t steps = 0;
    Subtree subtree = {false, 0, Becomes::white};
    bool goes_on = false; // the subtree does, behind this
    while (left != 0) {
        --left;
        const Codes next_a = a.codes();
        const Codes next_b = b.codes();
        const Codes greys_a = grey_codes(next_a) & family;
        const Codes greys_b = grey_codes(next_b) & family;
        if (are_known(greys_a, greys_b)) {
            const std::uint32_t next =
                connected(op, a.take_known(next_a, greys_a), b.take_known(next_b, greys_b));
            if (siblings.leaves(next) && end_octants(below)) break;
            continue;
        }
        a.take();
        b.take();
        if (below || is_grey(greys_a & greys_b)) {
            siblings.open();
            continue;
        }
        const bool grey_a = is_grey(greys_a);
        const auto leaf = static_cast<unsigned>(chosen(grey_a, next_b, next_a) & 3U);
        subtree = {grey_a, leaf, becomes_beside_leaf(op, !grey_a, leaf)};
        // A root beside a leaf is always the former: the leaf's stream has one code.
        goes_on = left == 0 || !subtree.pass(a, b, siblings);
        steps += granted - left + subtree.nodes;
        granted = left = 0;
        if (goes_on) break;
        const bool has_changed = subtree.copied()
                                     ? siblings.end_child()
                                     : siblings.leaves(0x5555U * static_cast<unsigned>(subtree.becomes));
        if ((has_changed && end_octants(false)) || !builder_.taken()) break;
        if (steps < most) granted = left = least(most - steps, a.ready(), b.ready());
    }
    siblings.end();
    a.end();
    b.end();
    if (goes_on) begin_rest(subtree);
    return steps + (granted - left);
}

// Octants are complete: goes on with both operands if they are all of those beside a leaf. Returns whether
// the walk must stop.
bool StreamCombination::end_octants(bool below) {
    if (below && builder_.level() <= held_level_) way_ = Way::each;
    return builder_.whole() || !builder_.taken() || (below && way_ == Way::each);
}

// What has not gone by of a subtree goes on by itself.
void StreamCombination::begin_rest(const Subtree& subtree) {
    held_ = subtree.grey_a ? Held::b : Held::a;
    (subtree.grey_a ? b_ : a_).colour_ = static_cast<Colour>(subtree.leaf);
    held_level_ = static_cast<std::uint8_t>(builder_.level());
    if (subtree.codes == 0) return begin_below();
    choose_way(subtree.becomes);
    (subtree.grey_a ? a_ : b_).to_come_ = subtree.to_come;
}

// Behind the last octants.
void StreamCombination::end_checked() {
    a_.end_checked();
    if (!check(a_, 0)) return;
    b_.end_checked();
    if (!check(b_, 1)) return;
    end_pass();
    if (in_progress()) step_back();
}

} // namespace osem
