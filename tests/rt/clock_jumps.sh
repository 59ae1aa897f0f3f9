#!/usr/bin/env bash
# The time of day jumps by an hour and a day at every read: cycles and plant time are not affected.
# usage: clock_jumps.sh SYMPLANT LIST JUMPING_CLOCK
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
program=$1 list=$2 jumping=$3

days=$(for _ in 1 2 3; do LD_PRELOAD=$jumping date +%F-%H; done; LD_PRELOAD=$jumping awk 'BEGIN { srand(); print srand(); srand(); print srand() }')
(($(sort -u <<<"$days" | wc -l) > 2)) || fail "the clock does not jump: $days"

begin=$(milliseconds)
LD_PRELOAD=$jumping "$program" run "$list" --link modbus-tcp-server://127.0.0.1:0 --until 3s --stats "$work/stats.json" \
  >"$work/plant.log" 2>&1 || fail "it ended with exit code $?"
took=$(($(milliseconds) - begin))
cat "$work/plant.log"
(($(stat_of plant_time) == 3000000000 && $(stat_of cycles) == 300)) || fail "plant time is not 300 cycles"
((took >= 2990)) || fail "it took $took ms: cycles were skipped"
# Holds on any machine that is not overloaded by minutes.
(($(stat_of slipped) < 600000000000 && took < 600000)) || fail "a jump became lost time: $took ms"
