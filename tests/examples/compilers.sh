#!/usr/bin/env bash
# What compilers of Structured Text make runs in lock step: their output is written by hand here (compilers/), in their form.
# usage: compilers.sh EXAMPLES TEMPLATES SYMPLANT CC CXX INCLUDE
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
examples=$1 templates=$2 symplant=$3 cc=$4 cxx=$5 include=$6
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/compilers

"$cc" -std=c99 -O1 -shared -fPIC -I"$include" "$examples/excell/program/cell.c" -o "$work/c.so"
"$cxx" -std=c++17 -O1 -Wall -Wextra -Werror -shared -fPIC -I"$include" -I"$here/strucpp" -include cell.hpp \
  "$templates/strucpp.cpp" "$here/strucpp/cell.cpp" -o "$work/strucpp.so"
"$cc" -std=c99 -O1 -fPIC -c "$here/matiec/Config0.c" -o "$work/config.o"
"$cc" -std=c99 -O1 -fPIC -c "$here/matiec/Res0.c" -o "$work/res.o"
"$cxx" -O1 -Wall -Wextra -Werror -shared -fPIC -I"$include" -I"$here/matiec" "$templates/matiec.cpp" "$work/config.o" "$work/res.o" \
  -o "$work/matiec.so"

# The same traces as of the program in C with the same scans: a task of 20 ms among scans of 10 ms.
"$symplant" run "$examples/excell/excell.csv" --program "$work/c.so" --scan 20ms --scan-delay 10ms --until 60s \
  --trace "$work/expected.jsonl" >/dev/null
for compiler in strucpp matiec; do
  "$symplant" run "$here/plant.csv" --program "$work/$compiler.so" --until 60s --trace "$work/actual.jsonl" >"$work/log" ||
    fail "$compiler: the run fails"
  grep -q "reads 5 events and writes 5 operations, a scan every 0.01 s" "$work/log" || fail "$compiler: another binding"
  "$symplant" compare "$work/expected.jsonl" "$work/actual.jsonl" --ignore '*_SC_*' >"$work/log" || fail "$compiler: differs"
  "$symplant" run "$here/plant.csv" --program "$work/$compiler.so" --scenario "$here/numbers.json" >"$work/log" ||
    fail "$compiler: numbers"
done
