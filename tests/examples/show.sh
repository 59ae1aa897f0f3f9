#!/usr/bin/env bash
# `symplant show` serves a trace, with its plant before or after it; a trace of another plant is rejected.
# usage: show.sh SYMPLANT PLANT OTHER_PLANT
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
symplant=$1 list=$2 other=$3

"$symplant" run "$list" --until 2s --trace "$work/trace.jsonl" >"$work/run.log" 2>&1

shows() { # ARGUMENT...
  : >"$work/plant.log"
  "$symplant" show "$@" --panel 127.0.0.1:0 >"$work/plant.log" 2>&1 &
  plant=$!
  ask_panel plant >"$work/answer"
  stop_plant
  grep -q '"mode":"recording"' "$work/answer" || fail "the panel does not show a recording"
}

shows "$work/trace.jsonl" "$list"
shows "$list" "$work/trace.jsonl"

code=0
"$symplant" show "$work/trace.jsonl" "$other" --panel 127.0.0.1:0 >"$work/other.log" 2>&1 || code=$?
((code == 2)) || fail "a trace of another plant gives exit code $code"
grep -q 'is of another plant' "$work/other.log" || fail "the message does not say that the plant is another one"
