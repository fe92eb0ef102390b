#include "instruction_clock.hpp"

namespace osem::cortex_m {

namespace {

// SysTick as in the Arm v6-M and v7-M architecture reference manuals, B3.3.
volatile std::uint32_t& control = *reinterpret_cast<volatile std::uint32_t*>(0xe000e010);
volatile std::uint32_t& reload = *reinterpret_cast<volatile std::uint32_t*>(0xe000e014);
volatile std::uint32_t& current = *reinterpret_cast<volatile std::uint32_t*>(0xe000e018);
constexpr std::uint32_t enabled_on_processor_clock = 5;
constexpr std::uint32_t last_tick = 0xffffff;
constexpr std::uint64_t instructions_per_tick = 40; // 1 GHz by -icount shift=0 over 25 MHz

std::uint32_t seen = last_tick; // SysTick counts down
std::uint64_t ticks = 0;

} // namespace

void start_instruction_clock() {
    reload = last_tick;
    current = 0; // any value clears it; it then reloads
    control = enabled_on_processor_clock;
    seen = current;
    ticks = 0;
}

std::uint64_t instructions() {
    const std::uint32_t now = current;
    ticks += (seen - now) & last_tick;
    seen = now;
    return ticks * instructions_per_tick;
}

} // namespace osem::cortex_m
