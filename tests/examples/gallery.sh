#!/usr/bin/env bash
# A device of the gallery passes its scenario, compiled and interpreted, and its trace is the published one.
# usage: gallery.sh FOLDER SYMPLANT PLANT
set -euo pipefail
folder=$1 symplant=$2 plant=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$symplant" check --fail-on warning "$folder/plant.json"
"$symplant" run "$folder/plant.json" --scenario "$folder/scenario.json" --trace "$work/interpreted.jsonl"
"$plant" --scenario "$folder/scenario.json" --trace "$work/compiled.jsonl"
cmp "$work/interpreted.jsonl" "$work/compiled.jsonl"
if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then cp "$work/interpreted.jsonl" "$folder/trace.jsonl"; fi
diff "$folder/trace.jsonl" "$work/interpreted.jsonl"

# A program with a fault, if the device has one.
if [[ -f $folder/occupied.json ]]; then
  code=0
  "$symplant" run "$folder/plant.json" --scenario "$folder/occupied.json" --fail-on-findings >"$work/occupied.log" 2>&1 || code=$?
  ((code == 1))
  grep -qF 'part blocked: place cannot move part 2 (box) from GRIPPER to BELT2: part 1 is there since 4 s' "$work/occupied.log"
fi
