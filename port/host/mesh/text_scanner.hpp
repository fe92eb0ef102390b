// Numbers and words out of a text file in memory, with line numbers for whatever is wrong.
#ifndef OSEM_HOST_MESH_TEXT_SCANNER_HPP
#define OSEM_HOST_MESH_TEXT_SCANNER_HPP

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace osem::host {

/// Walks over text token by token. Tokens are separated by white space; '#' starts a comment that runs to
/// the end of the line. Every failure throws BadInput with the line number.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text, std::uint64_t first_line = 1)
        : at_(text.data()), end_(text.data() + text.size()), line_(first_line) {}

    /// Whether nothing but white space and comments is left.
    bool at_end();
    /// Whether nothing but spaces and a comment is left on this line.
    bool at_line_end();
    void skip_line();

    /// The next token; `what` names it in the message if there is none.
    std::string_view word(const char* what);
    /// A finite number.
    double number(const char* what);
    std::array<double, 3> point(const char* what);
    /// An unsigned decimal number of at most `greatest`.
    std::uint32_t count(const char* what, std::uint32_t greatest = UINT32_MAX);
    /// A count of items that take at least `least_bytes` each: more than the rest of the text can hold is
    /// refused, so that no announced number is trusted with memory.
    std::uint32_t count_of_items(const char* what, std::uint64_t least_bytes);

    [[noreturn]] void fail(const std::string& what) const;

  private:
    void skip_space();

    const char* at_;
    const char* end_;
    std::uint64_t line_;
};

/// Whether two words are equal but for upper and lower case (ASCII).
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// A token as a message may show it: shortened, and without control characters.
std::string quoted(std::string_view token);

} // namespace osem::host

#endif
