#!/bin/sh
# Measures how long check, generate, model and map take for a list of a million rows, as whole processes:
#   tests/bench/million.sh BUILD [ROWS [RUNS]]
# BUILD is the build folder of the preset bench. The best of several runs counts: other load on the machine only
# increases the time.
set -eu
build=${1:?usage: million.sh BUILD [ROWS [RUNS]]}
rows=${2:-1000000}
runs=${3:-5}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
list=$folder/list.csv
bad=$folder/bad.csv
"$build/tests/bench/make_list" $((rows / 4)) 10 > "$list"
sed 's/_\([IO]\)_/-\1_/' "$list" > "$bad" # every name is a finding

# user and system seconds and MB of the fastest of several runs of a command
least() {
  run=0
  while [ $run -lt "$runs" ]; do
    /usr/bin/time -o "$folder/time" -f '%U %S %M' "$@" > "$folder/out" 2> "$folder/err" || [ $? -eq 1 ] || {
      cat "$folder/err" >&2
      exit 1
    }
    tail -n 1 "$folder/time"
    run=$((run + 1))
  done | sort -n | awk 'NR == 1 { printf "%.2f %.2f %d\n", $1, $2, $3 / 1024 }'
}

row() {
  name=$1
  shift
  least "$@" > "$folder/least"
  read -r user system memory < "$folder/least"
  ratio=$(awk "BEGIN { printf \"%.2f\", $user / $csv }")
  printf '| %-42s | %6s | %6s | %6s | %5s |\n' "$name" "$user" "$system" "$memory" "$ratio"
}

cat > "$folder/read.py" << 'EOF'
import csv, sys
with open(sys.argv[1], newline='', encoding='utf-8') as file:
    for row in csv.reader(file): pass
EOF
csv=1
least python3 "$folder/read.py" "$list" > "$folder/csv"
read -r csv system memory < "$folder/csv"
printf '| %-42s | user s | sys s  |     MB | ratio |\n|---|---|---|---|---|\n' "$rows rows, $(($(wc -c < "$list") / 1000000)) MB"
row "Python's csv.reader alone" python3 "$folder/read.py" "$list"
row "check" "$build/symplant" check "$list"
row "generate, nothing there yet" sh -c 'rm -rf "$3"; exec "$1" generate "$2" -o "$3"' - "$build/symplant" "$list" "$folder/plant"
row "generate, nothing changed" "$build/symplant" generate "$list" -o "$folder/plant"
row "check, every name at fault" "$build/symplant" check "$bad"
row "check --format json, every name at fault" "$build/symplant" check --format json --output "$folder/result" "$bad"
for format in json html table; do row "model --format $format" "$build/symplant" model --format $format "$list"; done
row "map" "$build/symplant" map "$list"
