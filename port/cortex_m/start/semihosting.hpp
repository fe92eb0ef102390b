// Arm semihosting: output, input files, the command line and the exit code, through a debugger or QEMU.
// Source: Arm, "Semihosting for AArch32 and AArch64" (ABI document). Operations are named as there.
#ifndef OSEM_CORTEX_M_SEMIHOSTING_HPP
#define OSEM_CORTEX_M_SEMIHOSTING_HPP

#include <cstddef>
#include <cstdint>

namespace osem::cortex_m {

/// Writes a text to the host's standard output (SYS_WRITE to the file :tt).
void write(const char* text);

/// Opens a file of the host for reading (SYS_OPEN): a handle, or -1.
std::int32_t open(const char* path);

/// Reads up to `count` bytes (SYS_READ): how many there were; fewer than asked for only at the end.
std::size_t read(std::int32_t handle, std::uint8_t* bytes, std::size_t count);

void close(std::int32_t handle); ///< SYS_CLOSE

/// The command line of the program (SYS_GET_CMDLINE), words separated by spaces; false when there is none
/// or it is longer than `capacity` - 1.
bool command_line(char* text, std::size_t capacity);

/// Ends the program with an exit code (SYS_EXIT_EXTENDED; for code 0 plain SYS_EXIT, which all know).
[[noreturn]] void exit(std::int32_t code);

} // namespace osem::cortex_m

#endif
