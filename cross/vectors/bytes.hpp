// Bytes of a vector file, little-endian.
#ifndef OSEM_VECTORS_BYTES_HPP
#define OSEM_VECTORS_BYTES_HPP

#include <cstdint>
#include <vector>

#include "osem/convert.hpp"
#include "osem/lattice.hpp"
#include "osem/solid.hpp"

namespace vectors {

/// The CRC-32 of IEEE 802.3, bit by bit.
std::uint32_t crc_32(const std::vector<std::uint8_t>& bytes);

class Bytes {
  public:
    void u8(std::uint64_t value) { put(value, 1); }
    void u16(std::uint64_t value) { put(value, 2); }
    void u32(std::uint64_t value) { put(value, 4); }
    void u64(std::uint64_t value) { put(value, 8); }
    void i32(std::int64_t value) { put(static_cast<std::uint64_t>(value), 4); }
    void i64(std::int64_t value) { put(static_cast<std::uint64_t>(value), 8); }
    void point(const osem::Point& p);
    void solid(const osem::Solid& solid);
    void options(const osem::ConvertOptions& options);
    void append(const Bytes& other);

    const std::vector<std::uint8_t>& data() const { return data_; }

  private:
    void put(std::uint64_t value, int bytes);

    std::vector<std::uint8_t> data_;
};

} // namespace vectors

#endif
