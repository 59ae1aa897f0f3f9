#!/usr/bin/env bash
# Makes each row of the table "What makes a run red" of docs/reliability.md happen: its exit code, the line on the
# terminal, the case of --junit. usage: red_runs.sh SYMPLANT SOURCE_DIR
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../examples/lib.sh"
symplant=$1 source_dir=$2
list=$source_dir/examples/excell/excell.csv
server=(--link modbus-tcp-server://127.0.0.1:0)
cd "$work"

scenario() { # STEP...
  local IFS=,
  printf '{"symplant-scenario":1,"steps":[%s]}' "$*" >scenario.json
}
run() { # ARGUMENT...
  code=0
  "$symplant" run "$@" --junit junit.xml >plant.log 2>&1 || code=$?
}
# Starts the run, waits until it listens, makes one request that a PLC makes, and waits for the end.
run_with_one_request() { # ARGUMENT...
  "$symplant" run "$@" "${server[@]}" --junit junit.xml >plant.log 2>&1 &
  plant=$!
  wait_until "the plant says where it listens" listening
  exec 3<>"/dev/tcp/127.0.0.1/$port"
  printf '\x00\x01\x00\x00\x00\x06\x01\x02\x00\x01\x00\x02' >&3
  head -c 10 <&3 >answer
  exec 3>&-
  end_of_plant
}
end_of_plant() {
  code=0
  wait "$plant" || code=$?
  plant=""
}

cause_1() { scenario '{"at":"1s","expect":{"EXLINE_MB_AGV_I_P2":true}}' && run "$list" --scenario scenario.json; }
cause_2() {
  scenario '{"at":"1s"}' '{"at":"9s","expect":{"EXLINE_MB_AGV_I_P1":true}}'
  run "$list" --scenario scenario.json --until 2s
}
both='{"at":"1s","set":{"EXLINE_MB_AGV_O_P1":true,"EXLINE_MB_AGV_O_P2":true}},{"at":"2s"}'
cause_3() {
  cp "$list" .
  echo '{"symplant":1,"symbols":["excell.csv"],"requirements":[{"name":"apart","never":"EXLINE_MB_AGV_O_P1 and EXLINE_MB_AGV_O_P2"}]}' >plant.json
  scenario "$both" && run plant.json --scenario scenario.json
}
cause_4() { scenario "$both" && run "$list" --scenario scenario.json --fail-on-findings; }
cause_5() { run "$list" "${server[@]}" --until 100ms; }
cause_6() {
  cp "$list" .
  echo '{"symplant":1,"symbols":["excell.csv"],"links":[{"url":"modbus-tcp-server://127.0.0.1:0","loss-after":"200ms","plant-on-loss":"freeze"}]}' >plant.json
  run_with_one_request plant.json --until 5s
}
cause_7() {
  printf 'Name,Address,Type\nL_P_AGV_I_P1,%%IX1,BOOL\nL_P_AGV_I_P2,%%IX2,BOOL\nPLC_O_MS,%%QW1,UINT\n' >clock.csv
  run_with_one_request clock.csv --clock plc:PLC_O_MS --until 1s
}
cause_8() {
  "$symplant" run "$list" --clock real --rt-check 1000000 --junit junit.xml >plant.log 2>&1 &
  plant=$!
  wait_until "the cycles go" grep -q '^rt-check: .* cycles in real time' plant.log
  sleep 0.2
  kill -TERM "$plant"
  end_of_plant
}
cause_9() { # a port that no program listens on
  run "$list" --link 'modbus-tcp://127.0.0.1:1?events=coils:800' --until 100ms
}
cause_10() { echo '{' >bad.json && run "$list" --scenario bad.json; }
cause_11() { run "$list" --until 1s --trace /no/such/folder/trace; }
cause_12() {
  "$symplant" run "$list" "${server[@]}" --junit junit.xml >plant.log 2>&1 &
  plant=$!
  wait_until "the cycle goes" grep -qs '^running in real time' plant.log
  kill -KILL "$plant"
  end_of_plant 2>>killed.log
}

awk '/^## What makes a run red/ { inside = 1; next } /^## / { inside = 0 } inside && /^\| [^w-]/' \
  "$source_dir/docs/reliability.md" | grep -v '^| what happens' >rows
[[ $(wc -l <rows) == 12 ]] || fail "the table has $(wc -l <rows) rows, this script makes 12 happen"

number=0
while IFS='|' read -r _ what expected _ words case _; do
  number=$((number + 1))
  rm -f plant.log
  echo '<testsuites/>' >junit.xml # of an earlier run
  "cause_$number" </dev/null
  [[ $expected == *3,* ]] || ((code == expected)) || fail "exit code $code instead of$expected:$what"
  ((code != 0)) || fail "exit code 0:$what"
  text=$(sed -n 's/^ `\(.*\)` $/\1/p' <<<"$words")
  grep -qF -- "$text" plant.log || fail "the terminal lacks \`$text\`:$what"
  name=${case#*\`} && name=${name%%\`*}
  kind=failure
  [[ $case != *error* ]] || kind=error
  grep -A1 "name=\"$name" junit.xml | grep "<$kind message=" >/dev/null || fail "JUnit has no $kind of \`$name\`:$what"
  echo "$number:$what: exit code $code"
done <rows
