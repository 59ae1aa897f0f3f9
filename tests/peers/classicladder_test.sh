#!/usr/bin/env bash
# A real soft PLC in the loop: LinuxCNC's Classic Ladder, a Modbus TCP master, runs the paper's cell by a program. Three
# cycles; then a sensor is forced off, which must stop the cycle and raise the PLC's alarm; released, it continues.
#
# usage: classicladder_test.sh as-it-is|one-off EXAMPLE PLANT [ARGUMENT]...
#
# EXAMPLE is the folder examples/excell. `one-off` lets the PLC count addresses from 1 instead of 0: the same check must then fail,
# though every request is answered. All runs on 127.0.0.1, and in separate PID and IPC namespaces if those are allowed;
# with them all started processes end, and shared memory is removed.
# Exit code: 0 passed, 1 a check failed, 77 (skipped by ctest) no Classic Ladder, or another LinuxCNC is running.
set -euo pipefail

for program in halrun halcmd classicladder Xvfb; do
  command -v "$program" >/dev/null || { echo "$program is not installed: skipped"; exit 77; }
done
namespaces=(unshare --ipc --pid --fork --mount --mount-proc --kill-child)
((EUID == 0)) || namespaces+=(--user --map-current-user)
if [[ -z ${SYMPLANT_TEST_INSIDE-} ]] && "${namespaces[@]}" true 2>/dev/null; then
  SYMPLANT_TEST_INSIDE=1 exec "${namespaces[@]}" "$BASH" "$0" "$@"
fi
if /usr/lib/linuxcnc/realtime status; then
  echo "another LinuxCNC is running here, and there can be but one: skipped"
  exit 77
fi

# shellcheck source=../examples/lib.sh
. "$(dirname "${BASH_SOURCE[0]}")/../examples/lib.sh"
addresses=$1 example=$(realpath "$2")
shift 2

# --- The soft PLC, in $work/plc. Its real-time part does not run as root: it runs as an unprivileged user.

number=$((20000 + RANDOM)) # of the display
chmod 711 "$work"
mkdir -m 777 "$work/plc"
cd "$work/plc"
export DISPLAY=":$number" HOME=$PWD TMP=$PWD RTAPI_FIFO_PATH=fifo RTAPI_UID=65534
((EUID == 0)) || RTAPI_UID=$EUID
xvfb="" halrun=""

clean_up_all() {
  [[ -z $halrun ]] || halrun -U >/dev/null 2>&1 || true
  controller="$halrun $xvfb"
  clean_up
  rm -f "/tmp/.X11-unix/X$number" "/tmp/.X$number-lock"
}
trap clean_up_all EXIT

start_plc() { # FIRST: the first address
  sed -e "s/127\.0\.0\.1:1502/127.0.0.1:$port/" -e "s/^MODBUS_ELEMENT_OFFSET=.*/MODBUS_ELEMENT_OFFSET=$1/" \
    -e "s/^MODBUS_DEBUG_LEVEL=.*/MODBUS_DEBUG_LEVEL=1/" "$example/classicladder/cell.clp" >cell.clp
  cp "$example/classicladder/cell.hal" .
  Xvfb "$DISPLAY" -screen 0 1024x768x24 -nolisten tcp >"$work/xvfb.log" 2>&1 &
  xvfb=$!
  wait_until "Xvfb is there" test -S "/tmp/.X11-unix/X$number"
  halrun cell.hal >"$work/plc.log" 2>&1 &
  halrun=$!
}

stop_plc() { # ends its window process; halrun then ends the rest, and removes the shared memory
  local code=0
  halcmd unloadusr classicladder >>"$work/plc.log" 2>&1 || true
  wait "$halrun" || code=$?
  halrun=""
  ((code == 0)) || fail "halrun ended with exit code $code"
}

plc_cycles() { halcmd getp classicladder.0.s32out-00 2>/dev/null; }
plc_alarm() { halcmd getp classicladder.0.out-00 2>/dev/null; }

# The PLC's own display, its count of cycles and its alarm lamp: a line for each change, while the plant runs.
watch_plc() {
  local cycles alarm seen=""
  while kill -0 "$plant" 2>/dev/null; do
    sleep 0.1
    cycles=$(plc_cycles) && alarm=$(plc_alarm) || continue
    [[ "$cycles $alarm" != "$seen" ]] || continue
    seen="$cycles $alarm"
    awk "BEGIN { printf \"%8.2f s  PLC   shows   %d cycles, alarm %s\n\", $EPOCHREALTIME - $began, $cycles,
                 \"$alarm\" == \"TRUE\" ? \"on\" : \"off\" }"
  done
}

# --- The expected results

# The one check: the plant's verdict on its scenario; in its trace five cycles, and in the fourth a stop of at least 8 s, the
# vehicle moving, that ends with the sensor; the PLC's own count, and its alarm during that stop only.
the_cycle_is_as_told() {
  ((verdict == 0)) || return 1
  awk -v need=5 -f "$example/timeline.awk" "$work/trace.jsonl" >"$work/timeline.txt" || return 1
  awk '/cycle 3 completed/ { fourth = 1 }
       fourth && $1 - time >= 8 { stops++; right += what ~ /clears +EXLINE_MB_AGV_I_P1/ && $0 ~ /sets +EXLINE_MB_AGV_I_P2/ }
       { time = $1; what = $0 }
       END { exit stops == 1 && right == 1 ? 0 : 1 }' "$work/timeline.txt" || return 1
  grep -q '3 cycles, alarm on' "$work/shown.txt" && [[ $counted == 5 && $alarm == FALSE ]]
}

began=$EPOCHREALTIME
case $addresses in
  as-it-is) first=0 limit=() ;;
  one-off) first=1 limit=(--until 20s) ;;
  *) fail "as-it-is or one-off?" ;;
esac
start_plant "$@" --scenario "$example/classicladder/fault.json" "${limit[@]}"
start_plc "$first"
watch_plc >"$work/shown.txt"
verdict=0
wait "$plant" || verdict=$?
plant=""
counted=$(plc_cycles) alarm=$(plc_alarm)
stop_plc
answers=$(grep -c 'Length=[1-9].* bytes <-' "$work/plc.log") unanswered=$(grep -c 'NO RESPONSE' "$work/plc.log") || true

if [[ $addresses == as-it-is ]]; then
  the_cycle_is_as_told || fail "the cycle is not as told"
  awk '/cycle 3 completed/ { print; printf "%8.2f s  fault forces EXLINE_MB_AGV_I_P2    off\n", $1; on = 1; next }
       on && /EXLINE_MB_AGV_I_P2/ { printf "%8.2f s  fault ends   EXLINE_MB_AGV_I_P2    released\n", $1; on = 0 }
       / s  / { print }' "$work/timeline.txt" "$work/shown.txt" | sort -s -n -k 1,1
  tail -n 1 "$work/timeline.txt"
else
  ! the_cycle_is_as_told || fail "addresses are one off, and nothing is noticed"
  ((verdict == 1)) || fail "the plant's exit code is $verdict, not that of a failed expectation"
  awk -v need=0 -f "$example/timeline.awk" "$work/trace.jsonl" | tee "$work/timeline.txt"
  grep -q '^0 cycles' "$work/timeline.txt" || fail "a cycle, though addresses are one off"
  [[ $counted == 0 ]] || fail "the PLC counts $counted cycles"
  echo "addresses one off: the same check fails"
fi
grep '^link .*requests\|^expectations' "$work/plant.log"
echo "PLC: $counted cycles, $answers answers"
((answers > 100 && unanswered <= 1)) || fail "the PLC got $answers answers, and none to $unanswered requests" # at its end
