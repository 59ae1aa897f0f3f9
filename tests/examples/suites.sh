#!/usr/bin/env bash
# Test suites: reference traces, parts, results that are joined, crashes, and what must never pass.
# usage: suites.sh EXAMPLES SYMPLANT CELL_PROGRAM CC INCLUDE
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
examples=$1 symplant=$2 cell=$3 cc=$4 include=$5

changed() { # NAME SED_SCRIPT: the cell's program, changed
  sed "$2" "$examples/excell/program/cell.c" >"$work/$1.c"
  cmp -s "$examples/excell/program/cell.c" "$work/$1.c" && fail "$1: the script changes nothing"
  "$cc" -std=c99 -O1 -shared -fPIC -I"$include" "$work/$1.c" -o "$work/$1.so"
}

# The example's suite passes, also in parts; a changed program does not.
suite=$examples/excell/suite
says 0 "4 cases: 4 passed, 0 failed" "$symplant" test "$suite" --program "$cell" --junit "$work/all.xml" --html "$work/all.html"
grep -q 'tests="4" failures="0" errors="0"' "$work/all.xml" || fail "the JUnit file has not four cases"
changed slow 's/WORK_MS 300/WORK_MS 1500/'
says 1 "late by 1.2 s" "$symplant" test "$suite" --program "$work/slow.so"
# The same results by one process, by four, and by parts.
cp -r "$examples/excell" "$work/excell"
suite=$work/excell/suite
"$symplant" test "$suite" --program "$work/slow.so" --jobs 1 >"$work/one" || true
"$symplant" test "$suite" --program "$work/slow.so" --jobs 4 >"$work/four" || true
cmp "$work/one" "$work/four" || fail "the number of processes shows"
for part in 1 2 3; do
  "$symplant" test "$suite" --program "$work/slow.so" --shard $part/3 -o "$work/part$part.jsonl" >"$work/part$part" || true
done
(($(cat "$work"/part? | grep -c '^FAILED') == 4)) || fail "the parts are not the whole suite"
grep -q '^FAILED blind-sensor' "$work/part1" && grep -q '^FAILED sluggish' "$work/part1" || fail "part 1 of 3 has not cases 1 and 4"
says 1 "4 cases: 0 passed, 4 failed" "$symplant" test --merge "$work"/part?.jsonl --junit "$work/merged.xml"
cmp <(grep '^FAILED' "$work/one") <(grep '^FAILED' "$work/out") || fail "joined results differ"
says 1 "1 case without a result (of the suite: number 2)" "$symplant" test --merge "$work/part1.jsonl" "$work/part3.jsonl" --junit "$work/gap.xml"
grep -q 'tests="4" failures="3" errors="1"' "$work/gap.xml" || fail "the JUnit file does not show that a result is missing"
says 2 "is not a part such as 1/8" "$symplant" test "$suite" --shard 0/3
says 2 "is not a part such as 1/8" "$symplant" test "$suite" --shard 4/3

# --update accepts a change, and shows it; never a case that fails.
says 0 "4 reference traces written" "$symplant" test "$suite" --program "$work/slow.so" --update
grep -q "late by 1.2 s" "$work/out" || fail "--update does not show what changes"
says 0 "4 cases: 4 passed" "$symplant" test "$suite" --program "$work/slow.so"
says 0 "4 cases: 4 passed, 0 failed" "$symplant" test "$suite" --program "$work/slow.so" --update
grep -q "written" "$work/out" && fail "--update writes what is there already"
mkdir "$work/strict"
cat >"$work/strict/plant.json" <<'END'
{ "symplant": 1, "symbols": ["../excell/excell.csv"],
  "requirements": [ { "name": "the machine waits", "never": "EXLINE_MB_MC.RUN2" } ] }
END
echo '{ "symplant-suite": 1, "plant": "plant.json" }' >"$work/strict/suite.json"
echo '{ "symplant-scenario": 1, "steps": [ { "at": "10s" } ] }' >"$work/strict/case.json"
says 1 "requirement violated: \`the machine waits\`" "$symplant" test "$work/strict" --program "$cell" --update
[[ ! -e $work/strict/case.reference.jsonl ]] || fail "--update has accepted a violated requirement"
echo '{ "symplant-scenario": 1, "steps": [ { "at": "1s", "expect": "EXLINE_MB_MC.RUN2" } ] }' >"$work/strict/case.json"
says 1 'error: expected `EXLINE_MB_MC.RUN2` at 1 s' "$symplant" test "$work/strict" --program "$cell" --update
[[ ! -e $work/strict/case.reference.jsonl ]] || fail "--update has accepted a failed expectation"

