#include "platform.hpp"

namespace osem::port {

void print_number(std::uint64_t value, int width) {
    char text[32];
    char* at = text + sizeof text;
    *--at = '\0';
    do {
        *--at = static_cast<char>('0' + value % 10);
        value /= 10;
        --width;
    } while (value != 0);
    for (; width > 0 && at != text; --width) *--at = ' ';
    print(at);
}

void print_hexadecimal(std::uint64_t value) {
    char text[17];
    text[16] = '\0';
    for (int i = 15; i >= 0; --i, value >>= 4) text[i] = "0123456789abcdef"[value & 15U];
    print(text);
}

} // namespace osem::port
