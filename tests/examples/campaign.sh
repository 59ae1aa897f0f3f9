#!/usr/bin/env bash
# Fault campaigns: each class, an independent judge, holes of a program, phases, parts, crashes, and what is refused.
# usage: campaign.sh EXAMPLES SYMPLANT DRILL_PROGRAM CELL_PROGRAM CC INCLUDE
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/lib.sh"
examples=$1 symplant=$2 drill=$3 cell=$4 cc=$5 include=$6
plant=$examples/drill-station/plant.json base=$examples/drill-station/two-parts.json

compiled() { # NAME OPTION...: the drill station's program, with options of the compiler
  local name=$1
  shift
  "$cc" -std=c99 -O1 -shared -fPIC -I"$include" "$@" -o "$work/$name.so"
}
campaign() { # OPTION...: of the drill station
  "$symplant" campaign "$plant_file" --base "$base" "$@"
}
plant_file=$plant plant="" # $plant is the process of lib.sh
row() { # FILE ITEM MODE: the row of a CSV file
  awk -F, -v item="$2" -v mode="$3" '$1 == item && index($0, "," mode ",from the start,")' "$1"
}
shows() { # FILE ITEM MODE TEXT
  row "$1" "$2" "$3" | grep -F -- "$4" >/dev/null || fail "the row of $2 $3 in ${1##*/} has no \`$4\`: $(row "$1" "$2" "$3")"
}

# The right program has no silent stop but those of a dead PLC and of a start button that does nothing.
says 0 "42 faults: 3 undetected, 2 stopped, 8 other, 24 detected, 5 no effect" campaign --program "$drill" --csv "$work/good.csv" \
  --html "$work/good.html" --junit "$work/good.xml"
grep -q 'tests="42" failures="0" errors="0"' "$work/good.xml" || fail "the JUnit file has not 42 faults"

# The four holes of the other one.
compiled holes -DHOLES "$examples/drill-station/program/drill.c"
says 1 "2 violated, 5 undetected, 16 stopped, 12 other, 2 detected, 5 no effect" campaign --program "$work/holes.so" --csv "$work/holes.csv" --html "$work/holes.html"
shows "$work/holes.csv" DR_S1_CLAMP_I_CLOSE "stuck off" ",stopped," # no timeout
shows "$work/good.csv" DR_S1_CLAMP_I_CLOSE "stuck off" ",detected,"
shows "$work/holes.csv" DR_S1_SLIDE "does not move" ',"DR_S1_SPINDLE_O_RUN; DR_S1_SLIDE_O_DOWN",' # stops with the motor on
shows "$work/good.csv" DR_S1_SLIDE "does not move" ',"DR_S1_LAMPFAULT_O_ON; DR_S1_HORN_O_ON",'
shows "$work/holes.csv" DR_S1_GUARD_I_SHUT "stuck off" ",undetected," # ignores a sensor
shows "$work/good.csv" DR_S1_GUARD_I_SHUT "stuck off" ",detected,"
shows "$work/holes.csv" DR_S1_SPINDLE "does not move" ",9.21," # the alarm is too late
shows "$work/good.csv" DR_S1_SPINDLE "does not move" ",1.21,"

