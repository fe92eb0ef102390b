// From reset to main and from main to the exit code, for any Cortex-M part. The linker script gives the
// section borders and the stack.
#include <cstdint>

#include "semihosting.hpp"

extern "C" {
extern std::uint32_t __data_load[], __data_start[], __data_end[]; // NOLINT(bugprone-reserved-identifier)
extern std::uint32_t __bss_start[], __bss_end[];                  // NOLINT(bugprone-reserved-identifier)
extern std::uint32_t __stack_top[];                               // NOLINT(bugprone-reserved-identifier)
extern void (*__init_array_start[])();                            // NOLINT(bugprone-reserved-identifier)
extern void (*__init_array_end[])();                              // NOLINT(bugprone-reserved-identifier)

int main(int argc, char** argv);
[[noreturn]] void reset();
[[noreturn]] void fault();
}

namespace {

constexpr int most_arguments = 12;
char words[512];
char* arguments[most_arguments + 1];

// Cuts the command line at its spaces.
int split_command_line() {
    int count = 0;
    if (!osem::cortex_m::command_line(words, sizeof words)) return count;
    char* at = words;
    while (count < most_arguments) {
        while (*at == ' ') *at++ = '\0';
        if (*at == '\0') break;
        arguments[count++] = at;
        while (*at != ' ' && *at != '\0') ++at;
    }
    return count;
}

} // namespace

void reset() {
    const std::uint32_t* from = __data_load;
    for (std::uint32_t* to = __data_start; to != __data_end;) *to++ = *from++;
    for (std::uint32_t* to = __bss_start; to != __bss_end;) *to++ = 0;
    for (void (**constructor)() = __init_array_start; constructor != __init_array_end; ++constructor) {
        (*constructor)();
    }
    osem::cortex_m::exit(main(split_command_line(), arguments));
}

// Every exception that no program expects; 70 tells it from a program's own exit codes.
void fault() {
    osem::cortex_m::write("fault\n");
    osem::cortex_m::exit(70);
}

// The vectors of the architecture, without a part's interrupts, which nothing here turns on.
struct Vectors {
    void* stack;
    void (*handlers[15])();
};

extern const Vectors vectors;
__attribute__((section(".vectors"), used))
const Vectors vectors = {__stack_top,
                         {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
                          fault, fault, fault}};
