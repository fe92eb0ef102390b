set(CMAKE_SYSTEM_PROCESSOR s390x)
set(OSEM_TRIPLET s390x-linux-gnu)
set(OSEM_EMULATOR qemu-s390x)
include(${CMAKE_CURRENT_LIST_DIR}/linux.cmake)
