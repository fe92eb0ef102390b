// Codes on their way into a stream, kept in registers while octants of one parent are told.
#ifndef OSEM_STREAM_SIBLINGS_HPP
#define OSEM_STREAM_SIBLINGS_HPP

#include "osem/stream_builder.hpp"
#include "stream/codes.hpp"
#include "tree/unaligned.hpp"

namespace osem {

/// At most 28 codes where registers are wide, else 15; or none.
[[gnu::always_inline]] inline void StreamBuilder::put(Word& word, Codes codes, unsigned count) {
    word.bits |= codes << word.used;
    word.used += 2 * count;
    if constexpr (has_wide_registers) {
        put_word(buffer_ + filled_, word.bits);
        filled_ += word.used / 8;
        word.bits >>= word.used & ~7U;
        word.used %= 8;
        if (filled_ >= piece_size) write_piece();
    } else if (word.used >= codes_bits) {
        word.used -= codes_bits;
        end_word(word.bits);
        word.bits = codes >> (2 * count - word.used);
    }
}

/// Groups of eight codes, from one to as many as a word holds, if they stay.
[[gnu::always_inline]] inline void StreamBuilder::put_groups(Word& word, Codes codes, unsigned groups,
                                                             bool stays) {
    if constexpr (has_wide_registers) {
        put_word(buffer_ + filled_, word.bits | codes << word.used);
        filled_ += chosen(stays, 2 * groups, 0U);
        const Codes begun = codes >> 1 >> (16 * groups - 1 - word.used) & ((Codes{1} << word.used) - 1);
        word.bits = chosen(stays, begun, word.bits);
        if (filled_ >= piece_size) write_piece();
    } else if (!stays) {
        return;
    } else if (groups != CodeGroups::count) {
        put(word, codes & ((Codes{1} << (16 * groups)) - 1), 8 * groups);
    } else {
        end_word(word.bits | codes << word.used);
        word.bits = codes >> 1 >> (codes_bits - 1 - word.used);
    }
}

/// What a builder is told of leaves whose parent stands for good changes a word and two counters. In between
/// begin and end, only this may use the builder. In line: calls would be a third of the instructions of a
/// Boolean.
class StreamBuilder::Siblings {
  public:
    [[gnu::always_inline]] explicit Siblings(StreamBuilder& builder) : builder_(builder) { begin(); }

    [[gnu::always_inline]] void begin() {
        word_ = builder_.word_;
        const int level = builder_.level_;
        stands_ = builder_.pending_ == level && level != 0;
        complete_ = &builder_.children_[level != 0 ? level - 1 : 0];
    }

    [[gnu::always_inline]] void end() {
        builder_.word_ = word_;
        builder_.nodes_ += nodes_;
        nodes_ = 0;
    }

    [[gnu::always_inline]] void open() {
        builder_.open();
        stands_ = false;
    }

    /// As StreamBuilder::leaves; false if only the parent's count of complete children has changed.
    [[gnu::always_inline]] bool leaves(std::uint32_t codes) {
        const bool alike = codes == (codes & 3U) * 0x5555U;
        if (stands_) {
            constexpr auto grey = static_cast<std::uint32_t>(Colour::grey);
            nodes_ += chosen(alike, 0U, 1U);
            builder_.put(word_, chosen(alike, codes & 3U, grey | codes << 2), chosen(alike, 1U, 9U));
            return end_child();
        }
        builder_.word_ = word_;
        alike ? builder_.leaf(static_cast<Colour>(codes & 3U))
              : builder_.leaves(static_cast<std::uint16_t>(codes));
        begin();
        return true;
    }

    /// The next octant will be grey: its parent stands for good. Precondition: it is not the root.
    [[gnu::always_inline]] void make_stand() {
        if (stands_) return;
        builder_.word_ = word_;
        builder_.flush_pending(builder_.level_);
        begin();
    }

    /// The next octant is grey, if it stays, and groups of codes below it. Its parent stands then.
    [[gnu::always_inline]] void put_grey(bool stays) {
        constexpr auto grey = static_cast<Codes>(Colour::grey);
        nodes_ += chosen(stays, 1U, 0U);
        builder_.put(word_, chosen(stays, grey, Codes{0}), chosen(stays, 1U, 0U));
    }
    [[gnu::always_inline]] void put_groups(Codes codes, unsigned groups, bool stays) {
        builder_.put_groups(word_, codes, groups, stays);
    }
    [[gnu::always_inline]] void add_nodes(std::uint32_t nodes) { nodes_ += nodes; }

    /// The next octant is complete: all of its codes have been put. False as by leaves.
    [[gnu::always_inline]] bool end_child() {
        if (++*complete_ != 8) return false;
        builder_.word_ = word_;
        builder_.close_full();
        begin();
        return true;
    }

  private:
    StreamBuilder& builder_;
    Word word_;               ///< the one that is being filled
    std::uint8_t* complete_;  ///< children of the parent
    std::uint32_t nodes_ = 0; ///< that the builder does not know of
    bool stands_;             ///< whether the parent does, and is not the root's
};

} // namespace osem

#endif
