#include "console/progress.hpp"

#include <ostream>

namespace osem::host {

Progress::Progress(const Console& console, const char* label)
    : console_(console), label_(label), next_(Clock::now() + std::chrono::milliseconds(500)) {}

Progress::~Progress() {
    if (shown_) console_.err << "\r\x1b[K" << std::flush;
}

void Progress::show(std::uint64_t part, std::uint64_t whole) {
    if (!console_.terminal) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    shown_ = true;
    const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    console_.err << '\r' << label_ << ' ' << static_cast<int>(percent) << " %\x1b[K" << std::flush;
}

} // namespace osem::host
