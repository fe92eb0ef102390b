#include "mesh/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mesh/bad_input.hpp"

namespace osem::host {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string quoted(std::string_view token) {
    constexpr std::size_t longest = 40;
    std::string shown = "'";
    for (const char c : token.substr(0, longest)) shown += c >= ' ' && c <= '~' ? c : '?';
    return shown + (token.size() > longest ? "...'" : "'");
}

void TextScanner::fail(const std::string& what) const {
    throw BadInput("line " + std::to_string(line_) + ": " + what);
}

bool TextScanner::at_line_end() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    if (at_ != end_ && *at_ == '#') at_ = std::find(at_, end_, '\n');
    return at_ == end_ || *at_ == '\n';
}

void TextScanner::skip_line() {
    at_ = std::find(at_, end_, '\n');
    if (at_ != end_) {
        ++at_;
        ++line_;
    }
}

void TextScanner::skip_space() {
    while (at_line_end() && at_ != end_) skip_line();
}

bool TextScanner::at_end() {
    skip_space();
    return at_ == end_;
}

std::string_view TextScanner::word(const char* what) {
    skip_space();
    if (at_ == end_) fail(std::string("the file ends where ") + what + " should stand");
    const char* const begin = at_;
    while (at_ != end_ && *at_ != '\n' && *at_ != '#' && !is_blank(*at_)) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
}

double TextScanner::number(const char* what) {
    const std::string_view token = word(what);
    const char* begin = token.data();
    const char* const end = begin + token.size();
    if (token.size() > 1 && *begin == '+' && begin[1] != '-') ++begin; // std::from_chars knows no plus sign
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) {
        fail(quoted(token) + " is not a finite number (" + what + " should stand here)");
    }
    return value;
}

std::array<double, 3> TextScanner::point(const char* what) {
    const double x = number(what);
    const double y = number(what);
    const double z = number(what);
    return {x, y, z};
}

std::uint32_t TextScanner::count(const char* what, std::uint32_t greatest) {
    const std::string_view token = word(what);
    const char* const end = token.data() + token.size();
    std::uint32_t value = 0;
    const auto [stop, error] = std::from_chars(token.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end) {
        fail(quoted(token) + " is not an unsigned whole number (" + what + " should stand here)");
    }
    if (error != std::errc() || value > greatest) {
        fail(std::string(what) + " " + quoted(token) + " is too great: at most " + std::to_string(greatest) +
             " can stand here");
    }
    return value;
}

std::uint32_t TextScanner::count_of_items(const char* what, std::uint64_t least_bytes) {
    const std::uint32_t value = count(what);
    const std::uint64_t left = static_cast<std::uint64_t>(end_ - at_) + 1; // the last item needs no newline
    if (value > left / least_bytes) {
        fail(std::string(what) + " " + std::to_string(value) + " is more than the rest of the file can hold");
    }
    return value;
}

} // namespace osem::host
