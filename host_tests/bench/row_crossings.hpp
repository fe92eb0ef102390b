// Where the rows of a grid cross triangles: exact, and without a division a row.
#ifndef OSEM_BENCH_ROW_CROSSINGS_HPP
#define OSEM_BENCH_ROW_CROSSINGS_HPP

#include <algorithm>
#include <cstdint>
#include <utility>

#include "osem/lattice.hpp"

namespace osem::bench {

/// n = value * d + rest with 0 <= rest < d.
struct Quotient {
    std::int64_t value;
    std::int64_t rest;
};

/// Divides by one number again and again. The quotient is guessed with the reciprocal, and set right by its
/// rest, which is an integer: so it is exact. Precondition: d > 0, the product of quotient and d fits.
class Divisor {
  public:
    explicit Divisor(std::int64_t d) : d_(d), reciprocal_(1.0 / static_cast<double>(d)) {}
    std::int64_t d() const { return d_; }

    Quotient floor(std::int64_t n) const {
        Quotient q{static_cast<std::int64_t>(static_cast<double>(n) * reciprocal_), 0};
        q.rest = n - q.value * d_;
        for (; q.rest < 0; q.rest += d_) --q.value;
        for (; q.rest >= d_; q.rest -= d_) ++q.value;
        return q;
    }

  private:
    std::int64_t d_;
    double reciprocal_;
};

/// ceil(n / d) for n, n + step, n + 2 step, ..., step being given by its quotient.
class RisingQuotient {
  public:
    RisingQuotient(const Divisor& divisor, std::int64_t n, const Quotient& step)
        : d_(divisor.d()), now_(divisor.floor(n + d_ - 1)), step_(step) {}
    std::int64_t value() const { return now_.value; }
    void advance() {
        now_.rest += step_.rest;
        const std::int64_t carry = now_.rest >= d_ ? 1 : 0;
        now_.rest -= d_ & -carry;
        now_.value += step_.value + carry;
    }

  private:
    std::int64_t d_;
    Quotient now_;
    Quotient step_;
};

/// The cells of one depth, along any axis: cell i has its centre at i * side + side / 2.
struct Cells {
    int shift; ///< side is 2^shift
    std::int64_t half;

    explicit Cells(int depth) : shift(lattice_bits - depth), half((root_side >> depth) / 2) {}

    /// First cell whose centre is at or above a coordinate.
    std::int64_t from(std::int64_t coordinate) const { return scaled_up(coordinate - half); }
    /// ceil(n / side)
    std::int64_t scaled_up(std::int64_t n) const { return (n + (std::int64_t{1} << shift) - 1) >> shift; }
};

/// A triangle seen along x. Every bound of it in a row is of the form ceil(n / d), and from row to row n
/// changes by a multiple of the cell's side: with ceil(n / (side d)) = ceil(ceil(n / side) / d) the side is
/// shifted out once and what is left steps by small integers. The sums below are plane values of corners and
/// centres: under 2^63, as kernel/DESIGN.md has it.
class RowCrossings {
  public:
    RowCrossings(const Cells& cells, const Point& a, const Point& b, const Point& c)
        : cells_(cells), low_(&a), middle_(&b), high_(&c) {}

    /// Calls span(row z, first row y, end of y) before, and then cross(x, enters) for each y in turn: x is
    /// the first cell whose centre is at or behind the triangle, enters says whether the row comes from
    /// outside.
    template <class Span, class Cross>
    void visit(const Span& span, const Cross& cross) {
        sort_along_z();
        const std::int64_t first = cells_.from(low_->z());
        const std::int64_t end = cells_.from(high_->z());
        if (first == end || misses_rows_along_y()) return;
        set_plane();
        if (x_ == 0) return;
        const std::int64_t change = std::min(std::max(cells_.from(middle_->z()), first), end);
        RisingQuotient whole = edge(*low_, *high_, first);
        if (first < change) {
            RisingQuotient part = edge(*low_, *middle_, first);
            visit_rows(first, change, whole, part, span, cross);
        }
        if (change < end) {
            RisingQuotient part = edge(*middle_, *high_, change);
            visit_rows(change, end, whole, part, span, cross);
        }
    }

  private:
    void sort_along_z() {
        if (middle_->z() < low_->z()) exchange(low_, middle_);
        if (high_->z() < middle_->z()) exchange(middle_, high_);
        if (middle_->z() < low_->z()) exchange(low_, middle_);
    }
    void exchange(const Point*& a, const Point*& b) {
        std::swap(a, b);
        is_turned_ = !is_turned_;
    }
    bool misses_rows_along_y() const {
        const auto [least, greatest] = std::minmax({low_->y(), middle_->y(), high_->y()});
        return cells_.from(least) == cells_.from(greatest);
    }

    // The normal, turned so that x_ > 0, and the plane's value at the centre of row (0, 0).
    void set_plane() {
        const std::int64_t ux = middle_->x() - low_->x(), vx = high_->x() - low_->x();
        const std::int64_t uy = middle_->y() - low_->y(), vy = high_->y() - low_->y();
        const std::int64_t uz = middle_->z() - low_->z(), vz = high_->z() - low_->z();
        x_ = uy * vz - uz * vy;
        y_ = uz * vx - ux * vz;
        z_ = ux * vy - uy * vx;
        middle_is_right_ = x_ > 0;
        enters_ = (x_ < 0) != is_turned_;
        if (x_ < 0) {
            x_ = -x_;
            y_ = -y_;
            z_ = -z_;
        }
        at_origin_ = cells_.scaled_up(x_ * (low_->x() - cells_.half) + y_ * (low_->y() - cells_.half) +
                                      z_ * (low_->z() - cells_.half));
    }

    // First y whose centre is at or right of the line from a up to b, in row z and those above.
    RisingQuotient edge(const Point& a, const Point& b, std::int64_t z) const {
        const std::int64_t rise = b.z() - a.z();
        const std::int64_t run = b.y() - a.y();
        const std::int64_t at_zero = (a.y() - cells_.half) * rise - run * (a.z() - cells_.half);
        const Divisor divisor(rise);
        return {divisor, cells_.scaled_up(at_zero) + run * z, divisor.floor(run)};
    }

    template <class Span, class Cross>
    void visit_rows(std::int64_t first, std::int64_t end, RisingQuotient& whole, RisingQuotient& part,
                    const Span& span, const Cross& cross) {
        const Divisor divisor(x_);
        const Quotient step = divisor.floor(-y_);
        for (std::int64_t z = first; z < end; ++z, whole.advance(), part.advance()) {
            const std::int64_t left = middle_is_right_ ? whole.value() : part.value();
            const std::int64_t right = middle_is_right_ ? part.value() : whole.value();
            if (left >= right) continue;
            span(z, left, right);
            RisingQuotient x(divisor, at_origin_ - y_ * left - z_ * z, step);
            for (std::int64_t y = left; y < right; ++y, x.advance()) cross(x.value(), enters_);
        }
    }

    Cells cells_;
    const Point* low_;
    const Point* middle_;
    const Point* high_;
    std::int64_t x_ = 0;
    std::int64_t y_ = 0;
    std::int64_t z_ = 0;
    std::int64_t at_origin_ = 0;
    bool is_turned_ = false;       ///< sorting has reversed the corners' order
    bool middle_is_right_ = false; ///< of the edge from low to high, y growing to the right
    bool enters_ = false;
};

} // namespace osem::bench

#endif
