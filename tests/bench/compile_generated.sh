#!/bin/sh
# Measures the compile time of g++ -O2 for generated plants of several sizes, in user seconds for all their files:
#   tests/bench/compile_generated.sh BUILD [DEVICES ...]
# BUILD is the build folder of the preset bench. The best of three runs counts.
set -eu
build=${1:?usage: compile_generated.sh BUILD [DEVICES ...]}
shift
[ $# -gt 0 ] || set -- 100 1000 10000 100000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

compile() {
  for file in "$folder"/plant/*.cpp; do
    "${CXX:-g++}" -O2 -std=c++20 -I "$build/runtime/include" -c "$file" -o "$folder/object.o"
  done
}

printf '| devices | symbols | user s |\n|---|---|---|\n'
for devices; do
  "$build/tests/bench/make_list" "$devices" 10 > "$folder/list.csv"
  rm -rf "$folder/plant"
  "$build/symplant" generate "$folder/list.csv" -o "$folder/plant" > /dev/null
  run=0
  while [ $run -lt 3 ]; do
    # The user time of the children, as the shell measures it.
    (compile; times) | tail -n 1 | awk '{ split($1, t, /[ms]/); print t[1] * 60 + t[2] }'
    run=$((run + 1))
  done | sort -n | awk -v devices="$devices" 'NR == 1 { printf "| %d | %d | %.2f |\n", devices, 4 * devices, $1 }'
done
