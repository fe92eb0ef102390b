#!/usr/bin/env bash
# fuzz/run.sh [SECONDS] [TARGET...]: builds the targets with Clang's sanitizers, runs each for so many seconds (60) from
# the inputs in fuzz/corpus and fuzz/failures on, and ends in a table. Fails when one of them finds something.
# Build trees, new inputs and findings go to $OSEM_BUILD_DIR (default: build/). With OSEM_FUZZ_SEED the inputs are tried
# in the same order again, as far as the time goes.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(realpath -m "${OSEM_BUILD_DIR:-$root/build}")/fuzz
seconds=${1:-60}
shift || true
targets=("$@")
all=(predicates solids trees streams csg surface files)
[ "${#targets[@]}" -gt 0 ] || targets=("${all[@]}")
[[ $seconds =~ ^[1-9][0-9]*$ ]] || {
    echo "fuzz/run.sh: $seconds is no number of seconds" >&2
    exit 1
}
for target in "${targets[@]}"; do
    [[ " ${all[*]} " == *" $target "* ]] || {
        echo "fuzz/run.sh: no target $target: there are ${all[*]}" >&2
        exit 1
    }
done

. "$root/host_tests/packages.sh"
install_packages cmake make clang libclang-rt-14-dev libgtest-dev libgmp-dev libcli11-dev libstb-dev libtinyobjloader-dev

cmake -S "$root" -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug '-DCMAKE_CXX_FLAGS_DEBUG=-O2 -g1' \
    -DOSEM_SANITIZE=ON -DOSEM_BUILD_FUZZ=ON -DOSEM_BUILD_TESTS=OFF > /dev/null
mkdir -p "$build/findings"
cmake --build "$build" --parallel "$(nproc)" --target "${targets[@]/#/osem_fuzz_}" > "$build/build.log" 2>&1 || {
    tail -n 40 "$build/build.log" >&2
    exit 1
}

# Memory is bounded so that a file cannot ask for more than it holds; a small quarantine keeps to that bound.
export ASAN_OPTIONS=quarantine_size_mb=8:malloc_context_size=3 UBSAN_OPTIONS=print_stacktrace=1
fuzz() {
    local target=$1 given=() dictionary=()
    mkdir -p "$build/corpus/$target"
    for folder in "$root/fuzz/corpus/$target" "$root/fuzz/failures/$target"; do
        [ ! -d "$folder" ] || given+=("$folder")
    done
    [ ! -f "$root/fuzz/dictionaries/$target" ] || dictionary=(-dict="$root/fuzz/dictionaries/$target")
    "$build/fuzz/osem_fuzz_$target" -seed="${OSEM_FUZZ_SEED:-0}" -max_total_time="$seconds" -max_len=2048 -timeout=20 -malloc_limit_mb=64 \
        -rss_limit_mb=768 -print_final_stats=1 -artifact_prefix="$build/findings/$target-" "${dictionary[@]}" \
        "$build/corpus/$target" "${given[@]}" > "$build/$target.log" 2>&1 || touch "$build/$target.found"
}
export -f fuzz
export build root seconds
rm -f "$build"/*.found
printf '%s\n' "${targets[@]}" | xargs --max-procs="$(nproc)" -I{} bash -c 'fuzz {}'

printf '%-12s %12s %8s %8s %10s  %s\n' target executions exec/s edges features findings
found=0
for target in "${targets[@]}"; do
    log=$build/$target.log
    statistic() { sed -n "s/^stat::$1: *//p" "$log"; }
    coverage=$(grep -o 'cov: [0-9]* ft: [0-9]*' "$log" | tail -n 1 || true)
    finding=none
    if [ -e "$build/$target.found" ]; then
        found=1
        finding=$(grep -o "$build/findings/[^ ]*" "$log" | tail -n 1 || true)
    fi
    printf '%-12s %12s %8s %8s %10s  %s\n' "$target" "$(statistic number_of_executed_units)" \
        "$(statistic average_exec_per_sec)" "$(echo "$coverage" | cut -d ' ' -f 2)" \
        "$(echo "$coverage" | cut -d ' ' -f 4)" "${finding:-see $log}"
done
if [ "$found" -ne 0 ]; then
    for target in "${targets[@]}"; do
        [ ! -e "$build/$target.found" ] || grep -E -A 8 'Failure|ERROR|runtime error' "$build/$target.log" | head -n 30 >&2
    done
    echo "a finding is reproduced by $build/fuzz/osem_fuzz_TARGET FILE; once mended it goes to fuzz/failures/TARGET/" >&2
    exit 1
fi
