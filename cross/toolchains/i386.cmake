set(CMAKE_SYSTEM_PROCESSOR i686)
set(OSEM_TRIPLET i686-linux-gnu)
set(OSEM_EMULATOR qemu-i386)
include(${CMAKE_CURRENT_LIST_DIR}/linux.cmake)
