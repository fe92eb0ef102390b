// Quotients in fixed point against quotients, with divisors of any length and dividends at multiples of them.
#include "grid/fixed_quotients.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace osem::tests {

namespace {

constexpr int most = 31;

std::int64_t rounded_down(std::int64_t n, std::int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

struct Dividends {
    std::int64_t d;
    std::int64_t n;
    std::int64_t by_u;
    std::int64_t by_v;

    // One of them is a multiple of d, or one more or less; that one is up to `far` times d.
    Dividends(std::mt19937_64& random, std::int64_t steepest, std::int64_t far) {
        const auto up_to = [&](std::int64_t greatest) {
            return std::uniform_int_distribution<std::int64_t>(-greatest, greatest)(random);
        };
        const std::int64_t longest = std::int64_t{1} << std::uniform_int_distribution<int>(0, 41)(random);
        d = std::uniform_int_distribution<int>(0, 3)(random) == 0 ? longest
                                                                  : 1 + (up_to(longest - 1) & (longest - 1));
        const bool is_steepest = std::uniform_int_distribution<int>(0, 7)(random) == 0;
        by_u = is_steepest ? steepest * d : up_to(steepest * d);
        by_v = is_steepest ? -steepest * d : up_to(steepest * d);
        const std::int64_t u = 15 + up_to(16) / 2;
        const std::int64_t v = 15 + up_to(16) / 2;
        n = up_to(far) * d + up_to(1) - u * by_u - v * by_v;
    }
    std::int64_t quotient(int u, int v) const { return rounded_down(n + u * by_u + v * by_v, d); }
};

// Of all of them: whether they are within, and if so the number. Returns how many are.
int expect_same(const Dividends& given) {
    const FixedQuotients quotients(given.d, given.n, given.by_u, given.by_v, most);
    EXPECT_TRUE(quotients.fit());
    int within = 0;
    for (int v = 0; v < 32; ++v) {
        auto stair = quotients.at(0, v);
        for (int u = 0; u < 32; ++u, stair.next()) {
            const std::int64_t expected = given.quotient(u, v);
            const bool is_within = expected >= 0 && expected < most;
            within += is_within ? 1 : 0;
            if (!quotients.come_near()) {
                EXPECT_FALSE(is_within);
                continue;
            }
            const auto here = quotients.at(u, v);
            EXPECT_EQ(stair.is_within(), is_within);
            EXPECT_EQ(here.is_within(), is_within);
            if (is_within) {
                EXPECT_EQ(stair.value(), expected);
                EXPECT_EQ(here.value(), expected);
            }
        }
    }
    return within;
}

TEST(FixedQuotients, RoundDownToTheSame) {
    std::mt19937_64 random(1);
    int within = 0;
    for (int trial = 0; trial < 3000 && !::testing::Test::HasFailure(); ++trial) {
        const int steepest = trial % 3 == 0 ? 32 : trial % 3 == 1 ? 1 : 4;
        within += expect_same(Dividends(random, steepest, 32));
    }
    EXPECT_GT(within, 100000);
}

TEST(FixedQuotients, FarOnesDoNotComeNear) {
    std::mt19937_64 random(2);
    int near = 0;
    int far = 0;
    for (int trial = 0; trial < 1000 && !::testing::Test::HasFailure(); ++trial) {
        const Dividends given(random, 32, trial % 2 == 0 ? 64 : 4500);
        static_cast<void>(expect_same(given));
        const bool come_near = FixedQuotients(given.d, given.n, given.by_u, given.by_v, most).come_near();
        (come_near ? near : far) += 1;
    }
    EXPECT_GT(near, 100);
    EXPECT_GT(far, 100);
}

TEST(FixedQuotients, SteepOnesDoNotFit) {
    for (const std::int64_t d : {std::int64_t{1}, std::int64_t{12345}, std::int64_t{1} << 41}) {
        for (const std::int64_t by : {32 * d, -32 * d}) {
            const std::int64_t steeper = by + (by < 0 ? -1 : 1);
            EXPECT_TRUE(FixedQuotients(d, 0, by, by, most).fit());
            EXPECT_FALSE(FixedQuotients(d, 0, steeper, by, most).fit());
            EXPECT_FALSE(FixedQuotients(d, 0, by, steeper, most).fit());
        }
    }
}

} // namespace

} // namespace osem::tests
