#!/usr/bin/env bash
# Proves the kernel on one target: cross/target.sh TARGET BUILD-FOLDER. The freestanding proof, the pinned
# digests at several optimisation levels, the replay of the oracle's vectors (in BUILD-FOLDER/vectors), on some
# targets the GoogleTest suites, on Cortex-M the example firmware (made with the osem tool $OSEM_TOOL). Its
# line of cross/run.sh's table is printed and goes to BUILD-FOLDER/TARGET/line.
set -euo pipefail
. "$(dirname "$0")/targets.sh"
[ $# -eq 2 ] || {
    echo "usage: cross/target.sh TARGET BUILD-FOLDER" >&2
    exit 1
}
target=$1
require_target "$target"
mkdir -p "$2/$target"
common=$(cd "$2" && pwd)
out=$common/$target
rm -f "$out/line"
fail() {
    echo "$target: $*" >&2
    exit 1
}

# show LOG: what of a log tells why something failed.
show() {
    { grep -E -A 5 'error|Error|FAILED|expected' "$1" || tail -n 20 "$1"; } | sed -n '1,40p' >&2
}

# prepare FOLDER LEVEL ARGUMENTS...: configures a build tree of the target.
prepare() {
    configure "$target" "$@" > "$out/configure.log" 2>&1 || {
        show "$out/configure.log"
        fail "cannot configure $1"
    }
}

# build FOLDER PROGRAM...: quiet unless it fails.
build() {
    local folder=$1
    shift
    cmake --build "$folder" --target "$@" > "$folder.log" 2>&1 || {
        show "$folder.log"
        fail "cannot build $*"
    }
}

"$cross/check_freestanding.sh" "$target" > "$out/freestanding" || fail "not freestanding"

# The main build: Cortex-M images are what firmware is, optimised for size.
main=O2
[ "${target#cortex-m}" = "$target" ] || main=Os
# Each compiler here, big-endian, and a Cortex-M run at every optimisation level, the other targets at the two that
# firmware and packages are built with. Link-time optimisation makes one frame of a scenario and all that it calls,
# which outgrows the 2 KB that the micro:bit has left for a stack; the Cortex-M4 runs it.
levels=0
case $target in
x86_64-* | armhf | s390x | cortex-m4) wanted=(O0 O2 Os LTO) ;;
cortex-m0) wanted=(O0 O2 Os) ;;
*) wanted=(O2 Os) ;;
esac
for level in "${wanted[@]}"; do
    prepare "$out/$level" "$level"
    build "$out/$level" osem_scenarios
    run_on "$target" "$out/$level/cross/scenarios/osem_scenarios" > "$out/digests" || fail "the scenarios end badly at $level"
    diff -u --label pinned --label "on $target" "$cross/digests.txt" "$out/digests" >&2 || fail "other digests than cross/digests.txt at $level"
    levels=$((levels + 1))
done

# Every case written has to be replayed, but for those too large for a Cortex-M part: at most a fifth of a topic.
build "$out/$main" osem_replay
(cd "$common/vectors" && run_on "$target" "$out/$main/cross/replay/osem_replay" *.vec) > "$out/replay" || {
    show "$out/replay"
    fail "the replay failed"
}
too_large_allowed=0
[ "${target#cortex-m}" = "$target" ] || too_large_allowed=20
awk -v percent=$too_large_allowed '
    FNR == NR { if (FNR > 1) { written[$1] = $3; ++topics } next }
    { for (i = 2; i <= 4; ++i) { split($i, field, "="); count[field[1]] = field[2] } }
    $1 == "replay" { done = 1; next }
    { ++replayed; if (count["cases"] + count["too_large"] != written[$1] ||
                      100 * count["too_large"] > percent * written[$1]) { print "of topic", $0; exit 1 } }
    END { if (!done || replayed != topics || topics == 0) { print "of", topics, "topics", replayed + 0, "were replayed"; exit 1 } }
    ' "$common/vectors/written.txt" "$out/replay" >&2 || fail "not every case was replayed"
read -r cases failures too_large < <(sed -n 's/^replay cases=\([0-9]*\) failures=\([0-9]*\) too_large=\([0-9]*\)$/\1 \2 \3/p' "$out/replay")

# suite PROGRAM: runs a GoogleTest suite; adds the number of its tests, none of them skipped.
suite() {
    local passed
    run_on "$target" "$out/tests/host_tests/$1" > "$out/tests.log" 2>&1 || {
        show "$out/tests.log"
        fail "$1 failed"
    }
    passed=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) tests\?\.$/\1/p' "$out/tests.log")
    [ "${passed:-0}" -gt 0 ] || fail "$1 ran no test"
    ! grep -q SKIPPED "$out/tests.log" || fail "$1 skips tests"
    tests=$((tests + passed))
}

tests=-
case $target in
armhf | s390x)
    prepare "$out/tests" O2 -DOSEM_BUILD_TESTS=ON -DOSEM_BUILD_TOOL=ON -DOSEM_BUILD_ORACLE=OFF
    build "$out/tests" osem_kernel_tests osem_mesh_tests osem_first_octree
    run_on "$target" "$out/tests/host_tests/readme/osem_first_octree" || fail "the README's program failed"
    tests=0
    suite kernel/osem_kernel_tests
    suite mesh/osem_mesh_tests
    ;;
esac

firmware=-
case $target in
cortex-m*)
    prepare "$out/firmware" Os -DOSEM_TOOL="$OSEM_TOOL" -DOSEM_NODE_INDEX_BITS=16
    for example in stock_removal keep_out; do
        build "$out/firmware" "osem_$example"
        run_on "$target" "$out/firmware/port/cortex_m/examples/osem_$example" > "$out/$example.txt" || {
            cat "$out/$example.txt" >&2
            fail "$example ends badly"
        }
        diff -u --label pinned --label "on $target" "$root/port/cortex_m/examples/$example.txt" "$out/$example.txt" >&2 || fail "$example prints something else"
    done
    firmware=same
    ;;
esac

printf '%-13s %-30s %9d %9d %10d %6d/%d  %-16s %6s %9s\n' "$target" "$(describe_target "$target")" \
    "$cases" "$failures" "$too_large" "$levels" "${#wanted[@]}" "$(sed -n 's/^all //p' "$out/digests")" "$tests" "$firmware" > "$out/line"
cat "$out/line"
