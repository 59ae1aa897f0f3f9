#!/usr/bin/env bash
# A panel whose port is in use does not start, and names the port. usage: panel_port.sh PROGRAM SYMPLANT PLANT
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
program=$1 symplant=$2 list=$3

panel_opened() { grep -q '^panel: http' "$work/plant.log"; }

"$program" --panel 127.0.0.1:0 --trace "$work/trace.jsonl" >"$work/plant.log" 2>&1 &
plant=$!
wait_until "the plant prints the link of the panel" panel_opened
port=$(sed -nE 's,^panel: http://127\.0\.0\.1:([0-9]+)/.*,\1,p' "$work/plant.log")

refused() { # COMMAND...
  local code=0
  "$@" --panel "127.0.0.1:$port" >"$work/refused.log" 2>&1 || code=$?
  ((code == 3)) || fail "exit code $code instead of 3: $*"
  grep -q "^error: panel: port $port is in use on \`127.0.0.1\`.*: end .*, or give another port" "$work/refused.log" ||
    fail "the message does not name the port and what to do: $*"
}

"$symplant" run "$list" --until 1s --trace "$work/earlier.jsonl" >"$work/earlier.log"
refused "$program" --until 1s
refused "$symplant" run "$list" --until 1s
refused "$symplant" show "$work/earlier.jsonl" "$list"
kill -0 "$plant" || fail "the first plant has ended"
stop_plant