# What is no result: limits, crashes, programs that do not return, bad cases. The other cases go on.
echo '{ "symplant-suite": 1, "plant": "../excell/excell.csv", "limit": "20s" }' >"$work/strict/suite.json"
echo '{ "symplant-scenario": 1, "steps": [ { "at": "30s" } ] }' >"$work/strict/case.json"
says 1 "the scenario is not over after its limit of 20 s" "$symplant" test "$work/strict" --program "$cell"
changed crash 's/^  switch (cell->phase) {/  if (now_ns == 8120000000) *(volatile int *)0 = 1;\n&/'
echo '{ "symplant-scenario": 1, "steps": [ { "at": "5s" } ] }' >"$work/strict/early.json"
says 1 "program \`cell\` ended by SIGSEGV in scan 812 (8.12 s)" "$symplant" test "$work/strict" --program "$work/crash.so" --jobs 1
grep -q '^passed early' "$work/out" || fail "a crash ends the other cases"
changed hangs 's/^  switch (cell->phase) {/  while (now_ns == 8120000000) {}\n&/'
# On a terminal a line shows how many cases are done.
TERM=xterm says 1 "program \`cell\` does not return in scan 812 (8.12 s) after 10 s" \
  script -qec "$symplant test $work/strict --program $work/hangs.so --jobs 1" /dev/null </dev/null
grep -q '1 of 2 cases \.\.\.' "$work/out" || fail "a terminal does not show how many cases are done"
echo '{' >"$work/strict/bad.json"
says 1 "ERROR  bad" "$symplant" test "$work/strict" --program "$cell"
says 2 "cannot read" "$symplant" test "$work"
says 2 "give the folder of a suite" "$symplant" test
says 2 "does not exist" "$symplant" test --merge "$work/nothing.jsonl"

# Cases that are proposed: the same each time, none that is there already, and all of them run.
says 0 "18 of 18 possible cases written" "$symplant" test --new "$suite" --base cycles --program "$cell"
grep -q '^new    restart-in-phase-2: ' "$work/out" || fail "no restart in phase 2 is proposed"
grep -q '"restart":true' "$suite/restart-in-phase-2.json" || fail "the proposed case does not restart the program"
says 0 "0 of 0 possible cases written" "$symplant" test --new "$suite" --base cycles --program "$cell"
cp -r "$examples/excell/suite" "$work/excell/few"
says 0 "3 of 18 possible cases written" "$symplant" test --new "$work/excell/few" --base cycles --program "$cell" --most 3
says 0 "18 reference traces written" "$symplant" test "$suite" --program "$work/slow.so" --update
says 0 "22 cases: 22 passed" "$symplant" test "$suite" --program "$work/slow.so"
says 2 "the suite has no case \`none\`" "$symplant" test --new "$suite" --base none --program "$cell"
says 2 "requires --base" "$symplant" test --new "$suite"

# Fast and slow plants are other plants, with their own reference traces.
says 0 "4 without a reference trace" "$symplant" test "$examples/excell/suite" --program "$cell" --plants normal,slow
cp -r "$examples/excell/suite" "$work/excell/speeds"
says 0 "12 cases: 12 passed" "$symplant" test "$work/excell/speeds" --program "$cell" --plants normal,fast,slow --update
for pair in cycles:1020000000 cycles.fast:220000000 cycles.slow:3020000000; do # the vehicle needs 1 s, 0.2 s, 3 s
  grep -m 1 '"EXLINE_MB_MC_O_RUN2","value":true' "$work/excell/speeds/${pair%:*}.reference.jsonl" | grep "\"t\":${pair#*:}," >/dev/null ||
    fail "${pair%:*}: the machine does not start at ${pair#*:} ns"
done
says 2 "normal, fast, slow" "$symplant" test "$suite" --plants quick

# A run that cannot begin leaves no earlier results, and no result replaces an input.
cp "$work/all.xml" "$work/old.xml"
mkdir "$work/broken"
echo '{ "symplant-suite": 1, "plant": "nothing.csv" }' >"$work/broken/suite.json"
echo '{ "symplant-scenario": 1, "steps": [ { "at": "1s" } ] }' >"$work/broken/case.json"
says 2 "nothing.csv" "$symplant" test "$work/broken" --junit "$work/old.xml"
grep -q "the run has not ended" "$work/old.xml" || fail "a run that cannot begin leaves earlier results"
says 2 "case.json" "$symplant" test "$work/broken" --junit "$work/broken/case.json"
grep -q symplant-scenario "$work/broken/case.json" || fail "a result replaces a case"

