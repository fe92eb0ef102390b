#!/usr/bin/env bash
# Proves that the kernel is freestanding: every source alone, for Cortex-M0, without a library. Fails on an
# undefined symbol outside allowed_symbols.txt, on writable data, and on a cycle in the call graph
# (recursion). Prints the size of each object.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
kernel=$here/../kernel
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

flags=(-std=c++17 -mcpu=cortex-m0 -mthumb -Os -ffreestanding -fno-exceptions -fno-rtti -nostdlib
       -fno-threadsafe-statics -ffunction-sections -fcallgraph-info
       -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror
       -I"$kernel/include" -I"$kernel/src")

for index_bits in 32 16; do
    objects=()
    while IFS= read -r source; do
        object=$out/$(basename "$source" .cpp).$index_bits.o
        arm-none-eabi-g++ "${flags[@]}" -DOSEM_NODE_INDEX_BITS=$index_bits -c "$source" -o "$object"
        objects+=("$object")
    done < <(find "$kernel/src" -name '*.cpp' | sort)

    # Undefined once all of the kernel is in one object.
    arm-none-eabi-g++ -mcpu=cortex-m0 -mthumb -nostdlib -r "${objects[@]}" -o "$out/kernel.o"
    unexpected=$(arm-none-eabi-nm -u "$out/kernel.o" | awk '{print $2}' | sort -u |
                 grep -vxF -f <(grep -v '^#' "$here/allowed_symbols.txt") || true)
    if [ -n "$unexpected" ]; then
        for symbol in $unexpected; do
            for object in "${objects[@]}"; do
                if arm-none-eabi-nm -u "$object" | grep -qw "$symbol"; then
                    echo "freestanding: $(basename "$object") wants $symbol" >&2
                fi
            done
        done
        exit 1
    fi

    echo "Cortex-M0, -Os, ${index_bits}-bit indices (bytes: text data bss)"
    arm-none-eabi-size "${objects[@]}" | awk -v out="$out/" '
        NR > 1 { sub(out, "", $6); printf "  %6d %4d %4d  %s\n", $1, $2, $3, $6
                 text += $1; writable += $2 + $3 }
        END { printf "  %6d             whole kernel\n", text
              if (writable > 0) { print "freestanding: the kernel has writable data" > "/dev/stderr"; exit 1 } }'

    # Recursion would be a cycle among the call graph's edges: tsort names one, but takes a call of oneself
    # for an isolated node.
    cat "$out"/*."$index_bits".ci | sed -n 's/^edge: { sourcename: "\([^"]*\)" targetname: "\([^"]*\)".*/\1 \2/p' |
        sort -u > "$out/calls"
    if awk '$1 == $2 { print "freestanding: recursion: " $1 > "/dev/stderr"; found = 1 } END { exit !found }' "$out/calls"; then
        exit 1
    fi
    if ! tsort "$out/calls" > /dev/null 2> "$out/cycle"; then
        echo "freestanding: recursion: $(tr '\n' ' ' < "$out/cycle")" >&2
        exit 1
    fi
    echo "  $(wc -l < "$out/calls") calls, no cycle"
done
