#!/usr/bin/env bash
# The training line: check finds no more than notes, its shift passes and its jammed sensor is found, compiled and
# interpreted. usage: training_line.sh FOLDER SYMPLANT PLANT
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
folder=$1 tool=$2 binary=$3

(($(wc -l <"$folder/plant.json") < 80)) || fail "plant.json has 80 lines or more"
"$tool" check --fail-on warning "$folder/plant.json" >"$work/check.log" || fail "check finds more than notes"

run() { # SCENARIO EXIT_CODE: with both plants, which must give the same output
  local kind code command
  for kind in interpreted compiled; do
    command=("$binary")
    [[ $kind == compiled ]] || command=("$tool" run "$folder/plant.json")
    code=0
    "${command[@]}" --scenario "$folder/$1.json" --trace "$work/$1.$kind.jsonl" >"$work/$1.$kind.log" 2>&1 || code=$?
    ((code == $2)) || fail "$1, $kind: exit code $code"
  done
  cmp "$work/$1.interpreted.jsonl" "$work/$1.compiled.jsonl" || fail "$1: the traces differ"
}

run shift 0
grep -q '^expectations: 54 held, 0 failed' "$work/shift.compiled.log" || fail "the shift expects something else"
grep -q '^requirements: 12 held, 0 violated' "$work/shift.compiled.log" || fail "a requirement is not looked at"
grep -q '^findings' "$work/shift.compiled.log" && fail "the shift has findings"
run jammed 1
grep -qF 'FT_C2_PART_I_END has been off (bit 1) since 5.6 s, forced in line 6' "$work/jammed.compiled.log" || fail "the force is not named"
