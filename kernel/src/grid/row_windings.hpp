// Winding numbers of all reference points of a grid, added up side by side.
#ifndef OSEM_GRID_ROW_WINDINGS_HPP
#define OSEM_GRID_ROW_WINDINGS_HPP

#include <cstddef>
#include <cstdint>

#include "grid/four.hpp"
#include "grid/set_zero.hpp"
#include "grid/stair.hpp"
#include "osem/convert.hpp"

namespace osem {

/// Of a row's first point there is the number, in the first `rows` words; until all is known as a difference:
/// of row (j, 0) from row (j - 1, 0), and of row (j, k) from row (j, k - 1). Of each point there is what its
/// number differs by from the first one of its row: so a row is added to without knowing that.
///
/// These differences are in two's complement, bit b of a row's in one word, a plane of such words for each b:
/// so a row's are added to at once. There are as many planes as they have needed: two as a rule, for -2 to 1;
/// by the odd rule one, as only the lowest bit counts. They lie in the caller's memory, bit b of row r in
/// word (b + 1) * rows + r.
class RowWindings {
  public:
    /// All numbers are 0.
    RowWindings(std::uint32_t* words, std::uint32_t room, int levels, WindingRule rule)
        : first_(words), room_(room), rows_(std::uint32_t{1} << (2 * levels)), levels_(levels), rule_(rule),
          planes_(rule == WindingRule::odd ? 1 : 2) {
        overflowed_ = words_used() > room_;
        if (!overflowed_) set_zero(plane(0), planes_ * rows_);
    }

    /// Whether the memory was too small: the numbers mean nothing then. If it is so from the beginning
    /// nothing may be added.
    bool overflowed() const { return overflowed_; }
    std::uint32_t words_used() const { return (planes_ + 1) * rows_; }
    /// A word for each row behind those in use, if there are any; they may be in use when more is added.
    std::uint32_t* spare_words() const {
        return words_used() + rows_ > room_ ? nullptr : first_ + words_used();
    }

    /// The first number of a row differs from the one before it by so much more.
    void change_first(int row, std::int32_t by) {
        if (level_) set_zero(first_, rows_);
        level_ = false;
        first_[row] += static_cast<std::uint32_t>(by);
    }

    /// Adds a number to those of rows [row, end) behind where a stair ends, which goes from row to row; to
    /// none where it ends before the first point or behind all.
    template <class Stair>
    [[gnu::always_inline]] void add_behind(std::uint32_t row, std::uint32_t end, Stair& last,
                                           std::int32_t number) {
        // Mostly it is 1 or -1 and there are two planes: then without a loop over them.
        if (planes_ == 2 && (number == 1 || number == -1)) add_one_behind(row, end, last, number > 0);
        for (; row != end; ++row, last.next()) {
            if (last.is_within()) add(row, behind(last), number);
        }
    }

    class FourRows;

    /// All is added; the number of the grid's first point is this.
    void finish(std::int32_t winding);

    /// Then: a point's number; by the odd rule any number that is odd when it is.
    std::int32_t at(std::uint32_t row, unsigned i) const;

    /// And at last, as this takes the place of the numbers: which points are inside, a word a row.
    const std::uint32_t* inside();

