// The CRC-32 of a stream's payload, which comes piece by piece.
#ifndef OSEM_CHECKSUM_HPP
#define OSEM_CHECKSUM_HPP

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "osem/register_word.hpp"

namespace osem {

/// The CRC-32 of IEEE 802.3 of the bytes appended so far, by a table, in four bytes.
class TableChecksum {
  public:
    /// Of no bytes, whose CRC is 0; and of bytes whose CRC is known.
    constexpr TableChecksum() : TableChecksum(0) {}
    constexpr explicit TableChecksum(std::uint32_t crc) : crc_(crc) {}

    /// Cost: O(count).
    void append(const std::uint8_t* bytes, std::size_t count);

    std::uint32_t value() const { return crc_; }

  private:
    std::uint32_t crc_;
};

/// The same by a sparse multiple of the polynomial, without a table or a shift: a byte is put out by
/// additions to four that come so much later that many are put out side by side.
class SparseChecksum {
  public:
    /// Of no bytes, whose CRC is 0; and of bytes whose CRC is known.
    constexpr SparseChecksum() : SparseChecksum(0) {}
    constexpr explicit SparseChecksum(std::uint32_t crc)
        : put_out_{static_cast<std::uint8_t>(~crc), static_cast<std::uint8_t>(~crc >> 8),
                   static_cast<std::uint8_t>(~crc >> 16), static_cast<std::uint8_t>(~crc >> 24)} {}

    /// Cost: O(count).
    void append(const std::uint8_t* bytes, std::size_t count);

    /// Cost: O(1), but some thousand instructions.
    std::uint32_t value() const;

  private:
    static constexpr unsigned reach = 1123; ///< the last bytes to which one is added are so far behind it

    static constexpr unsigned room = 1024; ///< bytes that follow them before they are moved

    void make_room();

    /// What bytes were when they were put out, the last ones behind `at_`; behind those is room for the next.
    /// At first those that put out what is known.
    std::uint8_t put_out_[reach + room];
    unsigned at_ = 0;
};

/// What streams are read and written with.
using Checksum = std::conditional_t<has_wide_registers, SparseChecksum, TableChecksum>;

} // namespace osem

#endif
