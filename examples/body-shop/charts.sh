#!/bin/sh
# Runs both scenarios of the body-shop line and draws what happened, cycle.svg and clamps-too-early.svg.
# usage: charts.sh SYMPLANT FOLDER; SYMPLANT: name or path of the tool
set -eu
symplant=$1 output=$2
here=$(dirname "$0")

trace() { # SCENARIO: writes its trace; exit code 1 (a violated requirement) is accepted here
  "$symplant" run "$here/plant.json" --scenario "$here/$1.json" --trace "$output/$1.jsonl" >/dev/null 2>&1 || test $? -eq 1
}

trace cycle
awk -v until=38 -v title="Three stations of a body-shop line, as a scenario drives them" -v devices="
  BODY_UNDER10_PIN1 BODY_UNDER10_CLAMP1 BODY_UNDER10_CLAMP3 BODY_UNDER10_LATCH1 BODY_UNDER10_WELDER1 BODY_UNDER10_ROBOT1
  BODY_UNDER10_ROBOT2 BODY_SIDE10_CLAMP1 BODY_SIDE10_TABLE1 BODY_SIDE10_ROBOT1 BODY_MOVE10_CONVEYOR1 BODY_MOVE10_SHUTTLE1" \
  -f "$here/timing.awk" "$output/cycle.jsonl" >"$output/cycle.svg"

trace clamps-too-early
awk -v until=26 -v title="The same station under a program that forgets robot 2" -v mark=21.9 \
  -v note="21.9 s, violated: robot 2 works only in closed clamps" \
  -v devices="BODY_UNDER10_CLAMP1 BODY_UNDER10_ROBOT1 BODY_UNDER10_ROBOT2" \
  -f "$here/timing.awk" "$output/clamps-too-early.jsonl" >"$output/clamps-too-early.svg"
