#!/usr/bin/env bash
# Measures what the kernel's tests reach of kernel/: lines, branches, and conditions by MC/DC (Clang 19). Prints a
# table of files, then every line, branch and condition that was not reached; with --check, fails if one of
# them is not marked (coverage.py says how). Installs what it needs. The build tree goes to
# $OSEM_BUILD_DIR/coverage (default: build/coverage).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(realpath -m "${OSEM_BUILD_DIR:-$root/build}")/coverage
. "$root/host_tests/packages.sh"
install_packages cmake make clang-19 llvm-19 libclang-rt-19-dev libgtest-dev python3

# Counters in the kernel's files alone: the oracles of the tests would count longer than they work.
flags="-fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc -fprofile-list=$root/host_tests/coverage.list"
cmake -S "$root" -B "$build" -DCMAKE_CXX_COMPILER=clang++-19 -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="$flags" \
    -DCMAKE_CXX_FLAGS_DEBUG=-O1 -DOSEM_BUILD_TOOL=OFF -DOSEM_BUILD_ORACLE=OFF > /dev/null
cmake --build "$build" --parallel "$(nproc)" --target osem_kernel_tests > "$build/build.log" 2>&1 || {
    tail -n 40 "$build/build.log" >&2
    exit 1
}
program=$build/host_tests/kernel/osem_kernel_tests
LLVM_PROFILE_FILE=$build/kernel.profraw "$program" > "$build/tests.log" || { tail -n 40 "$build/tests.log" >&2; exit 1; }
llvm-profdata-19 merge -sparse "$build/kernel.profraw" -o "$build/kernel.profdata"
python3 "$root/host_tests/coverage.py" "$@" "$root" "$build/kernel.profdata" "$program"
