#!/usr/bin/env bash
# Proves the kernel on every architecture, most of them under QEMU, and measures what it costs on Cortex-M:
# cross/run.sh [TARGET...]. Ends with a table of targets. Installs what it needs; build trees and logs go to
# $OSEM_BUILD_DIR/cross (default: build/cross).
set -euo pipefail
. "$(dirname "$0")/targets.sh"
. "$root/host_tests/packages.sh"
build=${OSEM_BUILD_DIR:-$root/build}
out=$build/cross
read -ra targets <<< "${*:-$all_targets}"
started=$SECONDS
stage() { printf '\n== %s (%d s)\n' "$1" $((SECONDS - started)); }
mkdir -p "$out"

stage "packages"
install_packages cmake make g++ clang llvm lld libgtest-dev googletest libcgal-dev libgmp-dev libmpfr-dev libcli11-dev \
    libstb-dev libtinyobjloader-dev python3 qemu-user qemu-system-arm gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib \
    g++-arm-linux-gnueabihf g++-aarch64-linux-gnu g++-riscv64-linux-gnu g++-i686-linux-gnu g++-s390x-linux-gnu
. "$root/host_tests/meshes.sh"
OSEM_CGAL_DATA=$(unpack_meshes "$build")
export OSEM_CGAL_DATA

stage "vectors from CGAL"
cmake -S "$root" -B "$build/gcc-release" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release -DOSEM_BUILD_CROSS=ON > /dev/null
cmake --build "$build/gcc-release" --parallel "$(nproc)" --target osem_vectors osem_tool > "$out/vectors.log" 2>&1 || {
    grep -E 'error|Error' -A 5 "$out/vectors.log" | head -n 40 >&2
    exit 1
}
mkdir -p "$out/vectors"
"$build/gcc-release/cross/vectors/osem_vectors" "$out/vectors"

# The example firmware runs natively first: what it prints here it must print on every part, and the tree that
# it cuts is the one that the host tool cuts.
stage "firmware on this machine"
export OSEM_TOOL=$build/gcc-release/port/host/osem
configure x86_64-gcc "$out/firmware" O2 -DOSEM_TOOL="$OSEM_TOOL" > "$out/firmware.log"
cmake --build "$out/firmware" --parallel "$(nproc)" --target osem_stock_removal osem_keep_out >> "$out/firmware.log"
for example in stock_removal keep_out; do
    "$out/firmware/port/cortex_m/examples/osem_$example" | tee "$out/$example.txt"
done
for solid in bracket.poly cutter.off; do
    "$OSEM_TOOL" convert "$root/port/host/samples/$solid" --frame 0,0,0,128 --depth 6 -o "$out/${solid%.*}.osem"
done
"$OSEM_TOOL" difference "$out/bracket.osem" "$out/cutter.osem" -o "$out/cut.osem"
[ "$(grep digest "$out/stock_removal.txt")" = "$("$OSEM_TOOL" info "$out/cut.osem" | grep digest)" ] || {
    echo "the firmware cuts another tree than osem difference" >&2
    exit 1
}

stage "targets: ${targets[*]}"
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I {} "$cross/target.sh" {} "$out"

if [ $# -eq 0 ]; then
    stage "resources"
    "$cross/resources/measure.sh" --check
fi

stage "all passed"
printf '%-13s %-30s %9s %9s %10s %8s  %-16s %6s %9s\n' target "runs on" cases failures "too large" levels digest tests firmware
for target in "${targets[@]}"; do cat "$out/$target/line"; done
