#include "measure/wide.hpp"

#include <algorithm>
#include <cmath>

namespace osem::host {

namespace {

constexpr std::uint64_t low_half = 0xffffffffU;

// Divides in place and returns the remainder.
std::uint32_t divide(Wide& a, std::uint32_t divisor) {
    std::uint64_t rest = 0;
    const auto digit = [&rest, divisor](std::uint64_t half) {
        const std::uint64_t value = (rest << 32) | half;
        rest = value % divisor;
        return value / divisor;
    };
    std::uint64_t quotient[4] = {};
    quotient[0] = digit(a.high >> 32);
    quotient[1] = digit(a.high & low_half);
    quotient[2] = digit(a.low >> 32);
    quotient[3] = digit(a.low & low_half);
    a = Wide{(quotient[0] << 32) | quotient[1], (quotient[2] << 32) | quotient[3]};
    return static_cast<std::uint32_t>(rest);
}

} // namespace

Wide sum(const Wide& a, const Wide& b) {
    const std::uint64_t low = a.low + b.low;
    return Wide{a.high + b.high + (low < a.low ? 1U : 0U), low};
}

Wide difference(const Wide& a, const Wide& b) {
    return Wide{a.high - b.high - (a.low < b.low ? 1U : 0U), a.low - b.low};
}

Wide product(const Wide& a, std::uint32_t b) {
    const std::uint64_t low = (a.low & low_half) * b;
    const std::uint64_t middle = (a.low >> 32) * b + (low >> 32);
    return Wide{a.high * b + (middle >> 32), (middle << 32) | (low & low_half)};
}

bool below(const Wide& a, const Wide& b) { return a.high != b.high ? a.high < b.high : a.low < b.low; }

double approximate(const Wide& a) {
    const bool negative = (a.high >> 63) != 0;
    const Wide size = negative ? difference(Wide{0, 0}, a) : a;
    const double value = std::ldexp(static_cast<double>(size.high), 64) + static_cast<double>(size.low);
    return negative ? -value : value;
}

std::string decimal(const Wide& a) {
    std::string text;
    for (Wide rest = a; text.empty() || rest != Wide{0, 0};) {
        text += static_cast<char>('0' + divide(rest, 10));
    }
    std::reverse(text.begin(), text.end());
    return text;
}

} // namespace osem::host
