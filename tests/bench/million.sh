#!/bin/sh
# Measures how long check, generate, model and map take for a list of a million rows, as whole processes:
#   tests/bench/million.sh BUILD [ROWS [RUNS]]
# BUILD is the build folder of the preset bench. The best of several runs counts, for each time apart: other load on the
# machine only increases the time. Ratios are those to Python's csv module, of the user time and of the time that a user
# waits (wall).
set -eu
build=${1:?usage: million.sh BUILD [ROWS [RUNS]]}
rows=${2:-1000000}
runs=${3:-5}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
list=$folder/list.csv
short=$folder/short.csv
bad=$folder/bad.csv
"$build/tests/bench/make_list" $((rows / 4)) 10 > "$list"
sed 's/_\([IO]\)_/-\1_/' "$list" > "$bad" # every name is a finding
sed 's/LINE\([0-9]*_.*\)$/L\1 no/' "$list" > "$short" # of the same size, no name is too long

# user, system and wall seconds and MB of several runs of a command, the least of each
least() {
  run=0
  while [ $run -lt "$runs" ]; do
    /usr/bin/time -o "$folder/time" -f '%U %S %e %M' "$@" > "$folder/out" 2> "$folder/err" || [ $? -eq 1 ] || {
      cat "$folder/err" >&2
      exit 1
    }
    tail -n 1 "$folder/time"
    run=$((run + 1))
  done | awk '{ for (i = 1; i <= 4; ++i) if (NR == 1 || $i < least[i]) least[i] = $i }
    END { printf "%.2f %.2f %.2f %d\n", least[1], least[2], least[3], least[4] / 1024 }'
}

row() {
  name=$1
  shift
  least "$@" > "$folder/least"
  read -r user system wall memory < "$folder/least"
  ratios=$(awk "BEGIN { printf \"%.2f | %5.2f\", $user / $csv, $wall / $csv_wall }")
  printf '| %-42s | %6s | %6s | %6s | %6s | %5s |\n' "$name" "$user" "$system" "$wall" "$memory" "$ratios"
}

cat > "$folder/read.py" << 'EOF'
import csv, sys
with open(sys.argv[1], newline='', encoding='utf-8') as file:
    for row in csv.reader(file): pass
EOF
least python3 "$folder/read.py" "$list" > "$folder/csv"
read -r csv system csv_wall memory < "$folder/csv"
printf '| %-42s | user s | sys s  | wall s |     MB | ratio | wall  |\n|---|---|---|---|---|---|---|\n' "$rows rows, $(($(wc -c < "$list") / 1000000)) MB"
row "Python's csv.reader alone" python3 "$folder/read.py" "$list"
row "check, no warnings" "$build/symplant" check "$short"
row "check, a fifth of the names too long" "$build/symplant" check "$list"
row "generate, nothing there yet" sh -c 'rm -rf "$3"; exec "$1" generate "$2" -o "$3"' - "$build/symplant" "$list" "$folder/plant"
row "generate, nothing changed" "$build/symplant" generate "$list" -o "$folder/plant"
row "check, every name at fault" "$build/symplant" check "$bad"
row "check --format json, every name at fault" "$build/symplant" check --format json --output "$folder/result" "$bad"
for format in json html table; do row "model --format $format" "$build/symplant" model --format $format "$list"; done
row "map" "$build/symplant" map "$list"
