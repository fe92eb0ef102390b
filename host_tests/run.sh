#!/usr/bin/env bash
# Runs every test that CI runs: format, both compilers, with and without sanitizers, both index widths, coverage, a
# short turn of the fuzzers, static analysis, every architecture (cross/run.sh), clang-tidy. Installs what it needs.
# Build trees go to $OSEM_BUILD_DIR (default: build/).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(realpath -m "${OSEM_BUILD_DIR:-$root/build}")
jobs=$(nproc)
. "$root/host_tests/packages.sh"
started=$SECONDS
stage() { printf '\n== %s (%d s)\n' "$1" $((SECONDS - started)); }

stage "packages"
install_packages cmake make g++ clang clang-format clang-tidy libclang-rt-14-dev libgtest-dev libcgal-dev libgmp-dev \
    libmpfr-dev libcli11-dev libstb-dev libtinyobjloader-dev

. "$root/host_tests/meshes.sh"
stage "meshes"
OSEM_CGAL_DATA=$(unpack_meshes "$build")
export OSEM_CGAL_DATA

stage "format"
(cd "$root" && git ls-files '*.cpp' '*.hpp' '*.h' | xargs clang-format --dry-run --Werror)

# run NAME CMAKE-ARGUMENTS...
run() {
    local name=$1
    shift
    stage "$name: build"
    cmake -S "$root" -B "$build/$name" "$@" > /dev/null
    cmake --build "$build/$name" --parallel "$jobs" > "$build/$name.log" 2>&1 || {
        { grep -E 'error|Error' -A 5 "$build/$name.log" || tail -n 20 "$build/$name.log"; } | sed -n '1,60p' >&2
        exit 1
    }
    stage "$name: test"
    OSEM_ORACLE_LEVEL=full ctest --test-dir "$build/$name" --parallel "$jobs" --output-on-failure --no-tests=error \
        > "$build/$name.log" || { tail -n 100 "$build/$name.log" >&2; exit 1; }
    grep "tests passed" "$build/$name.log"
}
# CGAL is the long part to build, so the oracle is asked once, in full; what it answered is replayed under sanitizers
# below, as it is on every architecture. The last run compiles the kernel's tests one by one (OSEM_BATCHES), as
# clang-tidy reads the tool's files, which shows that they include what they use.
sanitize=(-DCMAKE_BUILD_TYPE=Debug '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1' -DOSEM_SANITIZE=ON)
run gcc-release -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release -DOSEM_BUILD_CROSS=ON
without=(-DOSEM_BUILD_ORACLE=OFF -DOSEM_BUILD_CROSS=ON)
run clang-sanitize -DCMAKE_CXX_COMPILER=clang++ "${sanitize[@]}" "${without[@]}"
run clang-release -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release "${without[@]}"
run gcc-sanitize-16-bit -DCMAKE_CXX_COMPILER=g++ "${sanitize[@]}" -DOSEM_NODE_INDEX_BITS=16 -DOSEM_FAST_CRC=OFF \
    -DOSEM_BUILD_TOOL=OFF -DOSEM_BATCHES=OFF "${without[@]}"

stage "coverage"
OSEM_BUILD_DIR=$build bash "$root/host_tests/coverage.sh" --check > "$build/coverage.log" || {
    tail -n 60 "$build/coverage.log" >&2
    exit 1
}
grep "^all" "$build/coverage.log"

stage "fuzzing, the short form"
OSEM_FUZZ_SEED=1 OSEM_BUILD_DIR=$build bash "$root/fuzz/run.sh" 5

stage "static analysis"
OSEM_BUILD_DIR=$build bash "$root/host_tests/static.sh"

stage "every architecture"
OSEM_BUILD_DIR=$build "$root/cross/run.sh"

stage "the oracles' vectors under sanitizers"
(cd "$build/cross/vectors" && "$build/clang-sanitize/cross/replay/osem_replay" ./*.vec) > "$build/replay.log" || {
    tail -n 40 "$build/replay.log" >&2
    exit 1
}
tail -n 1 "$build/replay.log"

# What only a bare-metal part has is looked at with the headers and options of its own compiler.
stage "tidy"
tidy() {
    xargs --max-args=1 --max-procs="$jobs" clang-tidy --quiet "$@" 2> /dev/null
}
mapfile -t headers < <(arm-none-eabi-g++ -mcpu=cortex-m0 -mthumb -E -x c++ - -v < /dev/null 2>&1 |
                       sed -n '/#include </,/End/s/^ /--extra-arg=-isystem/p')
cd "$root"
cmake -S . -B "$build/tidy" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DOSEM_BATCHES=OFF "${without[@]}" > /dev/null
git ls-files 'port/cortex_m/start/*.cpp' port/platform/semihosted.cpp | tidy -p "$build/cross/cortex-m0/Os" "${headers[@]}"
git ls-files 'port/cortex_m/examples/*.cpp' | tidy -p "$build/cross/firmware"
git ls-files 'kernel/*.cpp' 'port/*.cpp' 'cross/replay/*.cpp' 'cross/scenarios/*.cpp' |
    grep -v -e ^port/cortex_m -e semihosted | tidy -p "$build/tidy"

stage "quick start"
OSEM_BUILD_DIR=$build bash "$root/port/host/quickstart.sh" "$build/out" > "$build/quickstart.log"
tail -n 1 "$build/quickstart.log"

stage "all passed"
