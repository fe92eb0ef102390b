#!/usr/bin/env bash
# Measures what the kernel costs on Cortex-M (see measure.py), the example firmware included:
# cross/resources/measure.sh [--check | --write]. Needs the firmware that cross/run.sh cortex-m0 builds.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${OSEM_BUILD_DIR:-$here/../../build}/cross
images=$out/cortex-m0/firmware/port/cortex_m/examples
exec "$here/measure.py" --build "$out/resources" --image "stock_removal=$images/osem_stock_removal" \
    --image "keep_out=$images/osem_keep_out" "$@"
