#!/usr/bin/env bash
# The controller is killed midway: the current move ends, then all stops. usage: killed.sh TIMELINE CONTROLLER PLANT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
timeline=$1 program=$2
shift 2

cycles() { awk -f "$timeline" "$work/trace.jsonl" | sed -n 's/^\([0-9]*\) cycles\{0,1\} completed.*/\1/p'; }
at_least_one_cycle() { [[ $(cycles) -ge 1 ]]; }
second_move_is_under_way() { (($(count 'AGV_O_P2","value":true') >= 2)); }
operations() { count '_O_'; }

start_plant "$@"
"$program" "127.0.0.1:$port" --step-timeout 60000 --connect-timeout 60000 >"$work/controller.log" 2>&1 &
controller=$!
wait_until "the first cycle" at_least_one_cycle
wait_until "a further move" second_move_is_under_way
kill -KILL "$controller"
wait "$controller" 2>/dev/null || true
controller=""
cycles_then=$(cycles) operations_then=$(operations)

# A move takes 1 s: in 4 s of plant time a cell that continued would move three times.
long_still() {
  local still
  kill -0 "$plant" || fail "the plant ended by itself"
  still=$(last_change)
  sleep 5
  [[ $(last_change) == "$still" ]]
}
wait_until "the cell stands still" long_still
stop_plant

(($(ended_at) - $(last_change) >= 4000)) || fail "the cell did not stand still for 4 s of plant time"
# Outputs that the controller wrote before it was killed may still arrive: those of one step.
(($(operations) <= operations_then + 2)) || fail "operations changed after the controller was killed"
(($(cycles) <= cycles_then + 1)) || fail "cycles went on after the controller was killed"
