#!/usr/bin/env bash
# Measures Osem beside an exact scanline, OpenVDB and CGAL, and writes report.md, report.json and report.png to
# build/bench (or bench in $OSEM_BUILD_DIR). Installs what it needs. A regular expression as argument picks what
# is run: theme/solid/cells along an axis/method, as in 'convert/armadillo/1024' or 'union/armadillo.elephant/512';
# build/bench/host_tests/bench/osem_bench --benchmark_list_tests lists all. No test: figures depend on the machine,
# and on what else runs there.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath -m "${OSEM_BUILD_DIR:-$root/build}")
. "$root/host_tests/packages.sh"
. "$root/host_tests/meshes.sh"
install_packages cmake make g++ libbenchmark-dev libopenvdb-dev libtbb-dev libboost-iostreams-dev libcgal-dev libgmp-dev \
    libmpfr-dev libcli11-dev libstb-dev libtinyobjloader-dev libgtest-dev python3-matplotlib
OSEM_CGAL_DATA=$(unpack_meshes "$build")
export OSEM_CGAL_DATA

out=$build/bench
cmake -S "$root" -B "$out" -DCMAKE_BUILD_TYPE=Release -DOSEM_BUILD_ORACLE=OFF -DOSEM_BUILD_BENCH=ON \
    -DOSEM_BENCH_OPENVDB=ON -DOSEM_BENCH_CGAL=ON > /dev/null
cmake --build "$out" --parallel "$(nproc)" --target osem_bench > "$out/build.log" 2>&1 || {
    tail -n 40 "$out/build.log" >&2
    exit 1
}
"$out/host_tests/bench/osem_bench" --benchmark_filter="${1:-.}" --benchmark_repetitions=3 --benchmark_min_time=0.1 \
    --benchmark_out="$out/results.json" --benchmark_out_format=json > "$out/run.log"
# The packaged matplotlib is the packaged interpreter's.
/usr/bin/python3 "$root/host_tests/bench/report.py" "$out/results.json" "$out/report"
cat "$out/report.md"
