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

// What is known of the first piece reaches five words further.
TEST(Crc, PiecesOfEveryLengthGiveThePlainOne) {
    const std::vector<std::uint8_t> bytes = crc_sample(140);
    for (std::size_t first = 0; first < 70; ++first) {
        for (std::size_t second = 0; second < 20; ++second) {
            Checksum checksum;
            std::size_t at = 0;
            for (const std::size_t count : {first, second, bytes.size() - first - second}) {
                ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), at)) << first << ' ' << second;
                checksum.append(bytes.data() + at, count);
                at += count;
            }
            ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), at)) << first << ' ' << second;
        }
    }
}

TEST(Crc, GoesOnFromOneThatIsKnown) {
    const std::vector<std::uint8_t> bytes = crc_sample(100);
    for (std::size_t count = 0; count < bytes.size(); ++count) {
        Checksum checksum(plain_crc(bytes.data(), count));
        ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), count));
        checksum.append(bytes.data() + count, bytes.size() - count);
        ASSERT_EQ(checksum.value(), plain_crc(bytes.data(), bytes.size()));
    }
}

} // namespace

} // namespace osem::tests
