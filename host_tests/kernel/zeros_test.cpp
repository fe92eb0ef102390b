// What parts without an instruction that counts zeros do instead.
#include "tree/zeros.hpp"

#include <gtest/gtest.h>

#include "grid/octant_grid.hpp"
#include "stream/codes.hpp"
#include "tree/masks.hpp"

namespace osem::tests {

namespace {

TEST(Masks, TheLowestChildIsFoundWithoutCountingZeros) {
    for (unsigned mask = 1; mask < 256; ++mask) {
        unsigned expected = 0;
        while ((mask >> expected & 1U) == 0) ++expected;
        EXPECT_EQ(plain_lowest(static_cast<std::uint8_t>(mask)), expected);
        EXPECT_EQ(lowest(static_cast<std::uint8_t>(mask)), expected);
    }
}

TEST(OctantGrid, TheLowestMemberIsFoundWithoutCountingZeros) {
    for (unsigned member = 0; member < 64; ++member) {
        for (const std::uint64_t above : {0x0ULL, 0x1ULL, 0xf0f0f0f0f0f0f0f0ULL, ~0ULL}) {
            const std::uint64_t set = std::uint64_t{1} << member | above << member << 1;
            EXPECT_EQ(plain_lowest_of(set), member);
            EXPECT_EQ(lowest_of(set), member);
        }
    }
}

TEST(Codes, TheLowestBitIsFoundByTheTable) {
    for (unsigned number = 0; number <= 16; number += 2) {
        for (unsigned above = 0; above < 8; ++above) {
            EXPECT_EQ(plain_lowest_bit((1U << number) | (0x15U * above) << (number + 2)), number);
        }
    }
}

} // namespace

} // namespace osem::tests
