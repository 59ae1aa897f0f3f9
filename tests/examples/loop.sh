#!/usr/bin/env bash
# Controller and cell as two processes: two cycles, seen by both. usage: loop.sh TIMELINE CONTROLLER PLANT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
timeline=$1 program=$2
shift 2

start_plant "$@"
"$program" "127.0.0.1:$port" --cycles 2 --step-timeout 60000 --connect-timeout 60000 >"$work/controller.log" 2>&1 ||
  fail "the controller ended with exit code $?"
stop_plant

awk -v need=2 -f "$timeline" "$work/trace.jsonl" >"$work/timeline.txt" || fail "the trace has no two cycles"
grep -q '^ *2 cycles completed' <(sed 's/^\([0-9]*\) cycles/ \1 cycles/' "$work/timeline.txt") || fail "not two cycles"
for symbol in AGV_O_P2 AGV_I_P2 MC_O_RUN2 MC_I_RUN2 MC_O_IDLE1 MC_I_IDLE1 AGV_O_P1 AGV_I_P1; do
  (($(count "EXLINE_MB_$symbol\",\"value\":true") >= 2)) || fail "EXLINE_MB_$symbol was not on in both cycles"
done
