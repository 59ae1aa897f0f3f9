#!/usr/bin/env bash
# What the system refuses is reported once with a hint, and the plant still runs. usage: refused.sh SYMPLANT LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
program=$1 list=$2
powerless=()
if ((EUID == 0)); then
  command -v setpriv >/dev/null || skip "setpriv is not installed, and root is refused nothing"
  powerless=(setpriv --inh-caps=-all --bounding-set=-all)
fi

run_with() { # MEMLOCK_BYTES
  "${powerless[@]}" prlimit --memlock="$1" --rtprio=0 "$program" run "$list" --link modbus-tcp-server://127.0.0.1:0 \
    --until 200ms --priority 50 --cpu 100000 --lock-memory --stats "$work/stats.json" >"$work/plant.log" 2>&1 ||
    fail "it ended with exit code $?"
  local option
  for option in priority cpu lock-memory; do
    (($(grep -c "^warning: \`--$option" "$work/plant.log") == 1)) || fail "\`--$option\` is not refused in one line"
  done
  grep -q '"rt":"degraded","refused":\["lock-memory","cpu","priority"\]' "$work/stats.json" || fail "the statistics do not say so"
}

run_with 0
grep -q '0 MB may be locked' "$work/plant.log" || fail "it does not say how much may be locked"
run_with 8388608 # enough at the start, too little for a thread
cat "$work/plant.log"

# A stack that is smaller than what a cycle gets in advance.
(ulimit -s 256 && "$1" run "$2" --clock real --until 50ms >"$work/small") || fail "with a stack of 256 kB: exit code $?"
