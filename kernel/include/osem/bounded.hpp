// An integer that carries its range in its type: arithmetic widens the range, and a range that would leave
// 64 bits does not compile. It costs nothing at run time and replaces every "this cannot overflow" comment.
#ifndef OSEM_BOUNDED_HPP
#define OSEM_BOUNDED_HPP

#include <cstdint>
#include <type_traits>

#include "osem/assumptions.hpp"
#include "osem/config.hpp"

namespace osem {

namespace detail {

constexpr std::int64_t least(std::int64_t a, std::int64_t b) { return a < b ? a : b; }
constexpr std::int64_t greatest(std::int64_t a, std::int64_t b) { return a < b ? b : a; }

// The extremes of a product over two ranges stand among the four products of their ends. A product or sum
// past 64 bits is undefined behaviour, which a constant expression must not contain: it is a compile error.
constexpr std::int64_t product_lo(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return least(least(a * c, a * d), least(b * c, b * d));
}
constexpr std::int64_t product_hi(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return greatest(greatest(a * c, a * d), greatest(b * c, b * d));
}

constexpr bool fits_32(std::int64_t lo, std::int64_t hi) {
    return lo >= -INT64_C(0x7fffffff) && hi <= INT64_C(0x7fffffff);
}

} // namespace detail

/// An integer in [Lo, Hi], held in 32 bits where the range allows and in 64 otherwise.
template <std::int64_t Lo, std::int64_t Hi>
class Bounded {
    static_assert(Lo <= Hi, "an empty range");

  public:
    using Rep = std::conditional_t<detail::fits_32(Lo, Hi), std::int32_t, std::int64_t>;

    /// Precondition: Lo <= value <= Hi, proved at the door (check, or a grid invariant).
    static constexpr Bounded claim(Rep value) {
        OSEM_ASSERT(Lo <= value && value <= Hi);
        return Bounded(value);
    }

    /// A narrower range is also in this one.
    template <std::int64_t L, std::int64_t H>
    constexpr Bounded(Bounded<L, H> other) // NOLINT(google-explicit-constructor): widening is safe
        : value_(static_cast<Rep>(other.value())) {
        static_assert(Lo <= L && H <= Hi, "the range does not fit: narrowing needs a proof");
    }

    constexpr Rep value() const { return value_; }
    constexpr int sign() const { return value_ < 0 ? -1 : value_ > 0 ? 1 : 0; }

  private:
    explicit constexpr Bounded(Rep value) : value_(value) {}
    Rep value_;
};

namespace detail {

// What two operands are computed in: 64 bits if either of them or the result needs them.
template <class X, class Y, class Result>
using Wide =
    std::conditional_t<sizeof(X) == 8 || sizeof(Y) == 8 || sizeof(Result) == 8, std::int64_t, std::int32_t>;

} // namespace detail

template <std::int64_t A, std::int64_t B, std::int64_t C, std::int64_t D>
constexpr auto operator+(Bounded<A, B> x, Bounded<C, D> y) {
    using Sum = Bounded<A + C, B + D>;
    using Wide = detail::Wide<Bounded<A, B>, Bounded<C, D>, Sum>;
    return Sum::claim(
        static_cast<typename Sum::Rep>(static_cast<Wide>(x.value()) + static_cast<Wide>(y.value())));
}

template <std::int64_t A, std::int64_t B, std::int64_t C, std::int64_t D>
constexpr auto operator-(Bounded<A, B> x, Bounded<C, D> y) {
    using Difference = Bounded<A - D, B - C>;
    using Wide = detail::Wide<Bounded<A, B>, Bounded<C, D>, Difference>;
    return Difference::claim(
        static_cast<typename Difference::Rep>(static_cast<Wide>(x.value()) - static_cast<Wide>(y.value())));
}

template <std::int64_t A, std::int64_t B, std::int64_t C, std::int64_t D>
constexpr auto operator*(Bounded<A, B> x, Bounded<C, D> y) {
    using Product = Bounded<detail::product_lo(A, B, C, D), detail::product_hi(A, B, C, D)>;
    using Wide = detail::Wide<Bounded<A, B>, Bounded<C, D>, Product>;
    return Product::claim(
        static_cast<typename Product::Rep>(static_cast<Wide>(x.value()) * static_cast<Wide>(y.value())));
}

/// The distance from 0.
template <std::int64_t A, std::int64_t B>
constexpr auto magnitude(Bounded<A, B> x) {
    using Magnitude = Bounded<0, detail::greatest(-A, B)>;
    return Magnitude::claim(static_cast<typename Magnitude::Rep>(x.value() < 0 ? -x.value() : x.value()));
}

} // namespace osem

#endif
