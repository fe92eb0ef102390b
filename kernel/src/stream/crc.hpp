// The CRC-32 of IEEE 802.3 (polynomial 0x04c11db7, reflected), four bits at a time: a table of 64 bytes.
#ifndef OSEM_STREAM_CRC_HPP
#define OSEM_STREAM_CRC_HPP

#include <cstddef>
#include <cstdint>

namespace osem {

/// The CRC of some bytes followed by one more. The CRC of no bytes is 0.
inline std::uint32_t crc_append(std::uint32_t crc, std::uint8_t byte) {
    static constexpr std::uint32_t table[16] = {
        0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4, 0x4db26158, 0x5005713c,
        0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c, 0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c};
    crc = ~crc ^ byte;
    crc = (crc >> 4) ^ table[crc & 15U];
    crc = (crc >> 4) ^ table[crc & 15U];
    return ~crc;
}

inline std::uint32_t crc_append(std::uint32_t crc, const std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) crc = crc_append(crc, bytes[i]);
    return crc;
}

} // namespace osem

#endif
