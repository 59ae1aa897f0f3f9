#!/usr/bin/env bash
# A project outside the tree builds a plant and a program with it. usage: consumer.sh CMAKE SOURCE CONFIGURE-ARGUMENT...
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cmake=$1 source=$2
shift 2

cp -r "$source" "$work/source"
"$cmake" -S "$work/source" -B "$work/build" "$@" >"$work/configure.log" 2>&1 || fail "configuring" "$work/configure.log"
build "$cmake" "$work/build.log"
"$work/build/press" --until 1s --clock virtual || fail "the plant does not run"
"$work/build/press" --until 1s --program "$work/build/ram_program.so" >"$work/program.log" || fail "no run with a program" "$work/program.log"
grep -q 'program `ram`.*reads 1 event and writes 1 operation' "$work/program.log" || fail "another binding" "$work/program.log"
"$work/build/consumer" || fail "the plant as a library"
