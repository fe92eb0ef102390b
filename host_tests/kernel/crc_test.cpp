// The checksum by the small table, which is what firmware has by default, by whichever one the kernel here is
// built with, and piece by piece.
#include "stream/crc.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "osem/checksum.hpp"
#include "osem/config.hpp"
#include "support/byte_stream.hpp"

#undef OSEM_FAST_CRC
#define OSEM_FAST_CRC 0
#define crc_append crc_append_by_small_table
#include "stream/crc.cpp"
#undef crc_append

namespace osem::tests {

namespace {

std::vector<std::uint8_t> crc_sample(std::size_t count) {
    std::vector<std::uint8_t> bytes(count);
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(151 * i * i + 7 * i + 3);
    return bytes;
}

// Every length and every place in a word.
TEST(Crc, BothTablesGiveThePlainOne) {
    const std::vector<std::uint8_t> bytes = crc_sample(70);
    for (std::size_t start = 0; start < 8; ++start) {
        for (std::size_t count = 0; start + count <= bytes.size(); ++count) {
            const std::uint32_t expected = plain_crc(bytes.data() + start, count);
            ASSERT_EQ(crc_append_by_small_table(0, bytes.data() + start, count), expected);
            ASSERT_EQ(crc_append(0, bytes.data() + start, count), expected);
            const std::size_t half = count / 2;
            const std::uint32_t first = crc_append_by_small_table(0, bytes.data() + start, half);
            ASSERT_EQ(crc_append_by_small_table(first, bytes.data() + start + half, count - half), expected);
        }
    }
}

// Both checksums, whichever one streams here are read with.
template <class Sum>
class ChecksumOf : public testing::Test {};
using Checksums = testing::Types<TableChecksum, SparseChecksum>;
TYPED_TEST_SUITE(ChecksumOf, Checksums);

// What is known of the first piece reaches 1123 bytes further, and is put where it was.
TYPED_TEST(ChecksumOf, PiecesOfEveryLengthGiveThePlainOne) {
    const std::vector<std::uint8_t> bytes = crc_sample(3000);
    for (std::size_t first = 0; first < 70; ++first) {
        for (std::size_t second = 0; second < 1300; second += 1 + second / 8) {
            TypeParam checksum;
            std::size_t at = 0;
            for (const std::size_t count :
                 {first, second, std::size_t{171}, bytes.size() - first - second - 171}) {
                ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), at)) << first << ' ' << second;
                checksum.append(bytes.data() + at, count);
                at += count;
            }
            ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), at)) << first << ' ' << second;
        }
    }
}

TYPED_TEST(ChecksumOf, PiecesOfOneLengthGiveThePlainOne) {
    const std::vector<std::uint8_t> bytes = crc_sample(5000);
    for (const std::size_t piece : {1U, 7U, 31U, 33U, 64U, 171U, 512U, 1123U, 1124U, 2247U}) {
        TypeParam checksum;
        for (std::size_t at = 0; at + piece <= bytes.size(); at += piece) {
            checksum.append(bytes.data() + at, piece);
            if (at % 9 != 0) continue;
            ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), at + piece)) << piece;
        }
    }
}

TYPED_TEST(ChecksumOf, GoesOnFromOneThatIsKnown) {
    const std::vector<std::uint8_t> bytes = crc_sample(1300);
    for (std::size_t count = 0; count < bytes.size(); ++count) {
        TypeParam checksum(plain_crc(bytes.data(), count));
        ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), count));
        checksum.append(bytes.data() + count, bytes.size() - count);
        ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), bytes.size()));
    }
}

} // namespace

} // namespace osem::tests
