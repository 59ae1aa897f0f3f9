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
