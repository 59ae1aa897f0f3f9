#!/usr/bin/env bash
# 3,000 numbers that change in each cycle of 10 ms, and 8 OPC UA clients that subscribe to all of them: the cycle with and
# without these clients, the values that they get, and the time from a client's write to its effect.
# usage: opc_ua.sh BUILD_FOLDER [SECONDS]. SECONDS: of each of five turns (default 10). The cycle has priority 80, so root
# or a limit of rtprio is needed.
set -euo pipefail
build=$(realpath "${1:?usage: opc_ua.sh BUILD_FOLDER [SECONDS]}") seconds=${2:-10}
symplant=$build/symplant subscribers=$build/tests/bench/opc_ua_subscribers turns=5
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$work"' EXIT

awk -v folder="$work" 'BEGIN {
  list = folder "/list.csv"; json = folder "/plant.json"; names = folder "/names"
  print "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial" > list
  print "{\"symplant\": 1, \"name\": \"bench\", \"symbols\": [\"list.csv\"], \"defaults\": {\"travel\": \"0s\"}," > json
  print "\"values\": {\"x\": {\"is\": \"mod(floor(time * 100), 10000)\"}}, \"signals\": {" > json
  for (i = 0; i < 3000; ++i) {
    name = "L_P" int(i / 100) "_S" i "_I_V"
    print "VAR_GLOBAL," name ",,%IW" i ",INT,0" > list
    print name > names
    print "\"" name "\": {\"of\": \"x + " i "\", \"every\": \"10ms\"}" (i < 2999 ? "," : "}}") > json
  }
  print "VAR_GLOBAL,L_P_CYL_O_ADV,,%QX0,BOOL,FALSE\nVAR_GLOBAL,L_P_CYL_O_RET,,%QX1,BOOL,FALSE" > list
  print "VAR_GLOBAL,L_P_CYL_I_ADV,,%IX60000,BOOL,FALSE\nVAR_GLOBAL,L_P_CYL_I_RET,,%IX60001,BOOL,TRUE" > list
}'

cycle_of() { # NAME LOG
  printf '%s: ' "$1"
  grep -E '^(cycles late by|work of a cycle):' "$2" | paste -sd' '
}

run() { # LOG SUBSCRIBERS
  "$symplant" run "$work/plant.json" --link opc-ua-server://127.0.0.1:0 --priority 80 --lock-memory >"$1" 2>&1 &
  local plant=$! port=
  until [[ -n $port ]]; do
    sleep 0.05
    port=$(sed -n 's|^link opc-ua-server://127.0.0.1:\([0-9]*\).*|\1|p' "$1")
  done
  "$subscribers" "opc.tcp://127.0.0.1:$port" "$work/names" "$2" "$seconds"
  kill -INT "$plant"
  wait "$plant" || true
}

printf 'load of the machine before: %s\n' "$(cut -d' ' -f1-3 /proc/loadavg)"
for _ in $(seq "$turns"); do
  run "$work/without" 0
  cycle_of 'without subscribers' "$work/without"
  run "$work/with" 8
  cycle_of 'with 8 subscribers' "$work/with"
done
