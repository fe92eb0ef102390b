// Lines of numbers and words, gathered in one buffer: there may be many millions.
#ifndef OSEM_HOST_TEXT_LINES_HPP
#define OSEM_HOST_TEXT_LINES_HPP

#include <charconv>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <vector>

namespace osem::host {

class TextLines {
  public:
    /// Numbers and words of one line, together, are shorter than this.
    static constexpr std::size_t longest_line = 128;

    explicit TextLines(std::ostream& out) : out_(out), buffer_(std::size_t{1} << 16) {}

    /// Makes room for a line; false once the stream refuses.
    bool start_line() { return buffer_.size() - used_ >= longest_line || flush(); }

    /// Adds a number and a blank.
    void number(std::int32_t value) {
        char* const at = buffer_.data() + used_;
        char* const end = std::to_chars(at, at + longest_line, value).ptr;
        *end = ' ';
        used_ += static_cast<std::size_t>(end - at) + 1;
    }

    void word(const char* text) {
        const std::size_t length = std::strlen(text);
        std::memcpy(buffer_.data() + used_, text, length);
        used_ += length;
    }

    bool flush() {
        out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
        used_ = 0;
        return out_.good();
    }

  private:
    std::ostream& out_;
    std::vector<char> buffer_;
    std::size_t used_ = 0;
};

} // namespace osem::host

#endif
