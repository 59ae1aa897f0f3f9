#!/usr/bin/env bash
# Every line of docs/values.md that is said to be of an example is in its file. usage: values_page.sh PROJECT
set -euo pipefail
project=$1
count=0
while IFS='|' read -r file line; do
  count=$((count + 1))
  sed 's/^ *//' "$project/$file" | grep -xF -- "$line" >/dev/null || { echo "docs/values.md: $file has no line: $line"; exit 1; }
done < <(awk '
  /^<!-- lines of .* -->$/ { file = $4; next }
  /^```jsonc$/ { inside = file != ""; next }
  /^```$/ { inside = 0; file = ""; next }
  inside { sub(/^ */, ""); print file "|" $0 }' "$project/docs/values.md")
((count >= 12)) || { echo "docs/values.md: $count lines are found: has its form changed?"; exit 1; }
echo "$count lines"
