#!/usr/bin/env bash
# The cycle in real time: how late it wakes, compared with cyclictest, and the cost of 10,000 devices at 1 ms.
# usage: cycle.sh BUILD_FOLDER [SECONDS]. Prints the tables of docs/performance.md. SECONDS: of load (default 30).
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/../rt/large_plant.sh"
build=$(realpath "${1:?usage: cycle.sh BUILD_FOLDER [SECONDS]}") seconds=${2:-30}
symplant=$build/symplant masters=$build/tests/rt/modbus_masters devices=5000 slices=5 slice=6
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$work"' EXIT

quantile_of() { # NAME: "p50 p99 p99.9 max" of lateness, in us
  sed -n 's/.*"lateness":{"p50":\([0-9]*\),"p99":\([0-9]*\),"p99.9":\([0-9]*\),"max":\([0-9]*\)}.*/\1 \2 \3 \4/p' "$1" |
    awk '{ printf "%.1f %.1f %.1f %.1f\n", $1 / 1e3, $2 / 1e3, $3 / 1e3, $4 / 1e3 }'
}

histogram_of() { # FILE: the same from cyclictest's histogram, which counts whole us
  awk '/^[0-9]/ { count[NR] = $2; us[NR] = $1 + 0; all += $2; if ($2) last = $1 + 0 }
    END {
      n = split("0.5 0.99 0.999", share, " ")
      for (i = 1; i <= n; ++i) { sum = 0; for (r = 1; r <= NR; ++r) { sum += count[r]; if (sum >= all * share[i]) { printf "%d ", us[r]; break } } }
      print last
    }' "$1"
}

median() { # COLUMN FILE
  awk -v column="$1" '{ print $column }' "$2" | sort -n | awk '{ all[NR] = $1 } END { print all[int((NR + 1) / 2)] }'
}

row() { # NAME FILE
  printf '| %s | %s | %s | %s | %s |\n' "$1" "$(median 1 "$2")" "$(median 2 "$2")" "$(median 3 "$2")" "$(median 4 "$2")"
}

plant() { # FILE OPTION...
  local file=$1
  shift
  "$symplant" run "$work/plant.json" --link PLC1=modbus-tcp-server://127.0.0.1:0 --link PLC2=modbus-tcp-server://127.0.0.1:0 \
    --cycle 1ms --until "${slice}s" --stats "$work/stats.json" "$@" >"$work/plant.log" 2>&1
  if grep -q '^warning:' "$work/plant.log"; then grep '^warning:' "$work/plant.log" >&2; fi
  quantile_of "$work/stats.json" >>"$file"
}

cyclictest_of() { # FILE OPTION...
  local file=$1
  shift
  cyclictest -q -t1 -i1000 -D"$slice" -h100000 "$@" >"$work/histogram"
  histogram_of "$work/histogram" >>"$file"
}

write_large_plant "$work" "$devices"
printf 'load of the machine before: %s\n\n' "$(cut -d' ' -f1-3 /proc/loadavg)"
if command -v cyclictest >/dev/null; then
  for _ in $(seq "$slices"); do
    cyclictest_of "$work/cyclictest.fifo" -m -p80
    plant "$work/plant.awake" --priority 80 --lock-memory --stay-awake
    plant "$work/plant.spin" --priority 80 --lock-memory --stay-awake --spin 100us
    plant "$work/plant.fifo" --priority 80 --lock-memory
    plant "$work/plant.other"
  done
  echo "wake-up of a cycle of 1 ms, us, medians of $slices turns of $slice s each"
  echo '| | p50 | p99 | p99.9 | max |'
  echo '|---|---|---|---|---|'
  row "cyclictest, SCHED_FIFO" "$work/cyclictest.fifo"
  row "plant, \`--priority 80 --lock-memory --stay-awake\`" "$work/plant.awake"
  row "plant, with \`--spin 100us\` as well" "$work/plant.spin"
  row "plant, \`--priority 80 --lock-memory\`" "$work/plant.fifo"
  row "plant, no option" "$work/plant.other"
else
  echo "cyclictest is not installed (package rt-tests): nothing to compare with" >&2
fi

"$symplant" run "$work/plant.json" --link PLC1=modbus-tcp-server://127.0.0.1:0 --link PLC2=modbus-tcp-server://127.0.0.1:0 \
  --cycle 1ms --stats "$work/stats.json" >"$work/plant.log" 2>&1 &
plant=$!
port_of() { sed -n "s,^link PLC$1=modbus-tcp-server://127\.0\.0\.1:\([0-9]*\).*,\1,p" "$work/plant.log"; }
until grep -q '^running' "$work/plant.log"; do sleep 0.1; done
ticks() { sed 's/.*) //' "/proc/$plant/stat" | awk '{ print $12, $13 }'; }
"$masters" 3 100 "$devices" "$(port_of 1)" "$(port_of 2)" >/dev/null # until all devices are moving
read -r user system < <(ticks)
"$masters" "$seconds" 100 "$devices" "$(port_of 1)" "$(port_of 2)" >"$work/masters.log"
read -r user_end system_end < <(ticks)
kill -TERM "$plant"
wait "$plant"
printf '\n10,000 devices, cycle of 1 ms, two PLCs that exchange the whole image every 100 ms, %s s:\n' "$seconds"
cat "$work/masters.log"
awk -v u=$((user_end - user)) -v s=$((system_end - system)) -v hz="$(getconf CLK_TCK)" -v t="$seconds" 'BEGIN {
  printf "plant process: user %.2f %%, system %.2f %%, together %.2f %% of one core\n", 100 * u / hz / t, 100 * s / hz / t, 100 * (u + s) / hz / t }'
sed -n 's/.*\("cycles":[0-9]*,"overruns":[0-9]*\).*\("work":{[^}]*}\).*/\1 \2/p' "$work/stats.json"
printf 'load of the machine behind: %s\n' "$(cut -d' ' -f1-3 /proc/loadavg)"
