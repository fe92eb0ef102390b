#!/usr/bin/env bash
# Proves the kernel on every architecture, most of them under QEMU, and measures what it costs on Cortex-M:
# cross/run.sh [TARGET...]. Ends with a table of targets. Installs what it needs; build trees and logs go to
# $OSEM_BUILD_DIR/cross (default: build/cross).
set -euo pipefail
. "$(dirname "$0")/targets.sh"
. "$root/host_tests/packages.sh"
. "$root/host_tests/meshes.sh"
build=$(realpath -m "${OSEM_BUILD_DIR:-$root/build}")
out=$build/cross
read -ra targets <<< "${*:-$all_targets}"
for target in "${targets[@]}"; do require_target "$target"; done
started=$SECONDS
stage() { printf '\n== %s (%d s)\n' "$1" $((SECONDS - started)); }
mkdir -p "$out"

# build_host FOLDER PROGRAM...
build_host() {
    local folder=$1
    shift
    cmake --build "$folder" --parallel "$(nproc)" --target "$@" > "$out/host.log" 2>&1 || {
        { grep -E 'error|Error' -A 5 "$out/host.log" || tail -n 20 "$out/host.log"; } | sed -n '1,40p' >&2
        echo "cannot build $*" >&2
        exit 1
    }
}

stage "packages"
install_packages cmake make g++ clang llvm lld libgtest-dev googletest libcgal-dev libgmp-dev libmpfr-dev libcli11-dev \
    libstb-dev libtinyobjloader-dev python3 qemu-user qemu-system-arm gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib \
    g++-arm-linux-gnueabihf g++-aarch64-linux-gnu g++-riscv64-linux-gnu g++-i686-linux-gnu g++-s390x-linux-gnu
OSEM_CGAL_DATA=$(unpack_meshes "$build")
export OSEM_CGAL_DATA

stage "the oracles' vectors"
cmake -S "$root" -B "$build/gcc-release" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release -DOSEM_BUILD_CROSS=ON > /dev/null
build_host "$build/gcc-release" osem_vectors osem_tool
rm -rf "$out/vectors"
mkdir -p "$out/vectors"
"$build/gcc-release/cross/vectors/osem_vectors" "$out/vectors" | tee "$out/vectors/written.txt"

# The example firmware runs natively first, and the tree that it cuts is the one that the host tool cuts.
stage "firmware on this machine"
export OSEM_TOOL=$build/gcc-release/port/host/osem
configure x86_64-gcc "$out/firmware" O2 -DOSEM_TOOL="$OSEM_TOOL" > "$out/firmware.log"
build_host "$out/firmware" osem_stock_removal osem_keep_out
for example in stock_removal keep_out; do
    "$out/firmware/port/cortex_m/examples/osem_$example" | tee "$out/$example.txt"
    diff -u --label pinned --label "on this machine" "$root/port/cortex_m/examples/$example.txt" "$out/$example.txt" >&2
done
for solid in bracket.poly cutter.off; do
    "$OSEM_TOOL" convert "$root/port/host/samples/$solid" --frame 0,0,0,128 --depth 6 -o "$out/${solid%.*}.osem"
done
"$OSEM_TOOL" difference "$out/bracket.osem" "$out/cutter.osem" -o "$out/cut.osem"
digest=$("$OSEM_TOOL" info "$out/cut.osem" | grep '^digest ')
grep -q -x "$digest" "$out/stock_removal.txt" || {
    echo "the firmware cuts another tree than osem difference, which has the $digest" >&2
    exit 1
}

stage "targets: ${targets[*]}"
rm -f "$out"/*/line
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I {} "$cross/target.sh" {} "$out" || {
    for target in "${targets[@]}"; do [ -f "$out/$target/line" ] || echo "failed: $target (logs in $out/$target)" >&2; done
    exit 1
}

if [ $# -eq 0 ]; then
    stage "resources"
    OSEM_BUILD_DIR=$build "$cross/resources/measure.sh" --check
fi

stage "all passed"
printf '%-13s %-30s %9s %9s %10s %8s  %-16s %6s %9s\n' target "runs on" cases failures "too large" levels digest tests firmware
for target in "${targets[@]}"; do cat "$out/$target/line"; done
echo "cases: replayed and compared with the oracles' answers; too large: left out for want of memory; levels: of -O0, -O2, -Os"
echo "and link-time optimisation, those with the pinned digests; tests: GoogleTest; firmware: the examples print the same"
