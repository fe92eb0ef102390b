#!/usr/bin/env bash
# Measures what the kernel costs on Cortex-M (see measure.py), the example firmware included:
# cross/resources/measure.sh [--check | --write]. Needs the firmware that cross/run.sh cortex-m0 builds.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${OSEM_BUILD_DIR:-$here/../../build}/cross
images=$out/cortex-m0/firmware/port/cortex_m/examples
[ -f "$images/osem_keep_out" ] || {
    echo "no firmware in $images: run cross/run.sh cortex-m0 first" >&2
    exit 1
}
exec "$here/measure.py" --build "$out/resources" --image "stock_removal=$images/osem_stock_removal" \
    --image "keep_out=$images/osem_keep_out" "$@"
