#include "osem/bounded.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "osem/lattice.hpp"

namespace osem::tests {

namespace {

template <std::int64_t A, std::int64_t B>
constexpr Bounded<A, B> least_of() {
    return Bounded<A, B>::claim(static_cast<typename Bounded<A, B>::Rep>(A));
}

template <class X, class Y>
using Sum = decltype(std::declval<X>() + std::declval<Y>());
template <class X, class Y>
using Difference = decltype(std::declval<X>() - std::declval<Y>());
template <class X, class Y>
using Product = decltype(std::declval<X>() * std::declval<Y>());

template <class X, class Y>
constexpr bool same_type = std::is_same_v<X, Y>;

constexpr std::int64_t two_to_31 = std::int64_t{1} << 31;
constexpr std::int64_t two_to_40 = std::int64_t{1} << 40;

// Ranges of results.
static_assert(same_type<Sum<Bounded<-3, 5>, Bounded<-7, 11>>, Bounded<-10, 16>>);
static_assert(same_type<Sum<Bounded<2, 3>, Bounded<-9, -8>>, Bounded<-7, -5>>);
static_assert(same_type<Difference<Bounded<-3, 5>, Bounded<-7, 11>>, Bounded<-14, 12>>);
static_assert(same_type<Difference<Bounded<4, 5>, Bounded<4, 5>>, Bounded<-1, 1>>);

// The extremes of a product stand at each of the four corners in turn, by the signs of the ranges.
static_assert(same_type<Product<Bounded<2, 3>, Bounded<5, 7>>, Bounded<10, 21>>);
static_assert(same_type<Product<Bounded<-3, -2>, Bounded<5, 7>>, Bounded<-21, -10>>);
static_assert(same_type<Product<Bounded<2, 3>, Bounded<-7, -5>>, Bounded<-21, -10>>);
static_assert(same_type<Product<Bounded<-3, -2>, Bounded<-7, -5>>, Bounded<10, 21>>);
static_assert(same_type<Product<Bounded<-3, 2>, Bounded<-5, 7>>, Bounded<-21, 15>>);
static_assert(same_type<Product<Bounded<-2, 3>, Bounded<-7, 5>>, Bounded<-21, 15>>);
static_assert(same_type<Product<Bounded<-2, 3>, Bounded<5, 7>>, Bounded<-14, 21>>);
static_assert(same_type<Product<Bounded<0, 0>, Bounded<-5, 7>>, Bounded<0, 0>>);

// 32 bits are used where the range and its negative fit.
static_assert(sizeof(Bounded<-two_to_31 + 1, two_to_31 - 1>) == 4);
static_assert(sizeof(Bounded<-two_to_31, 0>) == 8);
static_assert(sizeof(Bounded<0, two_to_31>) == 8);
static_assert(sizeof(Bounded<INT64_MIN, INT64_MAX>) == 8);
static_assert(same_type<Bounded<0, 1>::Rep, std::int32_t>);
static_assert(same_type<Bounded<0, two_to_31>::Rep, std::int64_t>);

// The lattice's own ranges, by the bounds that the design states.
static_assert(same_type<VertexDifference, Bounded<-(1 << 20), 1 << 20>>);
static_assert(same_type<NormalComponent, Bounded<-(std::int64_t{1} << 41), std::int64_t{1} << 41>>);
static_assert(same_type<QueryDifference, Bounded<-(1 << 20) - 1, 1 << 20>>);
static_assert(same_type<PlaneValue, Bounded<-3 * (std::int64_t{1} << 41) * ((1 << 20) + 1),
                                            3 * (std::int64_t{1} << 41) * ((1 << 20) + 1)>>);

// A wider range takes a narrower one without a word; nothing else converts.
static_assert(std::is_convertible_v<Bounded<0, 5>, Bounded<0, 5>>);
static_assert(std::is_convertible_v<Bounded<0, 5>, Bounded<-1, two_to_40>>);
static_assert(!std::is_convertible_v<int, Bounded<0, 5>>);
static_assert(!std::is_constructible_v<Bounded<0, 5>, int>);
static_assert(!std::is_convertible_v<Bounded<0, 5>, int>);
static_assert(!std::is_default_constructible_v<Bounded<0, 5>>);

// It can be used in constant expressions.
static_assert((Bounded<0, 9>::claim(4) * Bounded<0, 9>::claim(5) - Bounded<0, 9>::claim(6)).value() == 14);
static_assert(least_of<-5, 5>().sign() == -1 && Bounded<0, 0>::claim(0).sign() == 0);

TEST(Bounded, ExtremesOf64Bits) {
    using All = Bounded<INT64_MIN, INT64_MAX>;
    EXPECT_EQ(All::claim(INT64_MIN).value(), INT64_MIN);
    EXPECT_EQ(All::claim(INT64_MAX).value(), INT64_MAX);
    EXPECT_EQ(All::claim(INT64_MIN).sign(), -1);
    EXPECT_EQ(All::claim(INT64_MAX).sign(), 1);
    EXPECT_EQ(All::claim(0).sign(), 0);
}

TEST(Bounded, ArithmeticAtTheEndsOfRanges) {
    using Int = Bounded<-two_to_31 + 1, two_to_31 - 1>;
    const std::int64_t most = two_to_31 - 1;
    const Int low = Int::claim(-0x7fffffff);
    const Int high = Int::claim(0x7fffffff);
    EXPECT_EQ((high * high).value(), most * most);
    EXPECT_EQ((high * low).value(), -most * most);
    EXPECT_EQ((high + high).value(), 2 * most);
    EXPECT_EQ((low + low).value(), -2 * most);
    EXPECT_EQ((low - high).value(), -2 * most);
    EXPECT_EQ((high - low).value(), 2 * most);
}

TEST(Bounded, PlaneValueReachesItsBound) {
    const NormalComponent n = NormalComponent::claim(std::int64_t{1} << 41);
    const QueryDifference d = QueryDifference::claim(-(1 << 20) - 1);
    const PlaneValue value = n * d + n * d + n * d;
    EXPECT_EQ(value.value(), -3 * ((std::int64_t{1} << 61) + (std::int64_t{1} << 41)));
    EXPECT_EQ(value.sign(), -1);
}

// Results that fit in 32 bits from operands that do not.
TEST(Bounded, WideOperandsNarrowResult) {
    using Far = Bounded<two_to_40, two_to_40 + 5>;
    using Near31 = Bounded<two_to_31, two_to_31 + 1>;
    EXPECT_EQ((Far::claim(two_to_40 + 5) - Far::claim(two_to_40)).value(), 5);
    EXPECT_EQ((Near31::claim(two_to_31) - Near31::claim(two_to_31 + 1)).value(), -1);

    using FarBelow = Bounded<-two_to_40 - 5, -two_to_40>;
    using Near31Below = Bounded<-two_to_31 - 1, -two_to_31>;
    EXPECT_EQ((Far::claim(two_to_40 + 5) + FarBelow::claim(-two_to_40)).value(), 5);
    EXPECT_EQ((Near31::claim(two_to_31) + Near31Below::claim(-two_to_31)).value(), 0);
    EXPECT_EQ((Far::claim(two_to_40) * Bounded<0, 0>::claim(0)).value(), 0);
}

TEST(Bounded, MagnitudeHasTheRangeOfTheFartherEnd) {
    using Lopsided = Bounded<-7, 3>;
    EXPECT_EQ(magnitude(Lopsided::claim(-7)).value(), 7);
    EXPECT_EQ(magnitude(Lopsided::claim(3)).value(), 3);
    EXPECT_EQ(magnitude(Lopsided::claim(0)).value(), 0);
    static_assert(std::is_same_v<decltype(magnitude(Lopsided::claim(0))), Bounded<0, 7>>);
    static_assert(
        std::is_same_v<decltype(magnitude(Bounded<-7, two_to_40>::claim(0))), Bounded<0, two_to_40>>);
    EXPECT_EQ(magnitude(Bounded<-two_to_40, 0>::claim(-two_to_40)).value(), two_to_40);
}

TEST(Bounded, WideningKeepsTheValue) {
    const Bounded<-5, 5> narrow = Bounded<-5, 5>::claim(-5);
    const Bounded<-5, two_to_40> wide = narrow;
    const Bounded<INT64_MIN, INT64_MAX> widest = wide;
    EXPECT_EQ(wide.value(), -5);
    EXPECT_EQ(widest.value(), -5);
}

// What the types are computed by, at run time, against all products of two ranges.
TEST(Bounded, AProductsExtremesStandAtTheEnds) {
    const std::int64_t ends[] = {-7, -2, 0, 3, 5};
    for (const std::int64_t a : ends) {
        for (const std::int64_t c : ends) {
            for (std::int64_t b = a; b <= 5; ++b) {
                for (std::int64_t d = c; d <= 5; ++d) {
                    std::int64_t lo = INT64_MAX;
                    std::int64_t hi = INT64_MIN;
                    for (std::int64_t x = a; x <= b; ++x) {
                        for (std::int64_t y = c; y <= d; ++y) {
                            lo = x * y < lo ? x * y : lo;
                            hi = x * y > hi ? x * y : hi;
                        }
                    }
                    EXPECT_EQ(detail::product_lo(a, b, c, d), lo);
                    EXPECT_EQ(detail::product_hi(a, b, c, d), hi);
                }
            }
        }
    }
}

TEST(Bounded, ThirtyTwoBitsHoldARangeAndItsNegative) {
    EXPECT_TRUE(detail::fits_32(-two_to_31 + 1, two_to_31 - 1));
    EXPECT_FALSE(detail::fits_32(-two_to_31, 0));
    EXPECT_FALSE(detail::fits_32(0, two_to_31));
}

} // namespace

} // namespace osem::tests
