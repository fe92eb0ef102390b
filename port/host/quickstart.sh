#!/usr/bin/env bash
# Builds the host tool and runs its main job on the bundled part: convert the part and a tool, subtract one
# from the other, measure and draw the result. Usage: port/host/quickstart.sh [output folder]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${OSEM_BUILD_DIR:-$root/build}/quickstart
out=${1:-$root/build/out}
. "$root/host_tests/packages.sh"

install_packages cmake make g++ libcli11-dev libstb-dev libtinyobjloader-dev
echo "building osem in $build"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DOSEM_BUILD_TESTS=OFF > /dev/null
cmake --build "$build" --parallel "$(nproc)"

osem=$build/port/host/osem
samples=$root/port/host/samples
frame=0,0,0,128
mkdir -p "$out"
run() {
    echo
    echo "\$ osem $*"
    "$osem" "$@"
}
cd "$out"
run check "$samples/bracket.poly"
run convert "$samples/bracket.poly" --frame $frame --depth 9 --stats -o bracket.osem
run convert "$samples/cutter.off" --frame $frame --depth 9 -o cutter.osem
run difference bracket.osem cutter.osem -o cut.osem
run info cut.osem
run image bracket.osem -o bracket.png
run image cut.osem -o cut.png
run convert "$samples/bracket.poly" --frame $frame --depth 6 -o coarse.osem
run image coarse.osem --with "$samples/bracket.poly" -o compare.png
run image coarse.osem --with "$samples/bracket.poly" --style wireframe -o wireframe.png
run slice cut.osem --axis z --at 20 -o slice.png
echo
echo "pictures: $out/bracket.png $out/cut.png $out/compare.png"
echo "          $out/wireframe.png $out/slice.png"