# One case; names, references and patterns that cannot be meant; what a trace is of; a program that does nothing.
cp -r "$examples/excell/suite" "$work/excell/names"
suite=$work/excell/names
says 0 "1 case: 1 passed" "$symplant" test "$suite" --case cycles --program "$cell"
says 2 "the suite has no case \`cycle\`; did you mean \`cycles\`?" "$symplant" test "$suite" --case cycle --program "$cell"
changed idle 's/^  switch (cell->phase) {/  return 0;\n&/'
says 1 "\`EXLINE_MB_AGV_O_P2\` missing: on" "$symplant" test "$suite" --case cycles --program "$work/idle.so"
grep -q "ACTUAL ends" "$work/out" && fail "a run that went to its end is said to end early"
says 1 "1 error" "$symplant" test "$suite" --case cycles --program "$work/nothing.so"
grep -q "without a reference trace" "$work/out" && fail "a case without a result counts as one without a reference trace"
mv "$suite/cycles.json" "$suite/cycles.slow.json"
says 2 "must not end with \`.slow\`" "$symplant" test "$suite" --program "$cell"
mv "$suite/cycles.slow.json" "$suite/rounds.json"
says 0 "cycles.reference.jsonl\` is the reference trace of no case" "$symplant" test "$suite" --program "$cell"
echo '{ "steps": [ { "at": "1s" } ] }' >"$suite/forgotten.json"
says 0 "forgotten.json\` has \`steps\`, but no \`symplant-scenario\`" "$symplant" test "$suite" --program "$cell"
sed 's/"plant":"excell"/"plant":"sorting"/' "$suite/cycles.reference.jsonl" >"$suite/rounds.reference.jsonl"
says 1 "is of the plant \`sorting\`, not \`excell\`" "$symplant" test "$suite" --case rounds --program "$cell"
says 0 "1 reference trace written" "$symplant" test "$suite" --case rounds --program "$cell" --update
says 0 "1 case: 1 passed, 0 failed" "$symplant" test "$suite" --case rounds --program "$cell"
sed -i 's/"end":[0-9]*/"end":"late"/' "$suite/rounds.reference.jsonl"
says 1 "the key \`end\` is not a time in ns" "$symplant" test "$suite" --case rounds --program "$cell"
: >"$suite/rounds.reference.jsonl"
says 1 "\`--update\` writes it again" "$symplant" test "$suite" --case rounds --program "$cell"
says 0 "1 reference trace written" "$symplant" test "$suite" --case rounds --program "$cell" --update
says 0 "1 case: 1 passed, 0 failed" "$symplant" test "$suite" --case rounds --program "$cell"
sed -i 's/"align"/"only": ["*_NOTHING"], &/' "$suite/suite.json"
says 1 "\`only\` of suite.json matches no symbol" "$symplant" test "$suite" --case rounds --program "$cell"
sed -i 's/"follow"/"folow"/; s/"only": [^,]*, //' "$suite/suite.json"
says 1 "did you mean \`follow\`?" "$symplant" test "$suite" --case rounds --program "$cell"
says 2 "excludes" "$symplant" test --new "$suite" --base rounds --shard 1/2
says 2 "names a plant twice" "$symplant" test "$suite" --plants fast,fast

# Ctrl-C leaves the results that are there.
echo '{ "symplant-suite": 1, "plant": "../excell/excell.csv", "limit": "100000h" }' >"$work/strict/suite.json"
rm "$work/strict/bad.json"
echo '{ "symplant-scenario": 1, "steps": [ { "at": "90000h" } ] }' >"$work/strict/long.json"
"$symplant" test "$work/strict" --program "$cell" --jobs 1 -o "$work/cut.jsonl" >"$work/cut" 2>&1 &
plant=$!
wait_until "the first cases have results" grep -q early "$work/cut"
kill -INT "$plant"
code=0
wait "$plant" || code=$?
plant=""
((code == 1)) || fail "exit code $code after Ctrl-C"
grep -q "without a result" "$work/cut" || fail "the missing case is not counted"
says 1 "1 without a result" "$symplant" test --merge "$work/cut.jsonl"
