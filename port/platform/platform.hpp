// What a program that runs on every target asks of the machine: one input file and a text output. It has a
// plain main(int argc, char** argv), on a bare-metal part too; the return value is the exit code.
#ifndef OSEM_PORT_PLATFORM_HPP
#define OSEM_PORT_PLATFORM_HPP

#include <cstddef>
#include <cstdint>

namespace osem::port {

/// Opens the input file, closing the one before; false when it cannot be opened.
bool open_input(const char* path);

/// Reads the next bytes of the input file; fewer than asked for only at its end.
std::size_t read_input(std::uint8_t* bytes, std::size_t count);

/// Writes text to the standard output.
void print(const char* text);

/// Writes a number: decimal, right-aligned to `width`; or 16 hexadecimal digits.
void print_number(std::uint64_t value, int width = 0);
void print_hexadecimal(std::uint64_t value);

} // namespace osem::port

#endif
