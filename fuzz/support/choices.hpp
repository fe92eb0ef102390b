// An input's bytes as a series of choices: whatever the bytes are, every choice is in its range.
#ifndef OSEM_FUZZ_CHOICES_HPP
#define OSEM_FUZZ_CHOICES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "osem/lattice.hpp"

namespace osem::fuzz {

/// Takes the bytes from the first one on, as few as a choice needs; behind the last one all are 0. So an
/// input that is cut short still means something, and a byte changed changes one choice.
class Choices {
  public:
    Choices(const std::uint8_t* bytes, std::size_t count) : at_(bytes), end_(bytes + count) {}

    bool done() const { return at_ == end_; }
    std::uint8_t byte() { return done() ? std::uint8_t{0} : *at_++; }
    bool flag() { return (byte() & 1U) != 0; }

    /// In [0, count); a count of up to 256 takes one byte. Precondition: count > 0.
    std::uint32_t below(std::uint32_t count) {
        std::uint32_t value = 0;
        for (std::uint32_t rest = count - 1; rest > 0; rest >>= 8) value = value << 8 | byte();
        return value % count;
    }
    /// In [low, high].
    std::int32_t between(std::int32_t low, std::int32_t high) {
        return low + static_cast<std::int32_t>(below(static_cast<std::uint32_t>(high - low) + 1));
    }
    std::uint32_t word() { return static_cast<std::uint32_t>(wide(4)); }
    std::uint64_t wide(int bytes = 8) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) value = value << 8 | byte();
        return value;
    }
    /// A budget of steps: everything at once, or few.
    std::uint32_t budget() {
        const std::uint32_t budget = byte();
        return budget < 128 ? UINT32_MAX : budget - 127;
    }
    std::vector<std::uint8_t> rest() {
        const std::vector<std::uint8_t> bytes(at_, end_);
        at_ = end_;
        return bytes;
    }

  private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

/// Steps a job until nothing is left, by budgets that take turns.
template <class Job>
void step_through(Job& job, Choices& choices) {
    const std::uint32_t budgets[2] = {choices.budget(), choices.budget()};
    for (unsigned turn = 0; job.step(budgets[turn & 1U]); ++turn) {
    }
}

} // namespace osem::fuzz

#endif
