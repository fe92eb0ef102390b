// Where a linear function changes its sign along rows of a grid, by additions.
//
// Only signs are asked for, at points whose distances are multiples of the octants' side. So values may be
// divided by the side first, rounded down: where n steps lead is below 0 before if and only if it is
// afterwards. Steps are then differences of vertices, or components of a normal, whatever the octants' size.
#ifndef OSEM_GRID_COUNT_BELOW_HPP
#define OSEM_GRID_COUNT_BELOW_HPP

#include <cstdint>

namespace osem {

/// How many of `size` values in a row, each greater than the one before it by `step` or equal to it, are
/// below 0, while the row as a whole rises and falls: a stair that is walked from where it was last, without
/// a division. Who makes one sees to it that its values fit.
template <class Value>
class CountBelow {
  public:
    /// Precondition: 0 <= guess <= size, step >= 0. The guess only says where to begin.
    CountBelow(Value first, Value step, int size, int guess)
        : value_(first + guess * step), step_(step), size_(size), count_(guess) {
        rise();
        fall();
    }

    int count() const { return count_; }
    /// The first value that is not below 0, if there is one.
    Value next_value() const { return value_; }
    /// Adds to all values.
    void raise(Value by) {
        value_ += by;
        by < 0 ? rise() : fall();
    }

  private:
    [[gnu::always_inline]] void rise() {
        for (; value_ < 0 && count_ < size_; ++count_) value_ += step_;
    }
    [[gnu::always_inline]] void fall() {
        for (; value_ >= step_ && count_ > 0; --count_) value_ -= step_;
    }

    Value value_; ///< the one behind those counted
    Value step_;
    int size_;
    int count_;
};

/// Values over a plane of rows: those of the first row, and how much all are raised by a step to the next row
/// along u and along v.
struct PlaneOfRows {
    std::int64_t first;
    std::int64_t step;
    std::int64_t step_u;
    std::int64_t step_v;

    std::int64_t change(int u, int v) const { return u * step_u + v * step_v; }
};

/// The same for each of these rows: the count goes from row to row along u, and from one such row of rows to
/// the next from where the last one began.
class CountOverPlane {
  public:
    using Count = CountBelow<std::int64_t>;

    CountOverPlane(const PlaneOfRows& rows, int size, int guess, int u, int v)
        : rows_(rows), at_(rows.first + rows.change(u, v), rows.step, size, guess), u_(u), v_(v) {}

    /// The count at (u, v), to go on from along u by step_u.
    Count at(int u, int v) {
        at_.raise(rows_.change(u - u_, v - v_));
        u_ = u;
        v_ = v;
        return at_;
    }
    std::int64_t step_u() const { return rows_.step_u; }

  private:
    PlaneOfRows rows_;
    Count at_;
    int u_;
    int v_;
};

} // namespace osem

#endif
