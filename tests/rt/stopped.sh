#!/usr/bin/env bash
# A process stopped for 5 s: it runs only the catch-up at once, the rest is lost and counted.
# usage: stopped.sh SYMPLANT LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
start_cycle "$1" run "$2" --clock real --late catch-up:10
sleep 1
kill -STOP "$plant"
sleep 5
kill -CONT "$plant"
sleep 1
kill -TERM "$plant"
wait "$plant" || fail "it ended with exit code $?"
plant=""
cat "$work/plant.log" "$work/stats.json"
# 5 s minus the ten cycles and the one that was due.
(($(stat_of slipped) >= 4880000000)) || fail "too little was lost: a burst made up for it"
(($(stat_of plant_time) == $(stat_of cycles) * 10000000)) || fail "a cycle is not 10 ms of plant time"
(($(stat_of wall_time) - $(stat_of plant_time) >= $(stat_of slipped))) || fail "more was lost than time went by"
