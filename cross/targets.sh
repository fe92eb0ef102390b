# Sourced: the targets, and how to build for them and run on them.
cross=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$cross/.." && pwd)

all_targets="x86_64-gcc x86_64-clang armhf armhf-clang aarch64 riscv64 i386 s390x cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33"

# require_target NAME: ends the program if there is no such target.
require_target() {
    [[ " $all_targets " == *" $1 "* ]] || {
        echo "no target $1; there are: $all_targets" >&2
        exit 1
    }
}

# toolchain_value TARGET NAME: what the target's toolchain file sets NAME to; empty if it does not.
toolchain_value() {
    sed -n "s/^set($2 \([^ )]*\).*/\1/p" "$cross/toolchains/$1.cmake"
}

# target_compiler TARGET: the C++ compiler and the options that choose the processor.
target_compiler() {
    case $1 in
    x86_64-gcc) echo g++ ;;
    x86_64-clang) echo clang++ ;;
    *-clang) echo "clang++ --target=$(toolchain_value "$1" OSEM_TRIPLET)" ;;
    cortex-m*) echo "arm-none-eabi-g++ -mcpu=$(toolchain_value "$1" OSEM_CPU) -mthumb" ;;
    *) echo "$(toolchain_value "$1" OSEM_TRIPLET)-g++" ;;
    esac
}

# target_tool TARGET NAME: a program of the target's binary utilities.
target_tool() {
    case $1 in
    x86_64-*) echo "$2" ;;
    cortex-m*) echo "arm-none-eabi-$2" ;;
    *) echo "$(toolchain_value "$1" OSEM_TRIPLET)-$2" ;;
    esac
}

# configure TARGET FOLDER LEVEL ARGUMENTS...: a build tree at an optimisation level: O0, O2, Os, or LTO.
# Without tests and host tool, unless the arguments say otherwise. CMake reads a build type's options from a
# variable in capitals; that they have arrived is looked up in the commands.
configure() {
    local target=$1 folder=$2 level=$3 flags=-$3 choice
    shift 3
    [ "$level" != LTO ] || flags="-O2 -flto"
    case $target in
    x86_64-*) choice=(-DCMAKE_CXX_COMPILER="$(target_compiler "$target")") ;;
    *) choice=(--toolchain "$cross/toolchains/$target.cmake") ;;
    esac
    cmake -S "$root" -B "$folder" "${choice[@]}" -DCMAKE_BUILD_TYPE="$level" "-DCMAKE_CXX_FLAGS_${level^^}=$flags" \
        -DOSEM_BUILD_CROSS=ON -DOSEM_BUILD_TESTS=OFF -DOSEM_BUILD_TOOL=OFF "$@" &&
        grep -q -e " $flags " "$folder/compile_commands.json"
}

# run_on TARGET PROGRAM ARGUMENTS...: runs a program of the target, under QEMU where it is not this machine's.
# Whatever takes longer than half an hour hangs.
run_on() {
    local target=$1 program=$2
    shift 2
    case $target in
    x86_64-*) timeout 1800 "$program" "$@" ;;
    cortex-m*)
        timeout 1800 qemu-system-arm -M "$(toolchain_value "$target" OSEM_MACHINE)" -nographic -monitor none -serial none \
            -semihosting-config enable=on,target=native -kernel "$program" -append "$*" ;;
    *) timeout 1800 "$(toolchain_value "$target" OSEM_EMULATOR)" "$program" "$@" ;;
    esac
}

# describe_target TARGET: what it runs on, in a few words.
describe_target() {
    case $1 in
    x86_64-*) echo "this machine, $(target_compiler "$1")" ;;
    cortex-m*) echo "qemu-system-arm $(toolchain_value "$1" OSEM_MACHINE)" ;;
    *-clang) echo "$(toolchain_value "$1" OSEM_EMULATOR), clang++" ;;
    s390x) echo "$(toolchain_value "$1" OSEM_EMULATOR), big-endian" ;;
    *) toolchain_value "$1" OSEM_EMULATOR ;;
    esac
}
