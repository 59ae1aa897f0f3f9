#!/usr/bin/env bash
# The body-shop line: list and description equal the output of their scripts, check reports only notes. Its cycle passes
# and its broken interlock is found, compiled and interpreted. Bodies act on all their sensors. The table of inputs in the
# README is complete. The pictures of both are those of docs/pictures;
# SYMPLANT_UPDATE_GOLDENS=1 regenerates them. usage: body_shop.sh FOLDER SYMPLANT PLANT PICTURES
#        PROGRAM CC INCLUDE
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
folder=$1 tool=$2 binary=$3 pictures=$4 program=$5 cc=$6 include=$7

awk -f "$folder/list.awk" /dev/null | cmp - "$folder/body-shop.csv" || fail "list.awk writes another list"
awk -f "$folder/plant.awk" "$folder/body-shop.csv" | cmp - "$folder/plant.json" || fail "plant.awk writes another description"
awk -f "$folder/program/table.awk" "$folder/body-shop.csv" | cmp - "$folder/program/table.h" || fail "table.awk writes another table"
# An hour with its program in lock step: all forty stations work, every requirement holds.
for plant in "$binary" "$tool run $folder/plant.json"; do
  # shellcheck disable=SC2086 # a command with its arguments
  $plant --program "$program" --until 1h --trace "$work/hour.jsonl" >"$work/hour.log" || fail "the program's hour fails"
  grep -q 'requirements: 290 held, 0 violated' "$work/hour.log" || fail "the program violates a requirement"
  (($(grep -c 'SHUTTLE1_I_FRONT3","value":true' "$work/hour.jsonl") == 4 * 54)) || fail "not 54 strokes of each shuttle"
  (($(grep -c 'ROBOT1_I_DONE3","value":true' "$work/hour.jsonl") > 1000)) || fail "robots do not work"
  (($(grep -o 'BODY_[A-Z0-9]*_ROBOT1_I_DONE3","value":true' "$work/hour.jsonl" | sort -u | wc -l) == 36)) || fail "a station never works"
  ! grep -q 'HORN_O_ON","value":true' "$work/hour.jsonl" || fail "a station reports a fault"
done

# Its suite: the program passes, one that waits too long for a clamp does not.
"$tool" test "$folder/suite" --program "$program" >"$work/suite.log" || fail "the suite fails"
grep -q '^5 cases: 5 passed, 0 failed$' "$work/suite.log" || fail "a case has no reference trace"
cp "$folder/program/table.h" "$work"
sed 's/kMost = INT64_C(60000000000)/kMost = INT64_C(62000000000)/' "$folder/program/line.c" >"$work/late.c"
"$cc" -std=c99 -O1 -shared -fPIC -I"$include" "$work/late.c" -o "$work/late.so"
code=0
"$tool" test "$folder/suite" --program "$work/late.so" >"$work/late.log" || code=$?
((code == 1)) || fail "the suite does not find a program that waits too long"
grep -q '^FAILED stuck-clamp' "$work/late.log" && grep -q 'BODY_UNDER10_LIGHTRED_O_ON` late by 2 s' "$work/late.log" ||
  fail "the red light is not reported as late"

for plant in body-shop.csv plant.json; do
  "$tool" check --fail-on warning "$folder/$plant" >"$work/check.log" || fail "check finds more than notes in $plant"
  grep -q ': 3007 of 3007 I/O names follow' "$work/check.log" || fail "a name of $plant breaks the rule"
done

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

run cycle 0
grep -q '^requirements: [1-9][0-9]* held, 0 violated' "$work/cycle.compiled.log" || fail "a requirement is not looked at"
grep -q '^findings' "$work/cycle.compiled.log" && fail "the cycle has findings"
run clamps-too-early 1
for line in 'requirement violated: `UNDER10: robot 2 works only in closed clamps`' \
  'BODY_UNDER10_CLAMP1 has been in CLOSE->OPEN since 21.9 s, Y0008 (operation OPEN, body-shop.csv:30) has been on since 21.9 s' \
  'BODY_UNDER10_ROBOT2 has been in JOB2 since 3.8 s, Y0016 (operation JOB2, body-shop.csv:61) was on from 3.5 s to 3.9 s' \
  'expectations: 6 held, 0 failed' 'requirements: 289 held, 1 violated'; do
  grep -qF -- "$line" "$work/clamps-too-early.compiled.log" || fail "this is not said: $line"
done

run bodies 0
sensor_lines() { grep -E '_PART[12]_I_SEEN","value":true|_VARIANT_I_CODE","value":[35]' "$work/bodies.compiled.jsonl"; }
sensors=$(sensor_lines | sed 's/.*"symbol":"//; s/".*//' | sort -u | wc -l)
((sensors == 107)) || fail "$sensors of 107 sensors have seen a body"
for number in FRAME40_ROBOT1_I_PROG FRAME40_WELDER1_I_CURRENT FRAME40_WELDER1_I_SPOTS; do
  grep -q "BODY_$number\",\"value\":[1-9]" "$work/bodies.compiled.jsonl" || fail "$number is never set"
done

# The README's table of inputs: the first row has no pattern and counts those that no other row names.
awk -F'|' '/^\| *[0-9]+ \| (`[A-Z?_]+` )?\|/ { gsub(/[ `]/, "", $2); gsub(/[ `]/, "", $3); print $2, $3 }' "$folder/README.md" >"$work/table"
cut -d, -f2 "$folder/body-shop.csv" | grep _I_ >"$work/inputs"
while read -r count pattern; do
  if [[ -z $pattern ]]; then moved=$count; continue; fi
  found=$(grep -cE "_${pattern//\?/.}\$" "$work/inputs") || true
  ((found == count)) || fail "README: $count inputs $pattern, the list has $found"
  moved=$((moved + found))
done <"$work/table"
((moved == $(wc -l <"$work/inputs"))) || fail "README: $moved inputs in the table, the list has $(wc -l <"$work/inputs")"

"$folder/charts.sh" "$tool" "$work" || fail "charts.sh draws nothing"
for pair in cycle:cycle clamps-too-early:broken; do
  picture=$pictures/body-shop-${pair#*:}.svg
  if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then cp "$work/${pair%:*}.svg" "$picture"; fi
  cmp "$work/${pair%:*}.svg" "$picture" || fail "${pair%:*}.svg is another picture than docs/pictures has"
done
