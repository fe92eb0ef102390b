// Names of numbered files.
#ifndef OSEM_HOST_STACK_NAME_HPP
#define OSEM_HOST_STACK_NAME_HPP

#include <optional>
#include <string>

namespace osem::host {

/// The names of a stack's files: a pattern with one %d or %0Nd (N from 1 to 9) for the number, or a
/// directory, whose files are then 0000.png, 0001.png and so on.
class StackName {
  public:
    /// None when the text has a % that is no such number, or more than one.
    static std::optional<StackName> parse(const std::string& text);

    std::string of(int number) const;
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::string before_;
    std::string after_;
    std::size_t digits_ = 0;
};

} // namespace osem::host

#endif
