#!/usr/bin/env bash
# Links and real time: the tool for Windows as server and as client, with the tool for Linux at the other end; the panel;
# the end by Ctrl-C. usage: links.sh SOURCE LINUX-TOOL WINDOWS-TOOL [CASE-PATTERN]
# Needs Wine (wine64) and curl; with mbpoll, a third-party client, too.
set -euo pipefail
# shellcheck source=tests/windows/both.bash
. "$(dirname "${BASH_SOURCE[0]}")/both.bash"
cd "$work/data"

port=$((20000 + RANDOM % 10000))
running=""
stop_running() {
  [[ -z $running ]] || kill -INT "$running" 2>/dev/null || true
  [[ -z $running ]] || wait "$running" || true
  running=""
}

start() { # WORDS COMMAND...: in the background, until its output has the words
  "${@:2}" >"$work/started" 2>&1 </dev/null &
  running=$!
  for ((i = 0; i < 300; ++i)); do
    ! grep -q -- "$1" "$work/started" || return 0
    sleep 0.1
  done
  different "${*:2} does not start" "$work/started"
}

check() { # WHAT COMMAND...: succeeds
  commands=$((commands + 1))
  "${@:2}" >"$work/checked" 2>&1 || different "$1" "$work/checked"
}

# A Modbus server on Windows.
if command -v mbpoll >/dev/null; then
  check "a server for mbpoll" env SYMPLANT_ENDS_BY=INT "$source/tests/peers/mbpoll_test.sh" wine "$windows" run examples/excell/excell.csv
fi
start "running in real time" wine "$windows" run examples/excell/excell.csv --link "modbus-tcp-server://127.0.0.1:$port" --stats stats.json --trace trace.jsonl
windows_does 3 "port $port is in use" run examples/cell/plant.json --link "modbus-tcp-server://127.0.0.1:$port" --until 1s
kill -INT "$running"
code=0
wait "$running" || code=$?
running=""
commands=$((commands + 1))
[[ $code == 0 && -s stats.json && -s trace.jsonl && $(<"$work/started") == *"cycles late by"* ]] || different "run ends by Ctrl-C with code $code" "$work/started"

# A Modbus client on Windows.
client="modbus-tcp://127.0.0.1:$port?events=coils:4"
start "running in real time" "$linux" run examples/excell/excell.csv --link "modbus-tcp-server://127.0.0.1:$port"
windows_does 1 "the PLC has 1" doctor examples/excell/excell.csv --link "$client" --for 1s
windows_does 0 "recorded 1.0 s" record examples/excell/excell.csv --link "$client" --until 1s -o recorded.jsonl
windows_does 0 "anomal" watch examples/excell/excell.csv --link "$client" --until 1s
stop_running
windows_does 3 "never had a connection" run examples/excell/excell.csv --link "modbus-tcp://127.0.0.1:1?events=coils:4" --until 1s

# The panel.
start "panel: http" wine "$windows" run examples/cell/plant.json --panel "127.0.0.1:$port"
check "the page" curl -sSf -o page.html "http://127.0.0.1:$port/"
check "the plant" grep -q '"plant":"cell"' <(curl -sSf "http://127.0.0.1:$port/api/v1/plant")
check "the stream" grep -q 'event: picture' <(curl -sN --max-time 2 "http://127.0.0.1:$port/api/v1/stream")
stop_running

# Real time.
windows_does 0 "ended at 1 s: 100 cycles" run examples/excell/excell.csv --clock real --until 1s --priority 50 --lock-memory --cpu 1
windows_does 0 "\`--priority\` is refused (symplant has it on Linux only)" run examples/excell/excell.csv --clock real --until 1s --priority 50
windows_does 0 "on 64-bit Linux only" run examples/excell/excell.csv --rt-check 50

summary
