#!/usr/bin/env bash
# An hour of the paper's cell in virtual time: 900 cycles, every expectation met, every change in the trace.
# usage: hour.sh HOUR_AWK SYMPLANT LIST PLANT
set -euo pipefail
hour=$1 symplant=$2 list=$3 plant=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -f "$hour" /dev/null >"$work/hour.json"
time "$symplant" run "$list" --scenario "$work/hour.json" --until 1h --trace "$work/interpreted.jsonl"
time "$plant" --scenario "$work/hour.json" --until 1h --trace "$work/compiled.jsonl"
cmp "$work/interpreted.jsonl" "$work/compiled.jsonl"
changes=$(grep -c '"symbol"' "$work/compiled.jsonl")
if ((changes != 2 + 900 * 16)); then
  echo "FAILED: $changes changes in the trace, 16 in each of 900 cycles and 2 at the start are due"
  exit 1
fi
