#!/usr/bin/env bash
# PLC programs in lock step: the examples run, every run is the same, and each message about a program that cannot run or
# fails. usage: programs.sh EXAMPLES SYMPLANT CELL_PLANT CELL_PROGRAM PRESS_PROGRAM ROBOT_PROGRAM CC INCLUDE REPEATS
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
examples=$1 symplant=$2 cell_plant=$3 cell=$4 press=$5 robot=$6 cc=$7 include=$8 repeats=$9
list=$examples/excell/excell.csv

run_cell() { # PROGRAM OPTION...
  local program=$1
  shift
  "$symplant" run "$list" --program "$program" "$@"
}
changed() { # NAME SED_SCRIPT: the cell's program, changed
  sed "$2" "$examples/excell/program/cell.c" >"$work/$1.c"
  cmp -s "$examples/excell/program/cell.c" "$work/$1.c" && fail "$1: the script changes nothing"
  "$cc" -std=c99 -O1 -shared -fPIC -I"$include" "$work/$1.c" -o "$work/$1.so"
}

# The same trace each time, interpreted and compiled; the plant runs its cycles.
run_cell "$cell" --until 60s --trace "$work/first.jsonl" >/dev/null
(($(grep -c 'MC_I_RUN2","value":true' "$work/first.jsonl") == 18)) || fail "not 18 cycles of 3.34 s in 60 s"
for ((i = 0; i < repeats; i++)); do
  run_cell "$cell" --until 60s --trace "$work/again.jsonl" >/dev/null
  cmp "$work/first.jsonl" "$work/again.jsonl" || fail "run $i differs"
done
"$cell_plant" --program "$cell" --until 60s --trace "$work/again.jsonl" >/dev/null
cmp "$work/first.jsonl" "$work/again.jsonl" || fail "the compiled plant differs"
# Real time has the same changes at the same plant times.
run_cell "$cell" --clock real --until 2s --trace "$work/again.jsonl" >/dev/null
cmp <(awk -F'[:,]' 'NR > 1 && $2 <= 2000000000' "$work/first.jsonl") <(tail -n +2 "$work/again.jsonl") || fail "real time differs"

# Two controllers: the order of the command line does not show.
two=$examples/two-plcs/plant.json
says 0 "requirements: 1 held, 0 violated" "$symplant" run "$two" --program PRESS="$press" --program ROBOT="$robot" --until 600s \
  --trace "$work/first.jsonl"
says 0 "" "$symplant" run "$two" --program ROBOT="$robot" --program PRESS="$press" --until 600s --trace "$work/again.jsonl"
cmp "$work/first.jsonl" "$work/again.jsonl" || fail "the order of programs shows"
"$cc" -std=c99 -shared -fPIC -I"$include" -DFIRST_LOAD_MS=9000 "$examples/two-plcs/program/robot.c" -o "$work/late.so"
says 1 "violated" "$symplant" run "$two" --program PRESS="$press" --program ROBOT="$work/late.so" --until 60s
says 2 "does not name its controller" "$symplant" run "$two" --program "$press"
says 2 "has two programs" "$symplant" run "$two" --program PRESS="$press" --program PRESS="$press"
# One library twice: each has its own variables.
cat >"$work/count.c" <<'END'
#include <symplant/program.h>
static const struct symplant_variable none;
static int scans;
static void *create(void *const *cells) { return (void)cells, &scans; }
static int scan(void *instance, int64_t now_ns) { return ++*(int *)instance, scans == now_ns / 10000000 + 1 ? 0 : scans; }
static void destroy(void *instance) { (void)instance; }
const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {1, sizeof program, "count", 10000000, &none, 0, create, scan, destroy};
  return &program;
}
END
"$cc" -std=c99 -shared -fPIC -I"$include" "$work/count.c" -o "$work/count.so"
says 0 "" "$symplant" run "$two" --program PRESS="$work/count.so" --program ROBOT="$work/count.so" --until 1s

