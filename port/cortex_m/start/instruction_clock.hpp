// Instructions counted by QEMU. Under `-icount shift=0` virtual time goes on by one nanosecond with every
// instruction, and SysTick, which every Cortex-M has, counts virtual time.
#ifndef OSEM_CORTEX_M_INSTRUCTION_CLOCK_HPP
#define OSEM_CORTEX_M_INSTRUCTION_CLOCK_HPP

#include <cstdint>

namespace osem::cortex_m {

/// Starts the clock.
void start_instruction_clock();

/// Instructions since the start, in steps of one tick (40 instructions at the MPS2 boards' 25 MHz). Ask
/// again before 2^24 ticks (671 million instructions) have passed: SysTick wraps round once.
std::uint64_t instructions();

} // namespace osem::cortex_m

#endif
