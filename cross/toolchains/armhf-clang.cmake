# Clang for the same target as armhf, on GCC's C library and assembler.
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(OSEM_TRIPLET arm-linux-gnueabihf)
set(OSEM_EMULATOR qemu-arm)
set(OSEM_COMPILER clang)
include(${CMAKE_CURRENT_LIST_DIR}/linux.cmake)