# What cannot run.
says 2 "cannot read the program" run_cell "$work/nothing.so"
echo text >"$work/text.so"
says 2 "cannot open the program" run_cell "$work/text.so"
echo 'int other(void) { return 1; }' >"$work/other.c"
"$cc" -shared -fPIC "$work/other.c" -o "$work/other.so"
says 2 "does not export symplant_program_v1()" run_cell "$work/other.so"
changed version 's/\.version = 1/.version = 2/'
says 2 "the version of its program is 2" run_cell "$work/version.so"
changed period 's/\.name = "cell",/.name = "cell", .period_ns = 20000000,/'
says 0 "a scan every 0.02 s" run_cell "$work/period.so" --until 1s
says 2 "has a period of 0.02 s, not 0.01 s" run_cell "$work/period.so" --scan 10ms --until 1s
says 2 "is not from 1 ns to its period" run_cell "$cell" --scan-delay 11ms --until 1s
says 0 "a scan every 0.05 s, its outputs after 0.001 s" run_cell "$cell" --scan 50ms --scan-delay 1ms --until 1s
changed name 's/AGV_I_P2"/AGV_I_P3"/'
says 2 "symbol \`EXLINE_MB_AGV_I_P3\` not found; did you mean" run_cell "$work/name.so"
changed width 's/MC_I_RUN2", .bits = 1/MC_I_RUN2", .bits = 16/'
says 2 "has 16 bits" run_cell "$work/width.so"
changed direction 's/"EXLINE_MB_MC_I_IDLE1"/"EXLINE_MB_MC_O_IDLE1"/'
says 2 "is an operation: a program writes operations" run_cell "$work/direction.so"
changed twice 's/"EXLINE_MB_MC_O_RUN2"/"EXLINE_MB_MC_O_IDLE1"/'
says 2 "both write" run_cell "$work/twice.so"
changed address 's/\.symbol = "EXLINE_MB_MC_O_RUN2"/.address = "%QX5"/'
says 2 "no operation has the address \`%QX5\`; the nearest is \`EXLINE_MB_MC_O_RUN2\` at \`Y0004\`" run_cell "$work/address.so"
changed by_address 's/\.symbol = "EXLINE_MB_MC_O_RUN2"/.address = "%QX0.4"/'
says 0 "reads 4 events and writes 4 operations" run_cell "$work/by_address.so" --until 1s
says 0 "EXLINE_MB_MC_O_RUN2   Y0004" "$symplant" program --check "$work/by_address.so" "$list"
says 1 "symbol \`EXLINE_MB_AGV_I_P3\` not found" "$symplant" program --check "$work/name.so" "$list"
says 2 "cannot read the program" "$symplant" program --check "$work/nothing.so" "$list"
says 2 "the plant has no program" "$symplant" program "$list"
for option in "--save $work/state" "--resume $work/state" "--rt-check 10"; do
  # shellcheck disable=SC2086 # two words
  says 2 "is not possible with a program" run_cell "$cell" $option
done
says 2 "has the program" run_cell "$cell" --link modbus-tcp-server://127.0.0.1:0

