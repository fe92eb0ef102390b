set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(OSEM_TRIPLET aarch64-linux-gnu)
set(OSEM_EMULATOR qemu-aarch64)
include(${CMAKE_CURRENT_LIST_DIR}/linux.cmake)
