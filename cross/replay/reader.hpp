// Reads a vector file byte by byte through a small buffer.
#ifndef OSEM_CROSS_REPLAY_READER_HPP
#define OSEM_CROSS_REPLAY_READER_HPP

#include <cstddef>
#include <cstdint>

#include "format.hpp"
#include "osem/lattice.hpp"

namespace osem::cross {

/// The file's records one after another: while (next_record()) ...; then fault() says whether all was well.
class Reader {
  public:
    /// Opens a file and reads its header; false and a fault when it is no vector file.
    bool open(const char* path);

    Topic topic() const { return topic_; }

    /// Goes on to the next record; false at the end of the file or at a fault. Whatever is left of the
    /// record before is an error of its topic, unless it was left on purpose by skip_record.
    bool next_record();

    /// Cases of the current record.
    std::uint32_t cases() const { return cases_; }

    void skip(std::uint32_t bytes);
    void skip_record() { skip(left_); }

    /// The first fault in words, or null.
    const char* fault() const { return fault_; }

    // Numbers of the current record's body. At a fault they are 0.
    std::uint8_t u8();
    std::uint16_t u16();
    std::uint32_t u32();
    std::uint64_t u64();
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    std::int64_t i64() { return static_cast<std::int64_t>(u64()); }
    Point point();

  private:
    std::uint8_t byte();
    std::uint32_t unbounded_u32();
    void read_end();
    void fail(const char* fault);

    std::uint8_t buffer_[256] = {};
    std::size_t at_ = 0;
    std::size_t filled_ = 0;
    std::uint32_t crc_ = 0;
    std::uint32_t cases_expected_ = 0;
    std::uint32_t cases_seen_ = 0;
    std::uint32_t cases_ = 0;
    std::uint32_t left_ = 0; ///< bytes of the record's body not yet read
    const char* fault_ = nullptr;
    Topic topic_ = Topic::orientation;
};

} // namespace osem::cross

#endif
