// Where a line or a plane crosses the rows of a grid, one row after the other: quotients whose dividend goes
// up or down by the same number from row to row, like the steps of a stair.
//
// Only their integer part is asked for, at points whose distances are multiples of the octants' side. So
// dividends may be divided by the side first, rounded down: the quotients, rounded down as well, stay the
// same. Divisors and changes are then differences of vertices, or components of a normal, whatever the side
// is.
//
// There are two ways to them. Parts that divide in one instruction divide once for the first row and once for
// the change, and go on by additions, without a branch. Others walk from a guess to the first quotient and
// from each to the next, which in all is as far as the grid is long.
#ifndef OSEM_GRID_STAIR_HPP
#define OSEM_GRID_STAIR_HPP

#include <cstdint>
#include <type_traits>

#include "grid/four.hpp"
#include "grid/octant_grid.hpp"
#include "tree/guesses.hpp"

namespace osem {

/// floor(n / d), floor((n + by) / d), ... clipped to [-1, most], by divisions. Who makes one sees to it that
/// n + k * by fits for all rows asked for. Precondition: d > 0, most >= 0.
template <class Value>
class DividedStair {
  public:
    /// A number divided by d.
    struct Quotient {
        Value value;
        Value rest; ///< in [0, d)

        Quotient(Value d, Value n) : value(n / d), rest(n % d) { borrow(d); }
        void borrow(Value d) {
            const Value below = rest >> (8 * sizeof(Value) - 1); // -1 if it is below 0
            value += below;
            rest += d & below;
        }
    };

    /// How much it rises or falls from row to row; one is borrowed beforehand and mostly given back.
    struct Slope {
        Value d;
        Quotient step;

        Slope(Value divisor, Value change) : d(divisor), step(divisor, change) {
            step.value += 1;
            step.rest -= d;
        }
    };

    /// The guess is for those that walk.
    DividedStair(const Slope& slope, Value n, int most, int /*guess*/)
        : slope_(slope), now_(slope.d, n), most_(most) {}

    int floor() const {
        const Value not_above = now_.value < most_ ? now_.value : most_;
        return static_cast<int>(not_above > -1 ? not_above : -1);
    }
    /// Whether the quotient is in [0, most).
    bool is_within() const {
        using Unsigned = std::make_unsigned_t<Value>; // below 0 is above all
        return static_cast<Unsigned>(now_.value) < static_cast<Unsigned>(most_);
    }
    void next() {
        now_.value += slope_.step.value;
        now_.rest += slope_.step.rest;
        now_.borrow(slope_.d);
    }

    /// The quotient, what it leaves of the dividend, and what it is when another number is added to that; not
    /// clipped.
    Value value() const { return now_.value; }
    Value rest() const { return now_.rest; }
    Value value_with(const Quotient& added) const {
        return now_.value + added.value + (now_.rest >= slope_.d - added.rest ? 1 : 0);
    }

  private:
    Slope slope_;
    Quotient now_;
    int most_;
};

/// Four of them side by side, with 32 bits each and not clipped: quotients modulo 2^32 of dividends that
/// begin at n, n + by_v, n + 2 by_v, n + 3 by_v and change by by_u; then of the next four. Precondition: d <
/// 2^31.
class FourStairs {
    using Stair = DividedStair<std::int64_t>;

  public:
    FourStairs(std::int64_t d, std::int64_t n, std::int64_t by_u, std::int64_t by_v)
        : d_(static_cast<std::uint32_t>(d)), along_u_(Stair::Slope(d, by_u).step) {
        Stair row({d, by_v}, n, 0, 0);
        const Stair first = row;
        std::uint32_t values[4];
        std::uint32_t rests[4];
        for (unsigned k = 0; k < 4; ++k, row.next()) {
            values[k] = static_cast<std::uint32_t>(row.value());
            rests[k] = static_cast<std::uint32_t>(row.rest());
        }
        first_values_ = Four{values[0], values[1], values[2], values[3]};
        first_rests_ = Four{rests[0], rests[1], rests[2], rests[3]};
        const std::int64_t rest = row.rest() - first.rest();
        const std::int64_t borrowed = rest < 0 ? 0 : 1;
        to_next_four_ = Step(row.value() - first.value() + borrowed, rest - d * borrowed);
    }

    /// Stands at the first ones of the next four, the first time of the first four.
    void begin_four() {
        values_ = first_values_;
        rests_ = first_rests_;
        add(to_next_four_, first_values_, first_rests_);
    }
    void next() { add(along_u_, values_, rests_); }
    const Four& values() const { return values_; }

  private:
    // From quotient to quotient; the rest is below 0, as one is borrowed beforehand.
    struct Step {
        std::uint32_t value;
        std::uint32_t rest;

        Step() : value(0), rest(0) {}
        Step(std::int64_t by, std::int64_t left)
            : value(static_cast<std::uint32_t>(by)), rest(static_cast<std::uint32_t>(left)) {}
        explicit Step(const Stair::Quotient& step) : Step(step.value, step.rest) {}
    };

