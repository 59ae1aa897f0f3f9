#!/usr/bin/env bash
# Measures PLC programs in lock step, as whole processes: scans a second of the paper's cell, and plant time to wall time of
# the body-shop line. usage: lock_step.sh BUILD [RUNS]; BUILD is the build folder. The best of several runs counts.
set -euo pipefail
build=${1:?usage: lock_step.sh BUILD [RUNS]} runs=${2:-5}

best() { # COMMAND...: the least wall time of it, in seconds
  local run
  for ((run = 0; run < runs; run++)); do
    /usr/bin/time -f %e "$@" 2>&1 >/dev/null | tail -n 1
  done | sort -n | sed -n 1p
}

examples=$build/examples
cell=$(best "$examples/excell/excell" --program "$examples/excell/excell_program.so" --until 24h)
line=$(best "$examples/body-shop/body_shop" --program "$examples/body-shop/body_shop_program.so" --until 1h)
awk -v cell="$cell" -v line="$line" 'BEGIN {
  printf "| the cell, 24 hours, 8,640,000 scans | %.2f s | %.1f million scans a second | %d times real time |\n", cell, 8.64 / cell, 86400 / cell
  printf "| the body-shop line, 1 hour | %.2f s | %.0f scans a second | %d times real time |\n", line, 360000 / line, 3600 / line
}'
