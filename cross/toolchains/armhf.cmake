set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(OSEM_TRIPLET arm-linux-gnueabihf)
set(OSEM_EMULATOR qemu-arm)
include(${CMAKE_CURRENT_LIST_DIR}/linux.cmake)
