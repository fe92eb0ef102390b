#include "reader.hpp"

#include "platform.hpp"
#include "stream/crc.hpp"

namespace osem::cross {

using port::open_input;
using port::read_input;

bool Reader::open(const char* path) {
    at_ = 0;
    filled_ = 0;
    crc_ = 0;
    cases_seen_ = 0;
    cases_ = 0;
    left_ = 12;
    fault_ = nullptr;
    if (!open_input(path)) {
        fail("cannot be opened");
        return false;
    }
    bool known = true;
    for (const std::uint8_t expected : magic) known = (u8() == expected) && known;
    known = u8() == format_version && known;
    const std::uint8_t topic = u8();
    known = topic < topic_count && u16() == 0 && known;
    cases_expected_ = u32();
    if (fault_ == nullptr && !known) fail("is no vector file of this version");
    topic_ = static_cast<Topic>(topic);
    return fault_ == nullptr;
}

bool Reader::next_record() {
    if (fault_ == nullptr && left_ != 0) fail("has a record longer than its topic says");
    const std::uint32_t length = unbounded_u32();
    if (fault_ != nullptr) return false;
    if (length == end_marker) {
        read_end();
        return false;
    }
    left_ = 2;
    cases_ = u16();
    cases_seen_ += cases_;
    left_ = length;
    return fault_ == nullptr;
}

void Reader::skip(std::uint32_t bytes) {
    for (; bytes > 0 && fault_ == nullptr; --bytes) u8();
}

std::uint8_t Reader::u8() {
    if (left_ == 0 && fault_ == nullptr) fail("has a record shorter than its topic says");
    if (fault_ != nullptr) return 0;
    --left_;
    return byte();
}

std::uint16_t Reader::u16() {
    const unsigned low = u8();
    return static_cast<std::uint16_t>(low | static_cast<unsigned>(u8()) << 8);
}

std::uint32_t Reader::u32() {
    const std::uint32_t low = u16();
    return low | static_cast<std::uint32_t>(u16()) << 16;
}

std::uint64_t Reader::u64() {
    const std::uint64_t low = u32();
    return low | static_cast<std::uint64_t>(u32()) << 32;
}

Point Reader::point() {
    const std::int32_t x = i32();
    const std::int32_t y = i32();
    const std::int32_t z = i32();
    return Point{{x, y, z}};
}

std::uint8_t Reader::byte() {
    if (fault_ != nullptr) return 0;
    if (at_ == filled_) {
        at_ = 0;
        filled_ = read_input(buffer_, sizeof buffer_);
        if (filled_ == 0) {
            fail("ends too early");
            return 0;
        }
    }
    crc_ = crc_append(crc_, buffer_[at_]);
    return buffer_[at_++];
}

std::uint32_t Reader::unbounded_u32() {
    left_ = 4;
    return u32();
}

void Reader::read_end() {
    const std::uint32_t crc = crc_;
    if (unbounded_u32() != crc && fault_ == nullptr) fail("is damaged");
    if (cases_seen_ != cases_expected_ && fault_ == nullptr) fail("has another number of cases than it says");
    if (fault_ == nullptr && (at_ != filled_ || read_input(buffer_, 1) != 0)) fail("goes on behind its end");
}

void Reader::fail(const char* fault) { fault_ = fault; }

} // namespace osem::cross
