// The CRC-32 of a stream's payload, which comes piece by piece.
#ifndef OSEM_CHECKSUM_HPP
#define OSEM_CHECKSUM_HPP

#include <cstddef>
#include <cstdint>

#include "osem/register_word.hpp"

namespace osem {

/// The CRC-32 of IEEE 802.3 of the bytes appended so far. With wide registers it takes no tables: a word is
/// put out by additions to words that follow, so what is kept of the payload is what the next five are to be
/// added to. Elsewhere it is the CRC.
class Checksum {
  public:
    /// Of no bytes, whose CRC is 0; and of bytes whose CRC is known.
    constexpr Checksum() : Checksum(0) {}
    constexpr explicit Checksum(std::uint32_t crc) : state_{has_wide_registers ? ~crc : crc} {}

    /// Cost: O(count), and O(1) more where it is no multiple of 8.
    void append(const std::uint8_t* bytes, std::size_t count);

    /// Cost: O(1), but some hundred instructions.
    std::uint32_t value() const {
        return has_wide_registers ? value_of_words() : static_cast<std::uint32_t>(state_[0]);
    }

  private:
    std::uint32_t value_of_words() const;

    RegisterWord state_[has_wide_registers ? 5 : 1];
};

} // namespace osem

#endif