    void add(const Step& step, Four& values, Four& rests) const {
        Four below = {};
        rests += step.rest;
        set_where_negative(below, rests);
        values += step.value + below;
        rests += d_ & below;
    }

    std::uint32_t d_;
    Step along_u_;
    Step to_next_four_;
    Four first_values_ = {}; ///< of the next four
    Four first_rests_ = {};
    Four values_ = {};
    Four rests_ = {};
};

/// The same without a division. Precondition: the guess is in [-1, most]; it only says where to begin.
template <class Value>
class WalkedStair {
  public:
    struct Slope {
        Value d;
        Value by;
        Slope(Value divisor, Value change) : d(divisor), by(change) {}
    };

    WalkedStair(const Slope& slope, Value n, int most, int guess)
        : slope_(slope), value_(guess), rest_(n - guess * slope.d), most_(most) {
        fall();
        rise();
    }

    int floor() const { return value_; }
    bool is_within() const { return value_ >= 0 && value_ < most_; }
    int value() const { return value_; }
    void next() {
        rest_ += slope_.by;
        slope_.by < 0 ? fall() : rise();
    }

  private:
    [[gnu::always_inline]] void rise() {
        for (; rest_ >= slope_.d && value_ < most_; ++value_) rest_ -= slope_.d;
    }
    [[gnu::always_inline]] void fall() {
        for (; rest_ < 0 && value_ >= 0; --value_) rest_ += slope_.d;
    }

    Slope slope_;
    int value_;
    Value rest_; ///< what the value leaves of the dividend
    int most_;
};

/// Two stairs with the same slope: of n, and of n + width.
template <class Value>
class DividedBand {
    using Stair = DividedStair<Value>;

  public:
    struct Slope {
        typename Stair::Slope slope;
        typename Stair::Quotient width;
        Slope(Value d, Value by, Value between) : slope(d, by), width(d, between) {}
    };

    DividedBand(const Slope& slope, Value n, int most, int guess)
        : stair_(slope.slope, n, most, guess), width_(slope.width) {}

    int floor() const { return stair_.floor(); }
    void next() { stair_.next(); }

    /// A bit for each index of the range that is between the two quotients or one of them. Precondition: the
    /// range is in [0, 31] and not empty.
    std::uint32_t bits(const IndexRange& range) const {
        const Value lower = stair_.value();
        const Value upper = stair_.value_with(width_);
        const Value first = lower > range.first ? lower : range.first;
        const Value last = upper < range.last ? upper : range.last;
        const std::uint32_t bits = bits_between(static_cast<unsigned>(first), static_cast<unsigned>(last));
        return first > last ? 0 : bits;
    }

  private:
    Stair stair_;
    typename Stair::Quotient width_;
};

template <class Value>
class WalkedBand {
    using Stair = WalkedStair<Value>;

  public:
    struct Slope {
        typename Stair::Slope slope;
        Value width;
        Slope(Value d, Value by, Value between) : slope(d, by), width(between) {}
    };

    WalkedBand(const Slope& slope, Value n, int most, int guess)
        : lower_(slope.slope, n, most, guess), upper_(slope.slope, n + slope.width, most, lower_.floor()) {}

    int floor() const { return lower_.floor(); }
    void next() {
        lower_.next();
        upper_.next();
    }
    std::uint32_t bits(const IndexRange& range) const {
        return common(range, {lower_.floor(), upper_.floor()}).bits_or_none();
    }

  private:
    Stair lower_;
    Stair upper_;
};

// Parts of 64 bits divide in an instruction and guess at branches; others call a function to divide numbers
// of 64 bits, and lose little by a branch.
template <class Value>
using StairOf = std::conditional_t<guesses_cost_much, DividedStair<Value>, WalkedStair<Value>>;
using EdgeStair = StairOf<std::int32_t>;
using PlaneStair = StairOf<std::int64_t>;
using PlaneBand = std::conditional_t<guesses_cost_much, DividedBand<std::int64_t>, WalkedBand<std::int64_t>>;

/// Stairs or bands side by side: from row to row along u the dividend changes by one number, which is that of
/// the slope, from one such row of rows to the next by another.
template <class Stair>
class OverPlane {
  public:
    OverPlane(const typename Stair::Slope& along_u, std::int64_t n, std::int64_t by_u, std::int64_t by_v,
              int most, int guess)
        : along_u_(along_u), n_(n), by_u_(by_u), by_v_(by_v), most_(most), guess_(guess) {}

    /// The one along u that begins at (u, v).
    Stair at(int u, int v) {
        const Stair stair(along_u_, dividend(u, v), most_, guess_);
        if constexpr (!guesses_cost_much) guess_ = stair.floor(); // others divide
        return stair;
    }

  private:
    std::int64_t dividend(int u, int v) const { return n_ + u * by_u_ + v * by_v_; }

    typename Stair::Slope along_u_;
    std::int64_t n_; ///< the dividend at (0, 0)
    std::int64_t by_u_;
    std::int64_t by_v_;
    int most_;
    int guess_;
};

} // namespace osem

#endif
