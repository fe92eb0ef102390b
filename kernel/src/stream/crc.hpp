// The CRC-32 of IEEE 802.3 (polynomial 0x04c11db7, reflected).
#ifndef OSEM_STREAM_CRC_HPP
#define OSEM_STREAM_CRC_HPP

#include <cstddef>
#include <cstdint>

namespace osem {

/// A remainder's lowest `bits` bits are shifted out: what that leaves of them.
constexpr std::uint32_t shifted_out(std::uint32_t remainder, unsigned bits) {
    for (; bits > 0; --bits) remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? 0xedb88320U : 0U);
    return remainder;
}

/// The CRC of some bytes followed by more. The CRC of no bytes is 0.
std::uint32_t crc_append(std::uint32_t crc, const std::uint8_t* bytes, std::size_t count);
inline std::uint32_t crc_append(std::uint32_t crc, std::uint8_t byte) { return crc_append(crc, &byte, 1); }

} // namespace osem

#endif
