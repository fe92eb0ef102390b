#!/usr/bin/env bash
# Runs one program on a target: cross/on.sh TARGET PROGRAM ARGUMENTS... For example, after cross/run.sh,
# cross/on.sh cortex-m0 build/cross/cortex-m0/firmware/port/cortex_m/examples/osem_stock_removal
set -euo pipefail
. "$(dirname "$0")/targets.sh"
[ $# -ge 2 ] || {
    echo "usage: cross/on.sh TARGET PROGRAM ARGUMENTS... (targets: $all_targets)" >&2
    exit 1
}
require_target "$1"
[ -f "$2" ] || {
    echo "there is no program $2" >&2
    exit 1
}
run_on "$@"
