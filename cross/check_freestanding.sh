#!/usr/bin/env bash
# Proves that the kernel is freestanding on a target (cross/check_freestanding.sh TARGET): every source alone,
# without a library, at -Os with 32-bit node indices and at -O2 with 16-bit ones. Fails on an undefined symbol outside
# symbols/TARGET.txt, naming the objects that want it; on writable data; and on a cycle in the call graph
# (recursion). Prints the size of each object.
set -euo pipefail
. "$(dirname "$0")/targets.sh"
target=${1:-cortex-m0}
require_target "$target"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
read -ra compiler <<< "$(target_compiler "$target")"
nm=$(target_tool "$target" nm)
size=$(target_tool "$target" size)

flags=(-std=c++17 -ffreestanding -fno-exceptions -fno-rtti -nostdlib -fno-threadsafe-statics -fno-pic
       -ffunction-sections -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror
       -I"$root/kernel/include" -I"$root/kernel/src")
# Clang draws no call graph; GCC's is of the same source.
[ "${target%-clang}" != "$target" ] || flags+=(-fcallgraph-info)

# The symbols that no object of the folder defines, one "symbol object" a line.
undefined() {
    local object
    "$nm" --defined-only "$1"/*.o | awk 'NF == 3 { print $3 }' | sort -u > "$1/defined"
    for object in "$1"/*.o; do
        "$nm" -u "$object" | awk -v object="$(basename "$object")" 'NF == 2 { print $2, object }'
    done | awk -v defined="$1/defined" 'BEGIN { while ((getline line < defined) > 0) known[line] } !($1 in known)'
}

check_symbols() {
    local unexpected
    unexpected=$(undefined "$1" | awk -v allowed="$cross/symbols/$target.txt" '
        BEGIN { while ((getline line < allowed) > 0) known[line] } !($1 in known)')
    [ -z "$unexpected" ] || {
        echo "$unexpected" | sed 's/^\(.*\) \(.*\)$/freestanding: \2 wants \1/' >&2
        exit 1
    }
}

check_sizes() {
    "$size" "$1"/*.o | awk -v out="$1/" '
        NR > 1 { sub(out, "", $6); printf "  %6d %4d %4d  %s\n", $1, $2, $3, $6
                 text += $1
                 if ($2 + $3 > 0) { print "freestanding: " $6 " has writable data" > "/dev/stderr"; bad = 1 } }
        END { printf "  %6d             whole kernel\n", text; exit bad }'
}

# Recursion would be a cycle among the call graph's edges: tsort names one, but takes a call of oneself for
# an isolated node.
check_recursion() {
    cat "$1"/*.ci | sed -n 's/^edge: { sourcename: "\([^"]*\)" targetname: "\([^"]*\)".*/\1 \2/p' |
        sort -u > "$1/calls"
    if awk '$1 == $2 { print "freestanding: recursion: " $1; found = 1 } END { exit !found }' "$1/calls" |
        c++filt >&2; then
        exit 1
    fi
    if ! tsort "$1/calls" > /dev/null 2> "$1/cycle"; then
        echo "freestanding: recursion: $(tr '\n' ' ' < "$1/cycle" | c++filt)" >&2
        exit 1
    fi
    echo "  $(wc -l < "$1/calls") calls, no cycle"
}

for combination in Os-32 O2-16; do
    level=${combination%-*}
    index_bits=${combination#*-}
    folder=$out/$combination
    mkdir "$folder"
    for source in "$root"/kernel/src/*/*.cpp; do
        "${compiler[@]}" "${flags[@]}" "-$level" "-DOSEM_NODE_INDEX_BITS=$index_bits" -c "$source" \
            -o "$folder/$(basename "$(dirname "$source")")-$(basename "$source" .cpp).o"
    done
    echo "$target, -$level, $index_bits-bit indices (bytes: text data bss)"
    check_symbols "$folder"
    check_sizes "$folder"
    [ "${target%-clang}" != "$target" ] || check_recursion "$folder"
done
