// Counts cases and failures of one file, and words the first few failures.
#ifndef OSEM_CROSS_REPLAY_REPORT_HPP
#define OSEM_CROSS_REPLAY_REPORT_HPP

#include <cstdint>

namespace osem::cross {

struct Totals {
    std::uint32_t cases = 0; ///< run
    std::uint32_t failures = 0;
    std::uint32_t too_large = 0; ///< not run, for want of memory
};

class Report {
  public:
    explicit Report(const char* file) : file_(file) {}

    /// The next case is run.
    void begin_case();

    /// The next `cases` cases do not fit the arena.
    void too_large(std::uint32_t cases = 1);

    /// Compares one answer of the current case; false when it is wrong. A case fails once, however many of
    /// its answers are wrong.
    bool expect(const char* what, std::int64_t expected, std::int64_t found);

    const Totals& totals() const { return totals_; }

  private:
    const char* file_;
    Totals totals_;
    std::uint32_t case_ = 0; ///< number of the current case, from 1
    bool failed_ = false;
};

} // namespace osem::cross

#endif
