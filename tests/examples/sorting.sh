#!/usr/bin/env bash
# The sorting line: its program sorts every part, a late one misses them, and parts pushed by hand are found.
# The run with the PLC is repeated from its trace, and is the same as one with the program in lock step.
# usage: sorting.sh FOLDER SYMPLANT PLANT PROGRAM [CONTROLLER]
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
folder=$1 tool=$2 binary=$3 program=$4 controller_program=${5-}

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
  : >"$work/plant.log" # the run before had another port
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

# From the first request of the PLC until a tall part is sorted: in real time, in lock step, and from the trace.
cp "$folder/symbols.csv" "$work/symbols.csv"
sed 's|^  "symplant": 1,|&\n  "links": [{ "url": "modbus-tcp-server://127.0.0.1:0", "plant-on-loss": "freeze" }],|' "$folder/plant.json" >"$work/plant.json"
cat >"$work/sorted.json" <<'END'
{ "symplant-scenario": 1, "steps": [
  { "wait": "CHUTE2.low", "within": "60s" },
  { "wait": "CHUTE1.tall", "within": "60s" },
  { "wait": "SO_M_CHUTE1_I_PART", "within": "60s" } ] }
END
"$tool" run "$folder/plant.json" --program "$program" --scan 20ms --scenario "$work/sorted.json" --trace "$work/step.jsonl" >"$work/step.log" ||
  fail "no tall part is sorted in lock step"

run_with_plc() {
  : >"$work/plant.log" # the run before had another port
  "$tool" run "$work/plant.json" --clock real --scenario "$work/sorted.json" --trace "$work/real.jsonl" >"$work/plant.log" 2>&1 &
  plant=$!
  wait_until "the plant says where it listens" listening
  "$controller_program" 127.0.0.1 "$port" 30 >"$work/controller.log" 2>&1 & # ends when the plant is gone
  controller=$!
  wait "$plant" || fail "no tall part is sorted with the PLC"
  plant=""
  wait "$controller" || true
  controller=""
}
same=no
for ((try = 0; try < 5; try++)); do # a PLC on a busy machine scans late
  run_with_plc
  "$tool" run "$folder/plant.json" --replay "$work/real.jsonl" --trace "$work/again.jsonl" >"$work/replay.log" || fail "the replay fails"
  (($(wc -l <"$work/real.jsonl") > 30)) || fail "the trace is too short"
  cmp <(tail -n +2 "$work/real.jsonl") <(tail -n +2 "$work/again.jsonl") || fail "the replay differs from the run with the PLC"
  "$tool" compare "$work/step.jsonl" "$work/real.jsonl" --align follow --window 30ms >"$work/compare.log" || continue
  same=yes
  break
done
[[ $same == yes ]] || fail "the run with the PLC differs from the one in lock step by more than 30 ms"
