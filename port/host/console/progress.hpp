// Progress of long work, one line on a terminal.
#ifndef OSEM_HOST_PROGRESS_HPP
#define OSEM_HOST_PROGRESS_HPP

#include <chrono>
#include <cstdint>

#include "console/console.hpp"
#include "osem/lattice.hpp"

namespace osem::host {

/// A line "label 42 %", rewritten at most ten times a second and cleared when the object goes. Shows nothing
/// when the console is no terminal, nor for work that is done within half a second.
class Progress {
  public:
    /// `label` is a literal.
    Progress(const Console& console, const char* label);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `part` of `whole` is done.
    void show(std::uint64_t part, std::uint64_t whole);

  private:
    using Clock = std::chrono::steady_clock;
    const Console& console_;
    const char* label_;
    Clock::time_point next_;
    bool shown_ = false;
};

/// Steps a kernel job (Conversion, Combination) to its end. `pass` of `passes` counts from 0.
template <class Job>
void drive(Job& job, Progress& progress, std::uint64_t pass, std::uint64_t passes) {
    constexpr std::uint32_t octants_a_step = 64; // a root octant may take a tenth of a second by itself
    constexpr std::uint64_t coarse = root_volume >> 20; // keeps passes * volume within 64 bits
    while (job.step(octants_a_step)) {
        progress.show(pass * coarse + (job.decided_volume() >> 20), passes * coarse);
    }
}

} // namespace osem::host

#endif
