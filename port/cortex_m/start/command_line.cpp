// The arguments of main, cut out of the semihosting command line.
#include "semihosting.hpp"

extern "C" int read_command_line(char*** arguments);

namespace {

constexpr int most_arguments = 16;
char words[512];
char* starts[most_arguments + 1];

[[noreturn]] void too_long() {
    osem::cortex_m::write("the command line is too long\n");
    osem::cortex_m::exit(70);
}

} // namespace

int read_command_line(char*** arguments) {
    int count = 0;
    if (!osem::cortex_m::command_line(words, sizeof words)) too_long();
    for (char* at = words;;) {
        while (*at == ' ') *at++ = '\0';
        if (*at == '\0') break;
        if (count == most_arguments) too_long();
        starts[count++] = at;
        while (*at != ' ' && *at != '\0') ++at;
    }
    *arguments = starts;
    return count;
}
