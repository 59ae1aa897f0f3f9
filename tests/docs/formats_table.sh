#!/usr/bin/env bash
# Prints a table of what the tool reads from each file of a folder, as docs/formats.md has it: format, encoding, rows,
# inputs and outputs, their share of all rows, and the time of `symplant check` (user, ms; `-` with --no-time).
# usage: formats_table.sh TOOL FOLDER [--no-time]
set -euo pipefail

tool=$1 folder=$2 timed=${3:-}
errors=$(mktemp) && trap 'rm -f "$errors"' EXIT
TIMEFORMAT=%3U

count() { # WORD
  "$tool" model "$file" --format json 2>/dev/null | grep -c "\"direction\": \"$1\"" || true
}

echo '| file | format | encoding | rows | inputs | outputs | share | ms |'
echo '|---|---|---|---:|---:|---:|---:|---:|'
find "$folder" -type f ! -name '*.expected.txt' ! -name README.md | LC_ALL=C sort | while IFS= read -r file; do
  { time "$tool" check "$file" --verbose >"$errors.out" 2>"$errors" || true; } 2>"$errors.time"
  name=${file#"$folder"/}
  format=$(sed -n 's/^decided: format: \([^ ]*\) .*/\1/p' "$errors")
  if [[ -z $format ]]; then
    reason=$(sed -n '1s/.*: error: \([^;]*\);.*/\1/p' "$errors.out" | cut -c1-70)
    echo "| $name | not read: $reason | | | | | | |"
    continue
  fi
  encoding=$(sed -n 's/^decided: encoding: \([^, ]*\).*/\1/p' "$errors")
  rows=$(sed -n '1s/.*, \([0-9]*\) row.*/\1/p' "$errors.out")
  inputs=$(count event) outputs=$(count operation)
  share=$((rows == 0 ? 0 : (100 * (inputs + outputs) + rows / 2) / rows))
  ms=-
  if [[ -z $timed ]]; then ms=$(awk '{ printf "%.0f", $1 * 1000 }' "$errors.time"); fi
  echo "| $name | $format | ${encoding:-workbook} | $rows | $inputs | $outputs | $share % | $ms |"
done
rm -f "$errors.out" "$errors.time"
