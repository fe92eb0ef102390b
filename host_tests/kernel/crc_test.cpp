// The checksum by the small table, which is what firmware has by default, and by whichever one the kernel
// here is built with.
#include "stream/crc.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "osem/config.hpp"
#include "support/byte_stream.hpp"

#undef OSEM_FAST_CRC
#define OSEM_FAST_CRC 0
#define crc_append crc_append_by_small_table
#include "stream/crc.cpp"
#undef crc_append

namespace osem::tests {

namespace {

// Every length and every place in a word.
TEST(Crc, BothTablesGiveThePlainOne) {
    std::vector<std::uint8_t> bytes(70);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(151 * i * i + 7 * i + 3);
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

} // namespace

} // namespace osem::tests
