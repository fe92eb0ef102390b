set(CMAKE_SYSTEM_PROCESSOR riscv64)
set(OSEM_TRIPLET riscv64-linux-gnu)
set(OSEM_EMULATOR qemu-riscv64)
include(${CMAKE_CURRENT_LIST_DIR}/linux.cmake)
