// Where a plane crosses the rows of a grid, as numbers in fixed point: one addition from each to the next.
#ifndef OSEM_GRID_FIXED_QUOTIENTS_HPP
#define OSEM_GRID_FIXED_QUOTIENTS_HPP

#include <cstdint>

#include "tree/zeros.hpp"

namespace osem {

/// 1 / d in fixed point. Precondition: d is in [1, 2^41].
class Reciprocal {
  public:
    static constexpr int fraction_bits = 50;

    explicit Reciprocal(std::int64_t d) : Reciprocal(static_cast<std::uint64_t>(d), zeros_above(d)) {}

    /// a / d in units of 2^-50: up to 10 more or less than that; for |a| <= 32 d up to 1 more and 4 less.
    /// Precondition: |a| <= 2^11 d.
    std::int64_t times(std::int64_t a) const {
        return upper_half(a * (std::int64_t{1} << (shift_ - 12)), value_); // at most half of d << shift, 2^63
    }

  private:
    // A first number of 31 bits, from below; then one step of Newton's. What its product with d << shift
    // lacks is up to 2^-30 of the whole, and the square of that is left out.
    Reciprocal(std::uint64_t d, unsigned shift) : shift_(shift) {
        const std::uint64_t place = d << shift; // its highest bit is set
        const std::uint64_t upper = place >> 32;
        const std::uint64_t lower = place & 0xffffffffU;
        const std::uint64_t first = (std::uint64_t{1} << 63) / (upper + 1);
        const std::uint64_t left = (std::uint64_t{1} << 63) - (upper * first + (lower * first >> 32));
        value_ = (first << 31) + (first * (left >> 2) >> 30);
    }

    static unsigned zeros_above(std::int64_t d) {
        const auto number = static_cast<std::uint64_t>(d);
#if OSEM_COUNTS_ZEROS
        return static_cast<unsigned>(__builtin_clzll(number));
#else
        unsigned zeros = 0;
        for (unsigned step = 32; step != 0; step >>= 1) {
            if (number << zeros >> (64 - step) == 0) zeros += step;
        }
        return zeros;
#endif
    }
    // Of a product, without the product of the lower halves and what is below: up to 2 less.
    static std::int64_t upper_half(std::int64_t a, std::uint64_t b) {
        const std::int64_t a_upper = a >> 32;
        const std::int64_t a_lower = a & 0xffffffff;
        const auto b_upper = static_cast<std::int64_t>(b >> 32);
        const auto b_lower = static_cast<std::int64_t>(b & 0xffffffffU);
        return a_upper * b_upper + (a_upper * b_lower >> 32) + (a_lower * b_upper >> 32);
    }

    std::uint64_t value_; ///< 2^126 / (d << shift), up to 1 more or 13 less
    unsigned shift_;
};

/// floor((n + u * by_u + v * by_v) / d), for u and v in [0, 31].
///
/// What is kept is the quotient in units of 2^-50, and a little more: less than 1 / d more, which is 512
/// units at least, so it rounds down to the same number. The three numbers that it is made of are up to 10 +
/// 31 * 4 + 31 * 4 units less than they should be, or 10 + 31 + 31 more; and 260 are added.
class FixedQuotients {
  public:
    /// Preconditions: d is in [1, 2^41], most in [0, 32].
    FixedQuotients(std::int64_t d, std::int64_t n, std::int64_t by_u, std::int64_t by_v, int most)
        : is_steep_(is_beyond(by_u, 32 * d) || is_beyond(by_v, 32 * d)), is_far_(is_beyond(n, 2048 * d)),
          end_(static_cast<std::uint64_t>(most) * (std::uint64_t{1} << Reciprocal::fraction_bits)) {
        if (is_steep_ || is_far_) return;
        const Reciprocal reciprocal(d);
        first_ = reciprocal.times(n) + 260;
        by_u_ = reciprocal.times(by_u);
        by_v_ = reciprocal.times(by_v);
    }

    /// Whether there are such numbers: from one to the next it is no further than 32.
    bool fit() const { return !is_steep_; }
    /// If so: whether any quotient can be in [0, most): 31 steps each way lead 1984 away at most.
    bool come_near() const { return !is_far_; }

    /// One after the other along u; as DividedStair.
    class Stair {
      public:
        bool is_within() const { return static_cast<std::uint64_t>(now_) < end_; } // below 0 is above all
        std::int64_t value() const { return now_ >> Reciprocal::fraction_bits; }
        void next() { now_ += by_; }

      private:
        friend class FixedQuotients;
        Stair(std::int64_t now, std::int64_t by, std::uint64_t end) : now_(now), by_(by), end_(end) {}

        std::int64_t now_; ///< up to 2048 + 32 * 32 + 31 * 32 and a little more: below 2^62
        std::int64_t by_;
        std::uint64_t end_;
    };
    /// Those from (u, v) on, if they fit and come near.
    Stair at(int u, int v) const { return {first_ + u * by_u_ + v * by_v_, by_u_, end_}; }

  private:
    static bool is_beyond(std::int64_t a, std::int64_t most) { return a > most || a < -most; }

    bool is_steep_;
    bool is_far_;
    std::uint64_t end_;
    std::int64_t first_ = 0; ///< of (0, 0)
    std::int64_t by_u_ = 0;
    std::int64_t by_v_ = 0;
};

} // namespace osem

#endif
