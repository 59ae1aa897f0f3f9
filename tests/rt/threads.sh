#!/usr/bin/env bash
# All threads of a run, for the thread sanitizer: two unsteady links, a trace, findings, a terminal with
# its status line, SIGUSR1. usage: threads.sh SYMPLANT MASTERS
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
. "$(dirname "${BASH_SOURCE[0]}")/large_plant.sh"
command -v script >/dev/null || skip "script, which gives a program a terminal, is not installed"
program=$1 masters=$2
devices=20

write_large_plant "$work" "$devices"
run="$program run $work/plant.json --link PLC1=modbus-tcp-server://127.0.0.1:0 --link PLC2=modbus-tcp-server://127.0.0.1:0 --cycle 2ms
 --trace $work/trace.jsonl --vcd $work/plant.vcd --findings $work/findings.jsonl --junit $work/junit.xml --stats $work/stats.json"
TERM=xterm script -qefc "echo process \$\$; exec ${run//$'\n'/ }" "$work/plant.log" </dev/null >/dev/null 2>&1 &
plant=$!
port_of() { sed -n "s,^link PLC$1=modbus-tcp-server://127\.0\.0\.1:\([0-9]*\).*,\1,p" "$work/plant.log" | sed -n 1p; }
both_listen() { [[ -n $(port_of 1) && -n $(port_of 2) ]]; }
wait_until "both links listen" both_listen
process=$(sed -n 's/^process \([0-9]*\).*/\1/p' "$work/plant.log")

for round in 1 2; do
  "$masters" 2 10 "$devices" "$(port_of 1)" "$(port_of 2)" >"$work/masters.log" &
  controller=$!
  for _ in 1 2 3; do sleep 0.5 && kill -USR1 "$process"; done
  wait "$controller" || fail "the PLCs were cut off"
  controller=""
  lost() { (($(grep -c 'link lost' "$work/findings.jsonl") == 2 * round)); }
  wait_until "both links are lost" lost
done
kill -TERM "$process"
code=0
wait "$plant" || code=$?
plant=""
((code == 0)) || fail "exit code $code"
if grep -q ThreadSanitizer "$work/plant.log"; then fail "a race"; fi # the exit code may be lost
grep -q '"cycles":' "$work/stats.json" || fail "no statistics"
