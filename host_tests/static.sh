#!/usr/bin/env bash
# Looks at the sources without running them: cppcheck over the kernel and the port, GCC's analyzer over the kernel
# (host_tests/static.sh). Installs what it needs. host_tests/run.sh runs clang-tidy; recursion and stack have proofs
# of their own, cross/check_freestanding.sh and cross/resources/stack_bound.py.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/host_tests/packages.sh"
install_packages cppcheck g++
cd "$root"

# Both widths of a node's index; every macro that stands in a condition as it is on each target.
echo "cppcheck: the kernel and the port"
for index_bits in 32 16; do
    cppcheck --quiet --error-exitcode=1 --std=c++17 --platform=unix64 --enable=warning,style,performance,portability \
        --suppressions-list=host_tests/cppcheck.txt --suppress=unmatchedSuppression -j "$(nproc)" \
        -DOSEM_NODE_INDEX_BITS="$index_bits" -DOSEM_FAST_CRC=1 -Ikernel/include -Ikernel/src -Iport/host -Iport/platform \
        kernel/src port/host port/platform port/cortex_m
done

# The analyzer follows paths through one source at a time. That CsgExpression's tokens leave a value on its stack is
# begin()'s business, which it does not see: so of that source it is not asked about values never set. Of vectors that
# are shifted GCC 12's takes the number of elements for that of bits.
echo "analyzer: the kernel"
analyze() {
    local unasked=()
    [ "$1" != kernel/src/csg/expression.cpp ] || unasked=(-Wno-analyzer-use-of-uninitialized-value)
    [[ $1 != kernel/src/grid/* ]] || unasked=(-Wno-analyzer-shift-count-overflow)
    g++ -std=c++17 -O1 -ffreestanding -fno-exceptions -fno-rtti -fanalyzer -Werror "${unasked[@]}" \
        -Ikernel/include -Ikernel/src -c "$1" -o /dev/null
}
export -f analyze
find kernel/src -name '*.cpp' | sort | xargs --max-procs="$(nproc)" -I{} bash -c 'set -euo pipefail; analyze {}'
echo "nothing found"
