#include "stream/crc.hpp"

#include "osem/config.hpp"
#include "stream/codes.hpp"

namespace osem {

namespace {

#if OSEM_FAST_CRC

// Eight bytes at once: entry [k][b] is what byte b leaves when k more bytes have gone by.
struct Table {
    std::uint32_t entries[8][256];
};

// unreachable: at run time, as the compiler makes the table.
constexpr Table make_table() {
    Table table = {};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (auto& entries : table.entries) {
            remainder = shifted_out(remainder, 8);
            entries[byte] = remainder;
        }
    }
    return table;
}

constexpr Table table = make_table();

std::uint32_t of_word(std::uint32_t word, unsigned behind) {
    return table.entries[behind + 3][word & 0xffU] ^ table.entries[behind + 2][word >> 8 & 0xffU] ^
           table.entries[behind + 1][word >> 16 & 0xffU] ^ table.entries[behind][word >> 24];
}

std::uint32_t of_byte(std::uint32_t remainder) {
    return (remainder >> 8) ^ table.entries[0][remainder & 0xffU];
}

#else

// Four bits at a time.
struct Table {
    std::uint32_t entries[16];
};

// unreachable: at run time, as the compiler makes the table.
constexpr Table make_table() {
    Table table = {};
    for (std::uint32_t bits = 0; bits < 16; ++bits) table.entries[bits] = shifted_out(bits, 4);
    return table;
}

constexpr Table table = make_table();

// In line: a compiler that optimises for size calls it for each byte, which takes a third longer.
[[gnu::always_inline]] inline std::uint32_t of_byte(std::uint32_t remainder) {
    remainder = (remainder >> 4) ^ table.entries[remainder & 15U];
    return (remainder >> 4) ^ table.entries[remainder & 15U];
}

#endif

} // namespace

std::uint32_t crc_append(std::uint32_t crc, const std::uint8_t* bytes, std::size_t count) {
    crc = ~crc;
#if OSEM_FAST_CRC
    for (; count >= 8; count -= 8, bytes += 8) {
        crc = of_word(crc ^ word_at(bytes), 4) ^ of_word(word_at(bytes + 4), 0);
    }
#else
    for (; count >= 4; count -= 4, bytes += 4) {
        crc ^= word_at(bytes);
        crc = of_byte(of_byte(of_byte(of_byte(crc))));
    }
#endif
    for (; count > 0; --count) crc = of_byte(crc ^ *bytes++);
    return ~crc;
}

} // namespace osem
