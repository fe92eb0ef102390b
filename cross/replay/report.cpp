#include "report.hpp"

#include "platform.hpp"

namespace osem::cross {

using port::print;
using port::print_number;

namespace {

constexpr std::uint32_t failures_worded = 5;

void print_signed(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    if (value < 0) print("-");
    print_number(value < 0 ? 0 - bits : bits);
}

} // namespace

void Report::begin_case() {
    ++case_;
    ++totals_.cases;
    failed_ = false;
}

void Report::too_large(std::uint32_t cases) {
    case_ += cases;
    totals_.too_large += cases;
}

bool Report::expect(const char* what, std::int64_t expected, std::int64_t found) {
    if (expected == found) return true;
    if (!failed_) {
        failed_ = true;
        ++totals_.failures;
        if (totals_.failures <= failures_worded) {
            print(file_);
            print(": case ");
            print_number(case_);
            print(": ");
            print(what);
            print(": expected ");
            print_signed(expected);
            print(", found ");
            print_signed(found);
            print("\n");
        }
    }
    return false;
}

} // namespace osem::cross
