#!/usr/bin/env bash
# What a panel with four clients costs the cycle: 10,000 devices at a cycle of 1 ms, two PLCs, in turns with and without it.
# usage: panel.sh BUILD_FOLDER [TURNS [SECONDS]]. Prints the table of docs/performance.md.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../rt/large_plant.sh"
build=$(realpath "${1:?usage: panel.sh BUILD_FOLDER [TURNS [SECONDS]]}") turns=${2:-5} seconds=${3:-10}
symplant=$build/symplant masters=$build/tests/rt/modbus_masters devices=5000
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$work"' EXIT

port_of() { sed -n "s,^link PLC$1=modbus-tcp-server://127\.0\.0\.1:\([0-9]*\).*,\1,p" "$work/plant.log"; }
ticks() { sed 's/.*) //' "/proc/$plant/stat" | awk '{ print $12 + $13 }'; }
field() { # NAME QUANTILE: of stats.json, in us
  sed -n "s/.*\"$1\":{[^}]*\"$2\":\([0-9]*\).*/\1/p" "$work/stats.json" | awk '{ printf "%.1f", $1 / 1e3 }'
}

# One client of the stream; counts its events and bytes.
look() { # PORT FILE
  exec 3<>"/dev/tcp/127.0.0.1/$1"
  printf 'GET /api/v1/stream HTTP/1.1\r\nHost: 127.0.0.1:%s\r\n\r\n' "$1" >&3
  cat <&3 >"$2"
}

run() { # FILE OPTION...
  local file=$1 begin end
  rm -f "$work/plant.log"
  shift
  "$symplant" run "$work/plant.json" --link PLC1=modbus-tcp-server://127.0.0.1:0 --link PLC2=modbus-tcp-server://127.0.0.1:0 \
    --cycle 1ms --stats "$work/stats.json" "$@" >"$work/plant.log" 2>&1 &
  plant=$!
  until grep -qs "^running" "$work/plant.log"; do sleep 0.05; done
  local clients=() panel
  panel=$(sed -n 's,^panel: http://127\.0\.0\.1:\([0-9]*\)/.*,\1,p' "$work/plant.log")
  if [[ -n $panel ]]; then
    for i in 1 2 3 4; do
      look "$panel" "$work/stream$i" &
      clients+=($!)
    done
  fi
  "$masters" 2 100 "$devices" "$(port_of 1)" "$(port_of 2)" >/dev/null # until all devices are moving
  begin=$(ticks)
  "$masters" "$seconds" 100 "$devices" "$(port_of 1)" "$(port_of 2)" >"$work/masters.log"
  end=$(ticks)
  kill -TERM "$plant"
  wait "$plant" || true
  ((${#clients[@]} == 0)) || kill "${clients[@]}" 2>/dev/null || true
  printf '%s %s %s %s %s\n' "$(field work p50)" "$(field work p99)" "$(field lateness p50)" "$(field lateness p99)" \
    "$(awk -v t=$((end - begin)) -v hz="$(getconf CLK_TCK)" -v s="$seconds" 'BEGIN { printf "%.1f", 100 * t / hz / s }')" >>"$work/$file"
}

median() { awk -v column="$1" '{ print $column }' "$work/$2" | sort -n | awk '{ all[NR] = $1 } END { print all[int((NR + 1) / 2)] }'; }
row() { # NAME FILE
  printf '| %s | %s | %s | %s | %s | %s %% |\n' "$1" "$(median 1 "$2")" "$(median 2 "$2")" "$(median 3 "$2")" "$(median 4 "$2")" \
    "$(median 5 "$2")"
}

write_large_plant "$work" "$devices"
printf 'load of the machine before: %s\n\n' "$(cut -d' ' -f1-3 /proc/loadavg)"
for _ in $(seq "$turns"); do
  run without
  run with --panel 127.0.0.1:0
done
cat "$work/masters.log"
echo "10,000 devices, a cycle of 1 ms, us, medians of $turns turns of $seconds s each"
echo '| | work p50 | work p99 | late p50 | late p99 | processor time |'
echo '|---|---|---|---|---|---|'
row "without a panel" without
row "with a panel and four clients" with
awk -v s="$((seconds + 2))" '/^event:/ { ++n } { bytes += length($0) + 1 } END { printf "a client got %.1f events and %.0f kB a second\n", n / s, bytes / s / 1e3 }' "$work/stream1"
