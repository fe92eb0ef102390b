#!/usr/bin/env bash
# Proves the kernel on one target: cross/target.sh TARGET BUILD-FOLDER. The freestanding proof, the pinned
# digests at every optimisation level, the replay of the oracle's vectors (in BUILD-FOLDER/vectors), on some
# targets the GoogleTest suites, on Cortex-M the example firmware (made with the osem tool $OSEM_TOOL). Its line of cross/run.sh's table goes to BUILD-FOLDER/TARGET/line.
set -euo pipefail
. "$(dirname "$0")/targets.sh"
target=$1
vectors=$2/vectors
out=$2/$target
mkdir -p "$out"
rm -f "$out/line"
fail() {
    echo "$target: $*" >&2
    exit 1
}

# build FOLDER PROGRAM...: quiet unless it fails.
build() {
    local folder=$1
    shift
    cmake --build "$folder" --target "$@" > "$folder.log" 2>&1 || {
        grep -E 'error|Error' -A 5 "$folder.log" | head -n 40 >&2
        fail "cannot build $*"
    }
}

"$cross/check_freestanding.sh" "$target" > "$out/freestanding" || fail "not freestanding"

# The main build: Cortex-M images are what firmware is, optimised for size.
main=O2
[ "${target#cortex-m}" = "$target" ] || main=Os
levels=0
for level in O0 O2 Os LTO; do
    configure "$target" "$out/$level" "$level" > "$out/configure.log" 2>&1 ||
        fail "cannot configure $level"
    build "$out/$level" osem_scenarios
    run_on "$target" "$out/$level/cross/scenarios/osem_scenarios" > "$out/digests" || fail "scenarios end badly at $level"
    diff "$cross/digests.txt" "$out/digests" >&2 || fail "other digests than cross/digests.txt at $level"
    levels=$((levels + 1))
done

build "$out/$main" osem_replay
(cd "$vectors" && run_on "$target" "$out/$main/cross/replay/osem_replay" *.vec) > "$out/replay" || {
    cat "$out/replay" >&2
    fail "replay failed"
}
eval "$(sed -n 's/^replay //p' "$out/replay" | tr ' ' '\n')" # cases=... failures=... too_large=...

tests=-
case $target in
armhf | s390x)
    configure "$target" "$out/tests" O2 -DOSEM_BUILD_TESTS=ON -DOSEM_BUILD_TOOL=ON > "$out/configure.log" 2>&1 || fail "cannot configure the tests"
    build "$out/tests" osem_kernel_tests osem_mesh_tests osem_first_octree
    run_on "$target" "$out/tests/host_tests/readme/osem_first_octree" || fail "the README's program failed"
    tests=0
    for suite in kernel/osem_kernel_tests mesh/osem_mesh_tests; do
        run_on "$target" "$out/tests/host_tests/$suite" > "$out/tests.log" || {
            grep -B 20 FAILED "$out/tests.log" >&2
            fail "$suite failed"
        }
        tests=$((tests + $(sed -n 's/^\[  PASSED  \] \([0-9]*\) tests\?\.$/\1/p' "$out/tests.log")))
    done
    ;;
esac

firmware=-
case $target in
cortex-m*)
    configure "$target" "$out/firmware" Os -DOSEM_TOOL="$OSEM_TOOL" -DOSEM_NODE_INDEX_BITS=16 > "$out/configure.log" 2>&1 ||
        fail "cannot configure the firmware"
    for example in stock_removal keep_out; do
        build "$out/firmware" "osem_$example"
        run_on "$target" "$out/firmware/port/cortex_m/examples/osem_$example" > "$out/$example.txt"
        diff "$2/$example.txt" "$out/$example.txt" >&2 || fail "$example prints something else than on this machine"
    done
    firmware=same
    ;;
esac

printf '%-13s %-30s %9d %9d %10d %6d/4  %-16s %6s %9s\n' "$target" "$(describe_target "$target")" \
    "$cases" "$failures" "$too_large" "$levels" "$(sed -n 's/^all //p' "$out/digests")" "$tests" "$firmware" > "$out/line"
