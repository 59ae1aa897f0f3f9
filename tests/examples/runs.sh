#!/usr/bin/env bash
# A plant runs in virtual time, and does the same compiled and interpreted. usage: runs.sh PLANT SYMPLANT LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
binary=$1 tool=$2 list=$3

"$binary" --until 5s --clock virtual --trace "$work/compiled.jsonl" >"$work/compiled.log" || fail "the plant does not run"
"$tool" run "$list" --until 5s --clock virtual --trace "$work/interpreted.jsonl" >"$work/interpreted.log" ||
  fail "symplant run does not run it"

grep -q '^can move: [1-9]' "$work/compiled.log" || fail "nothing can move"
grep -q '^ended at 5 s' "$work/compiled.log" || fail "it does not end when asked"
grep -q '"t":0,.*"value":true' "$work/compiled.jsonl" || fail "no device reports its state at the start"
cmp "$work/compiled.jsonl" "$work/interpreted.jsonl" || fail "the traces differ"
[[ $(sed -n 's/.*model //p' "$work/compiled.log") == "$(sed -n 's/.*model //p' "$work/interpreted.log")" ]] ||
  fail "the model's hashes differ"

# The same options, the same verdict, the same files.
echo '{"symplant-scenario":1,"steps":[{"at":"0s","expect":"NO_SUCH.STATE"}]}' >"$work/bad.json"
echo '{"symplant-scenario":1,"steps":[{"at":"1s"}]}' >"$work/good.json"
for scenario in good bad; do
  for kind in binary tool; do
    code=0
    command=("$binary")
    [[ $kind == binary ]] || command=("$tool" run "$list")
    "${command[@]}" --scenario "$work/$scenario.json" --vcd "$work/$kind.vcd" --junit "$work/$kind.xml" \
      --findings "$work/$kind.findings" >"$work/$kind.$scenario.log" 2>&1 || code=$?
    [[ $scenario$code == good0 || $scenario$code == bad2 ]] || fail "$kind: exit code $code with a $scenario scenario"
  done
done
for file in vcd xml; do cmp "$work/binary.$file" "$work/tool.$file" || fail "$file: the files differ"; done
for kind in binary tool; do
  grep -q '<error message=".*bad\.json:1' "$work/$kind.xml" || fail "$kind: the JUnit file lacks the error of the last run"
  [[ ! -e $work/$kind.findings ]] || fail "$kind: the findings of an earlier run are left"
done

# An error of the options or of the plant is in the JUnit file, too; a file that the plant may need stays.
for kind in binary tool; do
  command=("$binary")
  [[ $kind == binary ]] || command=("$tool" run "$list")
  echo old >"$work/$kind.xml"
  "${command[@]}" --junit "$work/$kind.xml" --until never >"$work/usage.log" 2>&1 && fail "an until that is no time is taken"
  grep -q '<error message=".*never' "$work/$kind.xml" || fail "$kind: the JUnit file lacks the wrong option"
done
echo '<testsuites/>' >"$work/plant.xml"
echo '{ "symbols": ["list.csv"' >"$work/plant.json"
echo name >"$work/list.csv"
"$tool" run "$work/plant.json" --junit "$work/plant.xml" --stats "$work/list.csv" >"$work/plant.log" 2>&1 && fail "half a plant runs"
grep -q '<error message=".*plant\.json:' "$work/plant.xml" || fail "the JUnit file lacks the error of the plant"
[[ $(cat "$work/list.csv") == name ]] || fail "an input is replaced"

# The same explanation of a symbol that is on at the start.
symbol=$(sed -n 's/.*"symbol":"\([^"]*\)".*/\1/p' "$work/compiled.jsonl" | sed -n 1p)
"$binary" --until 5s --clock virtual --why "$symbol" | sed -n '/^why: /,$p' >"$work/binary.why"
"$tool" run "$list" --until 5s --clock virtual --why "$symbol" | sed -n '/^why: /,$p' >"$work/tool.why"
grep -q "^why: $symbol has been on since the start, " "$work/binary.why" || fail "$symbol is not explained"
cmp "$work/binary.why" "$work/tool.why" || fail "the explanations differ"

"$binary" --until never >"$work/usage.log" 2>&1 && fail "an until that is no time is taken"
[[ $("$binary" --until never >/dev/null 2>&1; echo $?) == 2 ]] || fail "bad usage is not exit code 2"