# Every row of both again by its command; another judge, in awk, gives the same class and the same time of the alarm.
for name in good holes; do
  awk -F ',symplant run ' 'NR > 1 { print $NF }' "$work/$name.csv" >"$work/commands"
  end=$(sed -n '1s/.*--until \([0-9.]*\)s.*/\1/p' "$work/commands" | awk '{ printf "%.0f", $1 * 1e9 }')
  pause=$(sed -n 's/.*"Longest pause of the base case","\([0-9.]*\) s".*/\1/p' "$work/$name.html" | awk '{ printf "%.0f", $1 * 1e9 }')
  common=$(sed -n '1s/ --fault .*//p' "$work/commands")
  eval "\"\$symplant\" run $common --trace \"\$work/base.jsonl\"" >/dev/null 2>&1
  checked=0
  while IFS=$'\t' read -r class detection command; do
    violated=0 lost=0
    eval "\"\$symplant\" run $command --trace \"\$work/run.jsonl\"" >"$work/run" 2>&1 || true
    grep -q '^error: .*requirement violated' "$work/run" && violated=1
    [[ $command != *"'PLC lost'"* ]] || lost=1
    mine=$(awk -v period=10000000 -v end="$end" -v violated=$violated -v lost=$lost \
      -v alarms="DR_S1_LAMPFAULT_O_ON DR_S1_HORN_O_ON" -f "$here/classes.awk" "$work/base.jsonl" "$work/run.jsonl")
    if [[ $mine == stopped* ]]; then # does it go on later?
      eval "\"\$symplant\" run ${command/--until /--until 1} --trace \"\$work/longer.jsonl\"" >/dev/null 2>&1 || true
      if awk -v end="$end" -v longest="$pause" '/"symbol":"[^"]*_O_/ { sub(/^{"t":/, ""); sub(/,.*/, "")
          if ($0 + 0 > end && $0 + 0 <= end + 3 * longest) found = 1 } END { exit !found }' "$work/longer.jsonl"; then
        mine="other${mine#stopped}"
      fi
    fi
    [[ $mine == "$class $detection" ]] || fail "$name: $command: \`$class $detection\`, but the traces show \`$mine\`"
    checked=$((checked + 1))
  done < <(awk -v FPAT='([^,]*)|("([^"]|"")*")' 'NR > 1 { n = split_row($0); sub(/^symplant run /, "", cell[n])
      print cell[6] "\t" (cell[14] == "" ? "-" : int(cell[14] * 1000 + 0.5)) "\t" cell[n] }
    function split_row(text, n, c, i, quoted) { n = 1; cell[1] = ""; quoted = 0
      for (i = 1; i <= length(text); ++i) { c = substr(text, i, 1)
        if (c == "\"") { quoted = !quoted } else if (c == "," && !quoted) { cell[++n] = "" } else { cell[n] = cell[n] c } }
      return n }' "$work/$name.csv")
  ((checked == 42)) || fail "$name: $checked rows were checked"
done

# The same results by one process, by four, and by eight parts.
campaign --program "$work/holes.so" --phases all --jobs 1 --csv "$work/one.csv" >"$work/one" || true
campaign --program "$work/holes.so" --phases all --jobs 4 --csv "$work/four.csv" >"$work/four" || true
cmp "$work/one.csv" "$work/four.csv" || fail "the number of processes shows"
for part in 1 2 3 4 5 6 7 8; do
  campaign --program "$work/holes.so" --phases all --shard $part/8 -o "$work/part$part.jsonl" >/dev/null || true
done
"$symplant" campaign --merge "$work"/part?.jsonl --csv "$work/merged.csv" --html "$work/merged.html" >"$work/merged" || true
cmp "$work/one.csv" "$work/merged.csv" || fail "eight parts are not the whole"
cmp "$work/one" "$work/merged" || fail "eight parts print another table"
says 1 "without a result" "$symplant" campaign --merge "$work"/part[1-7].jsonl --fail-on none --junit "$work/gap.xml"
grep -q 'name="every fault has a result"' "$work/gap.xml" || fail "the JUnit file does not show that results are missing"
says 2 "is in \`$work/part1.jsonl\` already" "$symplant" campaign --merge "$work/part1.jsonl" "$work/part1.jsonl"
campaign --program "$work/holes.so" --phases start --shard 2/8 -o "$work/other.jsonl" >/dev/null || true
says 2 "other.jsonl" "$symplant" campaign --merge "$work/part1.jsonl" "$work/other.jsonl"
grep -q 'just before DR_S1_CLAMP leaves OPEN' "$work/one.csv" || fail "no fault begins when the clamp leaves OPEN"
(($(wc -l <"$work/one.csv") > 200)) || fail "--phases all adds no phases"

# What fails: classes, crashes, programs that do not return.
says 1 "5 undetected" campaign --program "$work/holes.so" --fail-on undetected,stopped
says 0 "5 undetected" campaign --program "$work/holes.so" --fail-on none
says 2 "\`detectd\` is no class" campaign --program "$drill" --fail-on detectd
sed 's/^  const int works/  if (!*io[GUARD]) *(volatile int *)0 = 1;\n&/' "$examples/drill-station/program/drill.c" >"$work/crash.c"
compiled crash "$work/crash.c"
says 1 "error       DR_S1_GUARD_I_SHUT stuck off" campaign --program "$work/crash.so" --fail-on none --junit "$work/crash.xml"
grep -q "ended by SIGSEGV in scan" "$work/crash.xml" || fail "the JUnit file does not say how the program ended"

