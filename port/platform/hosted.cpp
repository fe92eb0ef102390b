// The platform where there is a C library.
#include <cstdio>

#include "platform.hpp"

namespace osem::port {

namespace {

std::FILE* input = nullptr;

} // namespace

bool open_input(const char* path) {
    if (input != nullptr) static_cast<void>(std::fclose(input)); // it was only read
    input = std::fopen(path, "rb");
    return input != nullptr;
}

std::size_t read_input(std::uint8_t* bytes, std::size_t count) { return std::fread(bytes, 1, count, input); }

void print(const char* text) {
    static_cast<void>(std::fputs(text, stdout)); // whoever reads the output misses what is not there
    static_cast<void>(std::fflush(stdout));
}

} // namespace osem::port
