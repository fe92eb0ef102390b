#include "semihosting.hpp"

namespace osem::cortex_m {

namespace {

enum Operation : std::uint32_t {
    sys_open = 0x01,
    sys_close = 0x02,
    sys_write = 0x05,
    sys_read = 0x06,
    sys_get_cmdline = 0x15,
    sys_exit = 0x18,
    sys_exit_extended = 0x20,
};

constexpr std::uint32_t binary_for_reading = 1;
constexpr std::uint32_t text_for_writing = 4;
constexpr std::uint32_t application_exit = 0x20026;

// M-profile parts trap to the debugger at this breakpoint: operation in r0, its argument in r1.
std::uint32_t call(Operation operation, std::uint32_t argument) {
    register std::uint32_t r0 asm("r0") = operation;
    register std::uint32_t r1 asm("r1") = argument;
    asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

template <class T>
std::uint32_t address(T* object) {
    return reinterpret_cast<std::uint32_t>(object);
}

std::size_t length(const char* text) {
    std::size_t count = 0;
    while (text[count] != '\0') ++count;
    return count;
}

std::uint32_t open_file(const char* path, std::uint32_t mode) {
    const std::uint32_t block[] = {address(path), mode, length(path)};
    return call(sys_open, address(block));
}

std::uint32_t standard_output = 0; // no handle is 0

} // namespace

void write(const char* text) {
    if (standard_output == 0) standard_output = open_file(":tt", text_for_writing);
    const std::uint32_t block[] = {standard_output, address(text), length(text)};
    call(sys_write, address(block));
}

std::int32_t open(const char* path) { return static_cast<std::int32_t>(open_file(path, binary_for_reading)); }

std::size_t read(std::int32_t handle, std::uint8_t* bytes, std::size_t count) {
    const std::uint32_t block[] = {static_cast<std::uint32_t>(handle), address(bytes), count};
    const std::uint32_t missing = call(sys_read, address(block)); // all bits set: an error
    return missing < count ? count - missing : 0;
}

void close(std::int32_t handle) {
    const std::uint32_t block[] = {static_cast<std::uint32_t>(handle)};
    call(sys_close, address(block));
}

bool command_line(char* text, std::size_t capacity) {
    const std::uint32_t block[] = {address(text), capacity};
    return call(sys_get_cmdline, address(block)) == 0;
}

void exit(std::int32_t code) {
    if (code == 0) call(sys_exit, application_exit);
    const std::uint32_t block[] = {application_exit, static_cast<std::uint32_t>(code)};
    call(sys_exit_extended, address(block));
    for (;;) {
    }
}

} // namespace osem::cortex_m