# Malfunctions of a file, with the places of its faults; those of plant.json; a bare list; no alarms.
cat >"$work/faults.json" <<'END'
[
  { "name": "worn belt", "of": "BELT", "slower": 2 },
  { "name": "both eyes", "force": { "DR_S1_STOP_I_PART": true, "DR_S1_CLAMP_I_CLOSE": true } }
]
END
says 0 "2 faults:" campaign --program "$drill" --faults "$work/faults.json" --csv "$work/file.csv"
grep -q -- "--faults $work/faults.json .*--fault 'worn belt'" "$work/file.csv" || fail "the command does not name the file"
eval "$(sed -n "s,.*\(symplant run .*worn belt.*\),\1,p" "$work/file.csv" | sed "s,^symplant,\"\$symplant\",") --trace \"$work/worn.jsonl\"" >/dev/null 2>&1 || true
grep -q '"malfunction":"worn belt","active":true' "$work/worn.jsonl" || fail "the command does not start the malfunction"
sed 's/"BELT"/"BELD"/' "$work/faults.json" >"$work/wrong.json"
says 2 "wrong.json:2:32: error: " campaign --program "$drill" --faults "$work/wrong.json"
sed 's/"slower"/"slowr"/' "$work/faults.json" >"$work/wrong.json"
says 2 "did you mean \`slower\`?" campaign --program "$drill" --faults "$work/wrong.json"
echo '{ "malfunctions": [] }' >"$work/wrong.json"
says 2 "this is no list of malfunctions" campaign --program "$drill" --faults "$work/wrong.json"
says 2 "nothing.json" campaign --program "$drill" --faults "$work/nothing.json"
echo '[]' >"$work/wrong.json"
says 2 "wrong.json" campaign --program "$drill" --faults "$work/wrong.json"
echo '{ "symplant-scenario": 1, "steps": [ { "at": "10s" } ] }' >"$work/ten.json"
says 0 "the plant has no \`alarms\`" "$symplant" campaign "$examples/excell/excell.csv" --base "$work/ten.json" --program "$cell"

# What cannot be tested.
says 2 "a campaign tests a PLC program" campaign
says 2 "give a PLANT and the base case" "$symplant" campaign "$plant_file"
says 2 "cannot read the program" campaign --program "$work/nothing.so"
says 2 "no operation changes" "$symplant" campaign "$plant_file" --base "$work/ten.json" --program "$drill"
sed 's/"plus": "2s"/"plus": "0s", "expect": "DR_S1_HORN_O_ON"/' "$base" >"$work/fails.json"
says 1 "does not pass, so no fault is tried" "$symplant" campaign "$plant_file" --base "$work/fails.json" --program "$drill" --junit "$work/old.xml"
grep -q "the run has not ended" "$work/old.xml" || fail "a campaign that cannot begin leaves earlier results"
says 2 "plant.json" campaign --program "$drill" --html "$plant_file"
says 2 "is given for two outputs" campaign --program "$drill" --csv "$work/out.csv" --html "$work/out.csv"
[[ ! -e $work/out.csv ]] || fail "one file was written for two outputs"
says 2 "excludes" "$symplant" campaign "$plant_file" --merge "$work/part1.jsonl"
says 2 "did you mean \`DR_S1_BELT stuck\`?" "$symplant" run "$plant_file" --program "$drill" --fault "DR_S1_BELD stuck" --until 1s

# Ctrl-C leaves the results that are there.
echo '{ "symplant-scenario": 1, "steps": [ { "at": "10h" } ] }' >"$work/long.json"
"$symplant" campaign "$examples/excell/excell.csv" --base "$work/long.json" --limit 20h --program "$cell" --jobs 1 -o "$work/cut.jsonl" \
  --html "$work/cut.html" >"$work/cut" 2>&1 &
plant=$!
some_results() { [[ -e $work/cut.jsonl ]] && (($(wc -l <"$work/cut.jsonl") >= 3)); }
wait_until "the first faults have results" some_results
kill -INT "$plant"
code=0
wait "$plant" || code=$?
plant=""
((code == 1)) || fail "exit code $code after Ctrl-C"
grep -q "ended by a signal" "$work/cut" && grep -q "without a result" "$work/cut" || fail "the missing faults are not counted"
grep -q "without a result" "$work/cut.html" || fail "the page does not say that results are missing"
