#include "commands/stack_name.hpp"

namespace osem::host {

std::optional<StackName> StackName::parse(const std::string& text) {
    StackName name;
    name.text_ = text;
    const std::size_t percent = text.find('%');
    if (percent == std::string::npos) {
        name.before_ = text + '/';
        name.after_ = ".png";
        name.digits_ = 4;
        return name;
    }
    std::size_t at = percent + 1;
    if (at + 1 < text.size() && text[at] == '0' && text[at + 1] >= '1' && text[at + 1] <= '9') {
        name.digits_ = static_cast<std::size_t>(text[at + 1] - '0');
        at += 2;
    }
    if (at >= text.size() || text[at] != 'd') return std::nullopt;
    name.before_ = text.substr(0, percent);
    name.after_ = text.substr(at + 1);
    if (name.after_.find('%') != std::string::npos) return std::nullopt;
    return name;
}

std::string StackName::of(int number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < digits_) digits.insert(0, digits_ - digits.size(), '0');
    return before_ + digits + after_;
}

} // namespace osem::host
