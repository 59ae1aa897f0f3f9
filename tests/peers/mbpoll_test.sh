#!/usr/bin/env bash
# Independent check: mbpoll, a third-party Modbus client, reads and writes the paper's cell as a plant serves it.
#
# usage: mbpoll_test.sh PLANT [ARGUMENT]...
#
# PLANT is a command that runs the cell in real time (`symplant run list.csv`, a generated plant); this script adds
# `--link modbus-tcp-server://127.0.0.1:PORT`. The cell: discrete inputs 1 to 4 are AGV P1, AGV P2, MC IDLE1, MC RUN2;
# coils 1 to 4 are AGV to P2, AGV to P1, MC to IDLE1, MC to RUN2; every travel takes 1 s to 10 s.
# SYMPLANT_ENDS_BY: the signal that ends the plant, TERM by default; Wine knows INT.
# Exit code: 0 passed, 1 a check failed, 2 usage, 77 mbpoll is not installed (skipped by ctest).
set -u

(($# > 0)) || { echo "usage: $0 PLANT [ARGUMENT]..." >&2; exit 2; }
command -v mbpoll >/dev/null || { echo "mbpoll is not installed: skipped"; exit 77; }

signal=${SYMPLANT_ENDS_BY:-TERM}
log=$(mktemp)
plant=""
failures=0

stop_plant() {
  [[ -n $plant ]] || return 0
  kill -TERM "$plant" 2>/dev/null
  wait "$plant" 2>/dev/null
  plant=""
}
trap 'stop_plant; rm -f "$log"' EXIT

poll() { # mbpoll once with protocol addresses, which count from 0
  mbpoll -m tcp -p "$port" -0 -1 -o 5 "$@" 2>&1
}

# TABLE FIRST COUNT: the values, separated by blanks; table 0 coils, 1 discrete inputs, 3 input and 4 holding registers
read_values() {
  poll -t "$1" -r "$2" -c "$3" 127.0.0.1 | sed -n 's/^\[[0-9]*\]:[[:space:]]*\([0-9-]*\).*/\1/p' | paste -sd ' '
}

write_coils() { poll -t 0 -r "$1" 127.0.0.1 -- "${@:2}" >/dev/null; } # FIRST VALUE...

check() { # WHAT EXPECTED SEEN
  if [[ $2 == "$3" ]]; then
    echo "ok: $1"
  else
    echo "FAILED: $1: expected '$2', seen '$3'"
    failures=$((failures + 1))
  fi
}

check_inputs_become() { # WHAT EXPECTED: waits, because the speed of the machine is unknown
  local seen=""
  for ((try = 0; try < 300; try++)); do
    seen=$(read_values 1 1 4)
    [[ $seen == "$2" ]] && break
    sleep 0.1
  done
  check "$1" "$2" "$seen"
}

start_plant() { # on a free port; 3 is a plant's exit code for a port in use
  for ((start = 0; start < 10; start++)); do
    port=$((20000 + RANDOM % 12000))
    (: <>"/dev/tcp/127.0.0.1/$port") 2>/dev/null && continue # another program's
    "${command[@]}" --link "modbus-tcp-server://127.0.0.1:$port" >"$log" 2>&1 &
    plant=$!
    for ((try = 0; try < 300; try++)); do
      [[ -n $(read_values 1 1 1) ]] && return 0
      kill -0 "$plant" 2>/dev/null || break
      sleep 0.1
    done
    wait "$plant"
    [[ $? == 3 ]] || break
    plant=""
  done
  echo "FAILED: the plant does not answer; it said:"
  cat "$log"
  exit 1
}

command=("$@")
start_plant

check "at the start the AGV is at P1 and the machine idle" "1 0 1 0" "$(read_values 1 1 4)"
check "at the start every command is off" "0 0 0 0" "$(read_values 0 1 4)"

write_coils 1 1 || check "writing one coil is answered" 0 1
check "a written coil reads back" "1 0 0 0" "$(read_values 0 1 4)"
check_inputs_become "the AGV comes to P2" "0 1 1 0"

write_coils 1 0 0 0 1 || check "writing four coils is answered" 0 1
check "written coils read back" "0 0 0 1" "$(read_values 0 1 4)"
check_inputs_become "the machine comes to RUN2" "0 1 0 1"

write_coils 1 0 1 1 0
check_inputs_become "AGV and machine go back" "1 0 1 0"

check "a gap reads 0" "0" "$(read_values 1 0 1)"
write_coils 9 1
check "a gap keeps what is written to it" "1" "$(read_values 0 9 1)"
check "beyond the table there is an exception for the address" "1" \
  "$(poll -t 0 -r 16 -c 1 127.0.0.1 | grep -ci 'illegal data address')"
check "a table of which the cell has nothing answers likewise" "1" \
  "$(poll -t 4 -r 0 -c 1 127.0.0.1 | grep -ci 'illegal data address')"

kill "-$signal" "$plant"
wait "$plant"
check "the plant ends well on SIG$signal" "0" "$?"
plant=""

((failures == 0)) || { echo "$failures failed; the plant said:"; cat "$log"; exit 1; }
