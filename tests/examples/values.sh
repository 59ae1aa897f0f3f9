#!/usr/bin/env bash
# An example of values and signals: check finds no more than notes, its scenarios pass with its program, and a fault of the
# program is found, compiled and interpreted. usage: values.sh EXAMPLE FOLDER SYMPLANT PLANT CC INCLUDE [PROGRAM]
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
example=$1 folder=$2 tool=$3 binary=$4 cc=$5 include=$6 program=${7-}

# run CODE TEXT SCENARIO OPTION...: with both plants, which end with the code, print the text and give the same trace.
run() {
  local wanted=$1 text=$2 scenario=$3 kind code command
  shift 3
  for kind in interpreted compiled; do
    command=("$binary")
    [[ $kind == compiled ]] || command=("$tool" run "$folder/plant.json")
    code=0
    "${command[@]}" "$@" --scenario "$folder/$scenario.json" --trace "$work/$kind.jsonl" >"$work/$kind.log" 2>&1 || code=$?
    ((code == wanted)) || fail "$scenario $*, $kind: exit code $code"
    grep -qF -- "$text" "$work/$kind.log" || fail "$scenario $*, $kind: no \`$text\`"
    ((wanted != 0)) || ! grep -q '^findings' "$work/$kind.log" || fail "$scenario $*, $kind: there are findings"
  done
  cmp "$work/interpreted.jsonl" "$work/compiled.jsonl" || fail "$scenario $*: the traces differ"
}
# changed MACRO: the program with this macro 0, a mistake that the example describes.
changed() {
  grep -q "ifndef $1\$" "$folder"/program/*.c || fail "the program has no macro $1"
  "$cc" -std=c99 -O2 -shared -fPIC -I"$include" "-D$1=0" "$folder"/program/*.c -o "$work/$1.so"
}

"$tool" check --fail-on warning "$folder/plant.json" >"$work/check.log" || fail "check finds more than notes"
if [[ $example != harbour-crane ]]; then
  lines=$(awk '/^  "(values|signals)": \{$/ { on = 1; next } /^  \}/ { on = 0 } on' "$folder/plant.json" | wc -l)
  ((lines >= 2 && lines <= 15)) || fail "values and signals have $lines lines"
fi

case $example in
  tank)
    run 0 "requirements: 3 held, 0 violated" control --program "$program"
    run 0 "requirements: 3 held, 0 violated" stuck-sensor --program "$program"
    changed USE_HIGH_SWITCH
    run 1 'requirement violated: `the tank does not overflow`' stuck-sensor --program "$work/USE_HIGH_SWITCH.so"
    ;;
  oven)
    run 0 "expectations: 9 held, 0 failed" heat-up --program "$program"
    run 0 "requirements: 3 held, 0 violated" sensor-drifts --program "$program"
    changed USE_LIMITER
    run 1 'requirement violated: `the oven stays below 192 degC`' sensor-drifts --program "$work/USE_LIMITER.so"
    changed ANTI_WINDUP
    run 1 'waited 540 s for `HEAT_O1_READY_O_ON`' heat-up --program "$work/ANTI_WINDUP.so"
    ;;
  drive)
    run 0 "expectations: 8 held, 0 failed" moves --program "$program"
    changed USE_OVERFLOW
    run 1 '12.26 s: requirement violated: `the carriage does not hit the buffers`' moves --program "$work/USE_OVERFLOW.so"
    run 1 'requirement violated: `the carriage does not hit the buffers`' limit-switch
    ;;
  dosing)
    run 0 "expectations: 7 held, 0 failed" batches
    run 1 'requirement violated: `L1_DOSE_SCALE1: a batch is at most 0.1 kg too heavy`' gate-too-late
    ;;
  harbour-crane)
    for scenario in six heavy storm shift; do
      run 0 "requirements: 9 held, 0 violated" suite/$scenario --program "$program"
    done
    "$tool" test "$folder/suite" --program "$program" >"$work/suite.log" || fail "the suite fails"
    grep -q '^4 cases: 4 passed, 0 failed$' "$work/suite.log" || fail "a case has no reference trace"
    changed USE_LIMITER
    run 1 'requirement violated: `the rope carries at most 110 % of the rated load`' suite/heavy --program "$work/USE_LIMITER.so"
    changed USE_RAMPS
    run 1 'requirement violated: `the hoist accelerates with at most 0.8 m/s2`' suite/six --program "$work/USE_RAMPS.so"
    code=0
    "$tool" test "$folder/suite" --program "$work/USE_LIMITER.so" >"$work/suite.log" || code=$?
    ((code == 1)) && grep -q '^4 cases: 3 passed, 1 failed$' "$work/suite.log" || fail "the suite does not find the missing limiter"
    ;;
  *) fail "unknown example" ;;
esac
