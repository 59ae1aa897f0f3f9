# Shared parts of the scripts of this folder: a plant in the background, its statistics. To be sourced.
# shellcheck shell=bash
. "$(dirname "${BASH_SOURCE[0]}")/../examples/lib.sh"

skip() { # WHY; ctest reports exit code 77 as skipped
  printf 'SKIPPED: %s\n' "$1"
  exit 77
}

# Starts a command in the background and waits for its cycle; sets plant, leaves plant.log and stats.json in $work.
start_cycle() { # COMMAND...
  rm -f "$work/stats.json" "$work/plant.log" # of the previous run
  "$@" --stats "$work/stats.json" >"$work/plant.log" 2>&1 &
  plant=$!
  wait_until "the cycle goes" grep -qs "^running in real time" "$work/plant.log"
}

# A number from the statistics by its name, of the last object that has it.
stat_of() { # NAME
  sed -n "s/.*\"$1\":\([0-9]*\).*/\1/p" "$work/stats.json"
}

milliseconds() { awk '{ printf "%d\n", $1 * 1000 }' /proc/uptime; }
