// The two ways to quotients that go from row to row.
#include "grid/stair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace osem::tests {

namespace {

std::int64_t floor_of(std::int64_t n, std::int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

int clipped_floor(std::int64_t n, std::int64_t d, int most) {
    return static_cast<int>(std::clamp<std::int64_t>(floor_of(n, d), -1, most));
}

// Dividends of rows whose quotients are near a grid, and where they are far from it.
template <class Value>
struct Rows {
    Value d;
    Value n;
    Value by;

    Rows(Value divisor, Value dividend, Value change) : d(divisor), n(dividend), by(change) {}
    Rows(std::mt19937& random, Value most_d, int rows) {
        const auto up_to = [&random](Value most) {
            return std::uniform_int_distribution<Value>(-most, most)(random);
        };
        // Small numbers and great ones alike.
        const Value most = most_d >> std::uniform_int_distribution<int>(0, 18)(random);
        d = std::uniform_int_distribution<Value>(1, most)(random);
        by = up_to(most_d >> std::uniform_int_distribution<int>(0, 18)(random));
        n = up_to(40) * d + up_to(3) - by * std::uniform_int_distribution<Value>(0, rows)(random);
    }
};

template <class Stair, class Value>
void expect_floors(const Rows<Value>& rows, int count, int most, int guess) {
    Stair stair({rows.d, rows.by}, rows.n, most, guess);
    for (int row = 0; row < count; ++row, stair.next()) {
        const int expected = clipped_floor(rows.n + row * rows.by, rows.d, most);
        ASSERT_EQ(stair.floor(), expected) << rows.n << " + " << row << " * " << rows.by << " by " << rows.d;
        ASSERT_EQ(stair.is_within(), expected >= 0 && expected < most);
    }
}

template <class Band>
void expect_bits(const Rows<std::int64_t>& rows, std::int64_t width, const IndexRange& range, int guess) {
    constexpr int most = 32;
    Band band({rows.d, rows.by, width}, rows.n, most, guess);
    for (int row = 0; row < 32; ++row, band.next()) {
        const std::int64_t n = rows.n + row * rows.by;
        std::uint32_t expected = 0;
        for (int i = range.first; i <= range.last; ++i) {
            if (i >= floor_of(n, rows.d) && i <= floor_of(n + width, rows.d))
                expected |= std::uint32_t{1} << i;
        }
        ASSERT_EQ(band.floor(), clipped_floor(n, rows.d, most));
        ASSERT_EQ(band.bits(range), expected) << n << " to " << n + width << " by " << rows.d;
    }
}

constexpr int trials = 20000;

TEST(Stair, OfEdgesHasTheQuotientsBothWays) {
    std::mt19937 random(1);
    for (int trial = 0; trial < trials; ++trial) {
        const Rows<std::int32_t> rows(random, std::int32_t{1} << 20, 32);
        const int most = std::uniform_int_distribution<int>(0, 32)(random);
        const int guess = std::uniform_int_distribution<int>(-1, most)(random);
        expect_floors<DividedStair<std::int32_t>>(rows, 33, most, guess);
        expect_floors<WalkedStair<std::int32_t>>(rows, 33, most, guess);
    }
}

TEST(Stair, FourSideBySideHaveTheQuotientsModulo32Bits) {
    std::mt19937 random(5);
    for (int trial = 0; trial < trials / 20; ++trial) {
        const std::int64_t most = trial % 2 == 0 ? INT32_MAX : std::int64_t{1} << (trial / 2 % 31);
        const std::int64_t d =
            trial % 10 == 0 ? most : std::uniform_int_distribution<std::int64_t>(1, most)(random);
        const Rows<std::int64_t> rows(random, std::int64_t{1} << 41, 32);
        const std::int64_t by_v = Rows<std::int64_t>(random, std::int64_t{1} << 41, 1).by;
        FourStairs four(d, rows.n, rows.by, by_v);
        for (int first = 0; first < 16; first += 4) {
            four.begin_four();
            for (int u = 0; u < 16; ++u, four.next()) {
                for (int k = 0; k < 4; ++k) {
                    const std::int64_t expected = floor_of(rows.n + u * rows.by + (first + k) * by_v, d);
                    ASSERT_EQ(four.values()[k], static_cast<std::uint32_t>(expected));
                }
            }
        }
    }
}

TEST(Stair, OfPlanesHasTheQuotientsBothWays) {
    std::mt19937 random(2);
    for (int trial = 0; trial < trials; ++trial) {
        const Rows<std::int64_t> rows(random, std::int64_t{1} << 41, 32);
        const int guess = std::uniform_int_distribution<int>(-1, 31)(random);
        expect_floors<DividedStair<std::int64_t>>(rows, 33, 31, guess);
        expect_floors<WalkedStair<std::int64_t>>(rows, 33, 31, guess);
    }
}

// The greatest dividends, divisors and changes that there are: see PassedOctants and SeenEdge.
TEST(Stair, HasTheGreatestNumbersBothWays) {
    constexpr std::int64_t plane = 3 * ((std::int64_t{1} << 61) + (std::int64_t{1} << 41));
    constexpr std::int64_t normal = std::int64_t{1} << 41;
    constexpr std::int32_t edge = std::int32_t{1} << 27;
    for (const int sign : {-1, 1}) {
        for (const int way : {-1, 1}) {
            for (const std::int64_t d : {std::int64_t{1}, normal - 1, normal}) {
                Rows<std::int64_t> rows = {d, sign * plane, way * normal};
                expect_floors<DividedStair<std::int64_t>>(rows, 33, 31, 7);
                expect_floors<WalkedStair<std::int64_t>>(rows, 33, 31, 7);
                rows.n = sign * normal;
                const std::int64_t most = std::int64_t{1} << 42;
                for (const std::int64_t width : {std::int64_t{-1}, most}) {
                    expect_bits<DividedBand<std::int64_t>>(rows, width, {3, 31}, 7);
                    expect_bits<WalkedBand<std::int64_t>>(rows, width, {3, 31}, 7);
                }
            }
            for (const std::int32_t d : {1, (1 << 20) - 1, 1 << 20}) {
                const Rows<std::int32_t> rows = {d, sign * edge, way * (std::int32_t{1} << 20)};
                expect_floors<DividedStair<std::int32_t>>(rows, 33, 32, 7);
                expect_floors<WalkedStair<std::int32_t>>(rows, 33, 32, 7);
            }
        }
    }
}

TEST(Band, HasTheIndicesBetweenTheQuotientsBothWays) {
    std::mt19937 random(3);
    for (int trial = 0; trial < trials; ++trial) {
        const Rows<std::int64_t> rows(random, std::int64_t{1} << 41, 32);
        const std::int64_t width = std::uniform_int_distribution<std::int64_t>(-2, 5)(random) * rows.d +
                                   std::uniform_int_distribution<std::int64_t>(-1, 1)(random);
        const int first = std::uniform_int_distribution<int>(0, 31)(random);
        const IndexRange range = {first, std::uniform_int_distribution<int>(first, 31)(random)};
        const int guess = std::uniform_int_distribution<int>(-1, 32)(random);
        expect_bits<DividedBand<std::int64_t>>(rows, width, range, guess);
        expect_bits<WalkedBand<std::int64_t>>(rows, width, range, guess);
    }
}

TEST(Stair, OverAPlaneBeginsAnywhere) {
    std::mt19937 random(4);
    for (int trial = 0; trial < trials; ++trial) {
        const Rows<std::int64_t> rows(random, std::int64_t{1} << 41, 32);
        const Rows<std::int64_t> across(random, std::int64_t{1} << 41, 32);
        OverPlane<DividedStair<std::int64_t>> divided({rows.d, rows.by}, rows.n, rows.by, across.by, 31, 0);
        OverPlane<WalkedStair<std::int64_t>> walked({rows.d, rows.by}, rows.n, rows.by, across.by, 31, 0);
        for (int v = 0; v < 4; ++v) {
            const int u = std::uniform_int_distribution<int>(0, 31)(random);
            auto by_division = divided.at(u, v);
            auto by_walking = walked.at(u, v);
            by_division.next();
            by_walking.next();
            const std::int64_t n = rows.n + (u + 1) * rows.by + v * across.by;
            ASSERT_EQ(by_division.floor(), clipped_floor(n, rows.d, 31));
            ASSERT_EQ(by_walking.floor(), clipped_floor(n, rows.d, 31));
        }
    }
}

} // namespace

} // namespace osem::tests
