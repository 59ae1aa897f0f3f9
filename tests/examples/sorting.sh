#!/usr/bin/env bash
# The sorting line: its program sorts every part, a late one misses them, and parts pushed by hand are found.
# usage: sorting.sh FOLDER SYMPLANT PLANT [CONTROLLER]
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
folder=$1 tool=$2 binary=$3 controller_program=${4-}

"$tool" check --fail-on warning "$folder/plant.json" >"$work/check.log" || fail "check finds more than notes"

for kind in interpreted compiled; do
  command=("$binary")
  [[ $kind == compiled ]] || command=("$tool" run "$folder/plant.json")
  code=0
  "${command[@]}" --scenario "$folder/by-hand.json" --trace "$work/$kind.jsonl" >"$work/$kind.log" 2>&1 || code=$?
  ((code == 1)) || fail "by hand, $kind: exit code $code"
  grep -qF 'requirement violated: `chute 2 gets low parts only`' "$work/$kind.log" || fail "the wrong chute is not found"
  grep -qF 'CHUTE2 has part 1 (tall) since 1.35 s' "$work/$kind.log" || fail "the part is not named"
  grep -qF '"part":1,"kind":"tall","from":"BELT","to":"CHUTE2"' "$work/$kind.jsonl" || fail "the push is not in the trace"
done
cmp "$work/interpreted.jsonl" "$work/compiled.jsonl" || fail "the traces differ"
[[ -n $controller_program ]] || exit 0

# Runs the program with a DELAY for some seconds; the plant must end with a code.
sort_parts() { # DELAY SECONDS CODE
  local code=0
  "$tool" run "$folder/plant.json" --link modbus-tcp-server://127.0.0.1:0 --trace "$work/trace.jsonl" --stats "$work/stats.json" \
    >"$work/plant.log" 2>&1 &
  plant=$!
  wait_until "the plant says where it listens" listening
  "$controller_program" 127.0.0.1 "$port" "$2" "$1" >"$work/controller.log" 2>&1 || fail "the controller fails"
  kill -TERM "$plant"
  wait "$plant" || code=$?
  plant=""
  ((code == $3)) || fail "delay $1: the plant ends with exit code $code"
}

sort_parts 0 16 0
(($(grep -c '"kind":"low","from":"CHUTE2","to":"out"' "$work/trace.jsonl") >= 1)) || fail "no low part is sorted"
(($(grep -c '"kind":"tall","from":"CHUTE1","to":"out"' "$work/trace.jsonl") >= 1)) || fail "no tall part is sorted"
sort_parts 30 16 1
grep -qF 'requirement violated: `no part falls off the belt`' "$work/plant.log" || fail "the late program is not found"
