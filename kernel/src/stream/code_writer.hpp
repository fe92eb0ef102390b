// Codes to bytes: the payload of a stream goes to the sink in small pieces, so that a sink may be a slow one.
#ifndef OSEM_STREAM_CODE_WRITER_HPP
#define OSEM_STREAM_CODE_WRITER_HPP

#include "osem/stream.hpp"
#include "stream/crc.hpp"
#include "stream/header.hpp"

namespace osem {

/// Packs a payload. Once the sink has refused, nothing more is written.
class CodeWriter {
  public:
    CodeWriter() = default;
    explicit CodeWriter(const Sink& sink) : sink_(sink) {}

    void put_header(const StreamHeader& header) {
        std::uint8_t bytes[stream_header_size];
        encode_header(header, bytes);
        taken_ = sink_.write(sink_.context, bytes, sizeof bytes);
    }

    /// Puts `count` codes, two bits each, the first one lowest. Precondition: count <= 8.
    void put(std::uint32_t codes, unsigned count) {
        bits_ |= codes << used_;
        used_ += 2 * count;
        for (; used_ >= 8; used_ -= 8, bits_ >>= 8) put_byte(static_cast<std::uint8_t>(bits_));
    }

    /// Ends payload and stream; whether the sink has taken everything.
    bool finish() {
        if (used_ != 0) put_byte(static_cast<std::uint8_t>(bits_));
        flush();
        std::uint8_t bytes[stream_trailer_size];
        put_number(bytes, crc_);
        if (taken_) taken_ = sink_.write(sink_.context, bytes, sizeof bytes);
        return taken_;
    }

    /// Whether the sink has taken everything so far.
    bool taken() const { return taken_; }

  private:
    void put_byte(std::uint8_t byte) {
        buffer_[filled_++] = byte;
        if (filled_ == sizeof buffer_) flush();
    }
    void flush() {
        crc_ = crc_append(crc_, buffer_, filled_);
        if (taken_ && filled_ != 0) taken_ = sink_.write(sink_.context, buffer_, filled_);
        filled_ = 0;
    }

    Sink sink_ = {};
    bool taken_ = true;
    unsigned used_ = 0; ///< bits of bits_ in use, fewer than 8 between calls
    std::uint32_t bits_ = 0;
    std::uint32_t crc_ = 0;
    std::size_t filled_ = 0;
    std::uint8_t buffer_[64] = {};
};

} // namespace osem

#endif