# What fails: the end of the run, its time and its scan.
changed crash 's/^  switch (cell->phase) {/  if (now_ns == 8120000000) *(volatile int *)0 = 1;\n&/'
says 3 "error: program \`cell\` ended by SIGSEGV in scan 812 (8.12 s)" run_cell "$work/crash.so" --until 60s
changed recursion 's/^static int scan(.*/static int deep(volatile char *from) { volatile char here[1000]; here[0] = *from; return deep(here) + here[0]; }\n&\n  if (now_ns == 10000000) { char c = 0; return deep(\&c); }/'
says 3 "ended by SIGSEGV in scan 1 (0.01 s)" run_cell "$work/recursion.so" --until 60s
changed abort 's/^  switch (cell->phase) {/  if (now_ns > 0) abort();\n&/'
says 3 "ended by SIGABRT in scan 1 (0.01 s)" run_cell "$work/abort.so" --until 60s
changed fails 's/^  switch (cell->phase) {/  if (now_ns == 8120000000) return 7;\n&/'
says 3 "error: program \`cell\` failed with 7 in scan 812 (8.12 s)" run_cell "$work/fails.so" --until 60s --junit "$work/junit.xml"
grep -q "failed with 7 in scan 812" "$work/junit.xml" || fail "the failure is not in the JUnit file"
says 3 "failed with 7 in scan 812" run_cell "$work/fails.so" --until 60s --clock real --cycle 100ms
changed start 's/^  struct cell \*cell = calloc.*/&\n  return NULL;/'
says 3 "program \`cell\` did not start (0 s)" run_cell "$work/start.so" --until 60s

# A program's outputs in scenarios and explanations.
cat >"$work/set.json" <<'END'
{ "symplant-scenario": 1, "steps": [ { "at": "1s", "set": { "EXLINE_MB_AGV_O_P2": true } } ] }
END
says 2 "use \`force\` instead" run_cell "$cell" --scenario "$work/set.json"
cat >"$work/restart.json" <<'END'
{ "symplant-scenario": 1, "steps": [
  { "at": "500ms", "expect": "EXLINE_MB_AGV_O_P2" },
  { "at": "500ms", "restart": true, "expect": "not EXLINE_MB_AGV_O_P2" },
  { "at": "1.6s", "state": { "EXLINE_MB_AGV": "P1" } },
  { "at": "1.61s", "expect": "EXLINE_MB_AGV_O_P2" } ] }
END
says 0 "3 held, 0 failed" run_cell "$cell" --scenario "$work/restart.json"
says 2 "program \`cell\` writes \`EXLINE_MB_AGV_O_P2\`; use" run_cell "$cell" --scenario "$work/set.json"
says 0 "\`--scan\` has no effect without a program" "$symplant" run "$list" --scan 20ms --until 1s
says 2 "no program of this controller runs" "$symplant" run "$list" --scenario "$work/restart.json"
says 0 "written by program \`cell\` in scan 1001 (10.01 s)" run_cell "$cell" --until 12s --why EXLINE_MB_AGV

# Programs of plant.json: found next to it, with their own settings; a program of the command line replaces them.
cp "$list" "$work/excell.csv" && cp "$cell" "$work/own.so"
cat >"$work/plant.json" <<'END'
{ "symplant": 1, "symbols": ["excell.csv"],
  "programs": [ { "file": "own.so", "period": "50ms", "delay": "20ms", "ignore": ["EXLINE_MB_AGV_I_P3"] } ] }
END
says 0 "a scan every 0.05 s, its outputs after 0.02 s" "$symplant" run "$work/plant.json" --until 1s
says 0 "name.so): reads 3 events" "$symplant" run "$work/plant.json" --program "$work/name.so" --until 1s
says 0 "own.so" "$symplant" program "$work/plant.json"
cat >"$work/width.json" <<'END'
{ "symplant": 1, "symbols": ["excell.csv"], "programs": [ { "file": "width.so", "ignore": ["*_I_RUN2"] } ],
  "malfunctions": [ { "name": "gone", "lose": true } ] }
END
says 0 "reads 3 events" "$symplant" run "$work/width.json" --until 1s
grep -q "no effect" "$work/out" && fail "a program's controller cannot be lost in virtual time"
# A program sees at its scans what changes within a cycle.
says 0 "ended at 1 s" run_cell "$cell" --clock real --cycle 500ms --until 1s
grep -q "too short" "$work/out" "$work/err" && fail "an event that a scan has read is too short"
sed -i 's/"file": "own.so"/"file": "own.so", "controller": "PLC1"/' "$work/plant.json"
says 2 "controller \`PLC1\` not found" "$symplant" run "$work/plant.json" --until 1s
