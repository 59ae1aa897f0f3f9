#!/usr/bin/env bash
# Two PLCs with equal addresses write and read one plant, each over its own link. usage: two_plcs.sh PLANT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

listening() { press=$(port_of PRESS=) && robot=$(port_of ROBOT=) && [[ -n $press && -n $robot ]]; }

# Sends a request (unit 1) and prints the answer's PDU in hexadecimal.
ask() { # PORT ANSWER_BYTES PDU_BYTES...
  local port=$1 answer=$2
  shift 2
  local request='\x00\x01\x00\x00\x00'
  request+="$(printf '\\x%02x' $(($# + 1)))\\x01"
  local byte
  for byte in "$@"; do request+="\\x$byte"; done
  exec 3<>"/dev/tcp/127.0.0.1/$port"
  printf '%b' "$request" >&3
  head -c $((7 + answer)) <&3 | tail -c "$answer" | od -An -tx1 | tr -d ' \n'
  exec 3>&-
}
switches() { ask "$1" 3 02 00 01 00 02; }  # discrete inputs 1 and 2

: >"$work/plant.log"
"$@" --link PRESS=modbus-tcp-server://127.0.0.1:0 --link ROBOT=modbus-tcp-server://127.0.0.1:0 \
  --trace "$work/trace.jsonl" >"$work/plant.log" 2>&1 &
plant=$!
wait_until "the plant says where it listens" listening

[[ $(switches "$press") == 020101 && $(switches "$robot") == 020101 ]] || fail "both do not start in their first state"
[[ $(ask "$robot" 5 05 00 02 ff 00) == 050002ff00 ]] || fail "the robot's PLC cannot write its coil"
robot_is_in() { [[ $(switches "$robot") == 020102 ]]; }
wait_until "the robot reaches in" robot_is_in
[[ $(switches "$press") == 020101 ]] || fail "the press moved, which nobody asked for"
[[ $(ask "$press" 3 01 00 01 00 02) == 010100 ]] || fail "the press's PLC sees a coil of the robot's"
stop_plant

(($(count 'CELL_HANDLING_ROBOT_O_IN2","value":true') == 1)) || fail "the trace lacks the robot's command"
(($(count 'CELL_PRESS_RAM_O_') == 0)) || fail "the trace has a command of the press"
