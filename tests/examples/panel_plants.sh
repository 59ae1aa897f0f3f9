#!/usr/bin/env bash
# The panel describes a plant the same compiled and interpreted. usage: panel_plants.sh PROGRAM SYMPLANT PLANT [LINK...]
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
program=$1 symplant=$2 list=$3
shift 3

# Reads GET /api/v1/plant of a plant into a file, without the number of the run and the ports of links.
describe() { # FILE PLANT...
  local file=$1
  shift
  : >"$work/plant.log"
  "$@" --panel 127.0.0.1:0 >"$work/plant.log" 2>&1 &
  plant=$!
  ask_panel plant | sed -E 's/"run":"[0-9a-f]*"/"run":""/; s/127\.0\.0\.1:[0-9]+/PORT/g' >"$work/$file"
  stop_plant
  grep -q '"symplant-panel":1' "$work/$file" || fail "$file is not a description of a plant"
}

describe compiled "$program" "$@"
describe interpreted "$symplant" run "$list" "$@"
cmp "$work/compiled" "$work/interpreted" || fail "the descriptions differ"
grep -q "$EXPECTED" "$work/compiled" || fail "the description does not have: $EXPECTED"
