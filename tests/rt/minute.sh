#!/usr/bin/env bash
# Under load: the guard finds a planted fault of each kind in the cycle, then nothing in a minute at 1 ms, with two
# links whose PLCs exchange 10,000 devices. usage: minute.sh SYMPLANT TEST_RT MASTERS SECONDS
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
. "$(dirname "${BASH_SOURCE[0]}")/large_plant.sh"
program=$1 planted=$2 masters=$3 seconds=$4
devices=5000 cycles=$((seconds * 1000))

(while :; do :; done) & # the load
controller=$!           # ends with the rest, see lib.sh

"$planted" '[planted]' >"$work/planted.log" || fail "a planted fault was not found"
grep -v '^=*$' "$work/planted.log"

write_large_plant "$work" "$devices"
"$program" run "$work/plant.json" --link PLC1=modbus-tcp-server://127.0.0.1:0 --link PLC2=modbus-tcp-server://127.0.0.1:0 \
  --cycle 1ms --lock-memory --rt-check "$cycles" --stats "$work/stats.json" >"$work/plant.log" 2>&1 &
plant=$!
port_of() { sed -n "s,^link PLC$1=modbus-tcp-server://127\.0\.0\.1:\([0-9]*\).*,\1,p" "$work/plant.log" | sed -n 1p; }
both_listen() { [[ -n $(port_of 1) && -n $(port_of 2) ]]; }
wait_until "both links listen" both_listen
"$masters" $((seconds - 1)) 100 "$devices" "$(port_of 1)" "$(port_of 2)" >"$work/masters.log" || fail "the PLCs were cut off"

code=0
wait "$plant" || code=$?
plant=""
cat "$work/masters.log" "$work/plant.log" "$work/stats.json"
if grep -q 'were not checked' "$work/plant.log"; then skip "the guard cannot look at all of it here"; fi
if grep -q '^warning: `--lock-memory` is refused' "$work/plant.log" && [[ $(grep -c '^rt-check: ' "$work/plant.log") == 3 ]] &&
  grep -q '^rt-check: memory: ' "$work/plant.log"; then
  skip "memory cannot be locked here, and the system took some away"
fi
((code == 0)) || fail "the guard found something, exit code $code"
grep -q "^rt-check: $cycles cycles, nothing found" "$work/plant.log" || fail "it was not as many cycles as asked"
((devices < $(sed -n 's/.*, \([0-9]*\) motions.*/\1/p' "$work/masters.log"))) || fail "too little moved"
