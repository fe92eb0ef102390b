# What the Linux targets have in common; OSEM_TRIPLET and OSEM_EMULATOR are set before. Programs are static,
# so that QEMU user-mode needs no root file system of the target.
set(CMAKE_SYSTEM_NAME Linux)
if(OSEM_COMPILER STREQUAL "clang")
    set(CMAKE_C_COMPILER clang)
    set(CMAKE_CXX_COMPILER clang++)
    set(CMAKE_C_COMPILER_TARGET ${OSEM_TRIPLET})
    set(CMAKE_CXX_COMPILER_TARGET ${OSEM_TRIPLET})
    set(CMAKE_AR llvm-ar) # an ar and a linker that know Clang's link-time optimisation
    set(CMAKE_RANLIB llvm-ranlib)
    set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -fuse-ld=lld")
else()
    set(CMAKE_C_COMPILER ${OSEM_TRIPLET}-gcc) # GoogleTest's project asks for one
    set(CMAKE_CXX_COMPILER ${OSEM_TRIPLET}-g++)
    set(CMAKE_AR ${OSEM_TRIPLET}-gcc-ar)
    set(CMAKE_RANLIB ${OSEM_TRIPLET}-gcc-ranlib)
    set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
endif()
set(CMAKE_CROSSCOMPILING_EMULATOR ${OSEM_EMULATOR})
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE NEVER)
