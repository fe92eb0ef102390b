# What the Cortex-M targets have in common. Set before: OSEM_CPU; OSEM_BOARD, whose linker script is used;
# OSEM_MACHINE, QEMU's name of it; OSEM_ARENA, the bytes that the replay's cases have there.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_AR arm-none-eabi-gcc-ar) # the ar that knows link-time optimisation
set(CMAKE_RANLIB arm-none-eabi-gcc-ranlib)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY) # a test program would need the board's linker script
set(CMAKE_CXX_FLAGS_INIT "-mcpu=${OSEM_CPU} -mthumb -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti \
-fno-threadsafe-statics")
set(CMAKE_EXE_LINKER_FLAGS_INIT --specs=nano.specs)
set(OSEM_REPLAY_ARENA ${OSEM_ARENA} CACHE STRING "Bytes of memory that the replay's cases are given")
