// The platform on a bare-metal Cortex-M: files and text go through semihosting.
#include "platform.hpp"
#include "semihosting.hpp"

namespace osem::port {

namespace {

std::int32_t input = -1;

} // namespace

bool open_input(const char* path) {
    if (input != -1) cortex_m::close(input);
    input = cortex_m::open(path);
    return input != -1;
}

std::size_t read_input(std::uint8_t* bytes, std::size_t count) { return cortex_m::read(input, bytes, count); }

void print(const char* text) { cortex_m::write(text); }

} // namespace osem::port
