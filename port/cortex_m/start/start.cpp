// From reset to main and from main to the exit code, for any Cortex-M part. The linker script gives the
// section borders and the stack.
#include <cstdint>

#include "semihosting.hpp"

extern "C" {
extern std::uint32_t data_load[], data_start[], data_end[];
extern std::uint32_t bss_start[], bss_end[];
extern std::uint32_t stack_top[];
extern void (*init_array_start[])();
extern void (*init_array_end[])();

int main(int argc, char** argv);
/// The arguments of main; only in programs that link command_line.cpp, for the words take RAM.
__attribute__((weak)) int read_command_line(char*** arguments);
[[noreturn]] void reset();
[[noreturn]] void fault();
}

void reset() {
    const std::uint32_t* from = data_load;
    for (std::uint32_t* to = data_start; to != data_end;) *to++ = *from++;
    for (std::uint32_t* to = bss_start; to != bss_end;) *to++ = 0;
    for (void (**constructor)() = init_array_start; constructor != init_array_end; ++constructor) {
        (*constructor)();
    }
    char** arguments = nullptr;
    const int count = read_command_line != nullptr ? read_command_line(&arguments) : 0;
    osem::cortex_m::exit(main(count, arguments));
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
const Vectors vectors = {stack_top,
                         {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
                          fault, fault, fault}};
