#!/usr/bin/env bash
# Signals: the end within a second in every state, SIGUSR1, an ignored SIGHUP, a reader that has exited.
# usage: signals.sh SYMPLANT LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
program=$1 list=$2
server=(--link modbus-tcp-server://127.0.0.1:0)

# One of three tries is enough: the machine may be busy with something else for a second.
ends_within_a_second() { # SIGNAL BEFORE OPTION...; BEFORE is a command, run just before the signal
  local signal=$1 before=$2 try begin took code
  shift 2
  for try in 1 2 3; do
    start_cycle "$program" run "$list" "${server[@]}" "$@"
    sleep 0.2
    "$before"
    begin=$(milliseconds)
    kill -"$signal" "$plant"
    code=0
    wait "$plant" || code=$?
    plant=""
    took=$(($(milliseconds) - begin))
    ((code == 0)) || fail "$signal with $*: exit code $code"
    grep -q 'by a signal' "$work/plant.log" || fail "$signal with $*: it does not say why it ended"
    grep -q '"cycles":' "$work/stats.json" || fail "$signal with $*: there are no statistics"
    printf '%s %s: %d ms\n' "$signal" "$*" "$took"
    ((took < 1000)) && return
  done
  fail "$signal with $*: it took $took ms"
}

# Two seconds of cycles of 10 us, all of them to catch up.
fall_behind() { kill -STOP "$plant" && sleep 2 && kill -CONT "$plant"; }

ends_within_a_second TERM true
ends_within_a_second INT true
ends_within_a_second HUP true
ends_within_a_second TERM true --cycle 1h
ends_within_a_second TERM true --cycle 1h --spin 3599s
ends_within_a_second TERM fall_behind --cycle 10us --late catch-up:1000000

start_cycle "$program" run "$list" "${server[@]}"
kill -USR1 "$plant"
wait_until "SIGUSR1 is answered" grep -q '^[0-9]* cycles, late by .* us (p99), .* overruns; link waiting$' "$work/plant.log"
stop_plant

# A PLC that reads the status block every 150 ms, fifteen cycles, reads that the plant stops.
state() { # of the plant, over connection 5
  printf '\0\1\0\0\0\6\1\4\0\146\0\1' >&5 # input register 102
  head -c 11 <&5 | od -An -tu1 | awk '{ print $11 }'
}
start_cycle "$program" run "$list" "${server[@]}"
port=$(port_of "")
exec 5<>"/dev/tcp/127.0.0.1/$port"
[[ $(state) == 0 ]] || fail "the status block does not say that the plant waits"
begin=$(milliseconds)
kill -TERM "$plant"
for ((told = 0; told != 4; )); do # repeats until the signal has had its effect
  sleep 0.15
  told=$(state)
  [[ -n $told ]] || fail "the connection ended, and the status block did not say that the plant stops"
done
wait "$plant" || fail "exit code $? where the end was read"
plant=""
printf 'TERM, its end read: %d ms\n' "$(($(milliseconds) - begin))"
exec 5<&-

# A PLC that stops reading is waited for half a second at most.
start_cycle "$program" run "$list" "${server[@]}"
port=$(port_of "")
exec 5<>"/dev/tcp/127.0.0.1/$port"
[[ $(state) == 0 ]] || fail "the status block does not say that the plant waits"
stop_plant
exec 5<&-

start_cycle env nohup "$program" run "$list" "${server[@]}"
kill -HUP "$plant"
sleep 0.5
kill -0 "$plant" || fail "a SIGHUP that was ignored at the start ended it"
stop_plant

# The reader of its output exits; the plant continues.
mkfifo "$work/pipe"
"$program" run "$list" "${server[@]}" --stats "$work/stats.json" >"$work/pipe" 2>"$work/plant.log" &
plant=$!
head -n 1 "$work/pipe" >/dev/null
sleep 0.5
kill -USR1 "$plant"
sleep 0.5
kill -0 "$plant" || fail "it ended when nobody read its output any more"
kill -TERM "$plant"
code=0
wait "$plant" || code=$?
plant=""
((code == 3)) || fail "exit code $code where the output could not be written"
grep -q '"cycles":' "$work/stats.json" || fail "without a reader there are no statistics"

# No reader takes its output: it still ends, and says why. One of three tries is enough, as above.
cannot_end() { # WHAT WORDS COMMAND...; the command's plant gets the signal to end after half a second
  local what=$1 words=$2 try begin took code
  shift 2
  for try in 1 2 3; do
    "$@" 2>"$work/plant.log" &
    plant=$!
    sleep 0.5
    kill -0 "$plant" || fail "$what: it did not run"
    begin=$(milliseconds)
    kill -TERM "$plant"
    for ((; $(milliseconds) - begin < 5000; )); do kill -0 "$plant" 2>/dev/null || break; sleep 0.02; done
    took=$(($(milliseconds) - begin))
    kill -KILL "$plant" 2>/dev/null || true
    code=0
    wait "$plant" || code=$?
    plant=""
    ((code == 3)) || fail "$what: exit code $code after $took ms"
    grep -q "$words" "$work/plant.log" || fail "$what: it does not say why"
    printf 'TERM with %s: %d ms\n' "$what" "$took"
    ((took < 1000)) && return
  done
  fail "TERM with $what: it took $took ms"
}

mkfifo "$work/full" "$work/late" "$work/unread"
exec 3<>"$work/full" 4<>"$work/late" # readers that do not read
fill() { timeout 1 head -c 1048576 /dev/zero >"$1" || true; }
fill "$work/full"
stuck() { exec "$program" run "$list" "$@" >"$work/full"; }
stuck_later() {
  (sleep 0.2 && fill "$work/late") &
  exec "$program" run "$list" "$@" >"$work/late"
}
named() { exec "$program" run "$list" "$@" >"$work/said"; }
cannot_end "a trace to a pipe that is not read" "while an output was blocked" stuck "${server[@]}" --trace -
cannot_end "a pipe that is not read" "while an output was blocked" stuck "${server[@]}"
cannot_end "a pipe that is no longer read" "while an output was blocked" stuck_later "${server[@]}"
cannot_end "a run in virtual time into a pipe" "while an output was blocked" stuck --until 10h --trace -
cannot_end "a file that is a pipe" "while an output was blocked" named "${server[@]}" --trace "$work/full"
cannot_end "a FIFO without a reader" "before the run began" named --clock real --trace "$work/unread"