  private:
    template <class Stair>
    static std::uint32_t behind(const Stair& last) {
        return ~std::uint32_t{1} << static_cast<std::uint32_t>(last.value());
    }
    // Adds 1, or takes it away from numbers if `down` has all bits, while two planes suffice: of what has
    // outgrown them the sign is wrong.
    [[gnu::always_inline]] static std::uint32_t add_one(std::uint32_t* low, std::size_t to_sign,
                                                        std::uint32_t set, std::uint32_t down) {
        const std::uint32_t carry = set & (*low ^ down);
        const std::uint32_t outgrown = carry & ~(low[to_sign] ^ down);
        *low ^= set;
        low[to_sign] ^= carry;
        return outgrown;
    }
    // As add_behind, while two planes suffice; goes on to the row behind.
    template <class Stair>
    [[gnu::always_inline]] void add_one_behind(std::uint32_t& row, std::uint32_t end, Stair& last, bool up) {
        const std::uint32_t down = up ? 0 : ~std::uint32_t{0};
        const std::size_t to_sign = rows_;
        std::uint32_t* const last_low = plane(0) + end;
        for (std::uint32_t* low = plane(0) + row; low != last_low; ++low, last.next()) {
            if (!last.is_within()) continue;
            const std::uint32_t outgrown = add_one(low, to_sign, behind(last), down);
            if (outgrown == 0) continue;
            row = static_cast<std::uint32_t>(low - plane(0));
            widen(row++, outgrown);
            return last.next();
        }
        row = end;
    }
    std::uint32_t* plane(unsigned b) const { return first_ + std::size_t{b + 1} * rows_; }
    void add_power(std::uint32_t row, std::uint32_t set, unsigned from, bool up);
    void add(std::uint32_t row, std::uint32_t set, std::int32_t number);
    void add_to_four(std::uint32_t* low, const Four& added, std::uint32_t down);
    void widen_four(const std::uint32_t* low, const Four& outgrown);
    void widen(std::uint32_t row, std::uint32_t outgrown);
    std::uint32_t first_of(std::uint32_t row) const { return first_[level_ ? 0 : row]; }
    template <class FirstOf>
    void set_where_not_zero(std::uint32_t* low, FirstOf first_of_row) const;
    std::uint32_t inside_of(std::uint32_t row) const;

    std::uint32_t* first_;
    std::uint32_t room_;
    std::uint32_t rows_;
    int levels_;
    WindingRule rule_;
    unsigned planes_;
    bool level_ = true; ///< rows' first numbers are equal: only the first one is valid, when all is added
    bool overflowed_;
};

/// Four rows beside each other, to which 1 or -1 is added; then the four above them, or not. They are added
/// to as one: where nothing is added to one of them, nobody need guess so.
class RowWindings::FourRows {
  public:
    FourRows(RowWindings& windings, int row, std::int32_t number)
        : windings_(windings), low_(windings.plane(0)), row_(static_cast<std::size_t>(row)),
          to_sign_(windings.rows_), to_next_layer_(std::size_t{1} << windings.levels_),
          down_(Four{} + (number > 0 ? 0 : ~std::uint32_t{0})) {}

    /// To a set of each row's points, which does not have the first one.
    [[gnu::always_inline]] void add(const Four& set) {
        std::uint32_t* const low_words = low_ + row_;
        if (windings_.planes_ != 2) {
            const Four added = set; // as what is given by reference stays in memory
            return windings_.add_to_four(low_words, added, down_[0]);
        }
        Four low = {};
        Four sign = {};
        load(low, low_words);
        load(sign, low_words + to_sign_);
        const Four carry = set & (low ^ down_);
        const Four outgrown = carry & ~(sign ^ down_);
        store(low_words, low ^ set);
        store(low_words + to_sign_, sign ^ carry);
        if (!any(outgrown)) return;
        const Four added = outgrown;
        windings_.widen_four(low_words, added);
    }
    [[gnu::always_inline]] void next_layer() { row_ += to_next_layer_; }

  private:
    RowWindings& windings_;
    std::uint32_t* low_; ///< the lowest plane
    std::size_t row_;    ///< the first of the four; behind the last layer there is none
    std::size_t to_sign_;
    std::size_t to_next_layer_;
    Four down_;
};

/// Adds or takes away 2^from, which is less than what the sign stands for.
inline void RowWindings::add_power(std::uint32_t row, std::uint32_t set, unsigned from, bool up) {
    const std::uint32_t rows = rows_;
    std::uint32_t* word = plane(from) + row;
    for (unsigned left = planes_ - from; --left != 0; word += rows) {
        const std::uint32_t before = *word;
        *word = before ^ set;
        set &= up ? before : ~before;
    }
    const std::uint32_t sign = *word;
    *word = sign ^ set;
    set &= up ? ~sign : sign; // a carry that changes the sign the wrong way
    if (set != 0 && planes_ > 1) widen(row, set);
}

} // namespace osem

#endif
