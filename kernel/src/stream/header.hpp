// The header of a stream, and numbers as bytes.
#ifndef OSEM_STREAM_HEADER_HPP
#define OSEM_STREAM_HEADER_HPP

#include <cstddef>
#include <cstdint>

#include "osem/stream.hpp"

namespace osem {

/// Writes a number, little-endian.
template <class Integer>
void put_number(std::uint8_t* bytes, Integer value) {
    for (std::size_t i = 0; i < sizeof(Integer); ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

template <class Integer>
Integer get_number(const std::uint8_t* bytes) {
    Integer value = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) value |= static_cast<Integer>(bytes[i]) << (8 * i);
    return value;
}

/// Writes the stream_header_size bytes of a header.
void encode_header(const StreamHeader& header, std::uint8_t* bytes);

/// Whether byte `at` of a header may be `byte`, as far as that is known before the header is whole.
bool begins_header(std::size_t at, std::uint8_t byte);

/// What a header says, or the fault in it and the byte where it is.
struct HeaderOutcome {
    Status status;
    std::size_t offset;
    StreamHeader header;
};

/// Reads stream_header_size bytes, which begin a header.
HeaderOutcome decode_header(const std::uint8_t* bytes);

} // namespace osem

#endif
