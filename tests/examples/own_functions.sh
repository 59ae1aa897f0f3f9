#!/usr/bin/env bash
# The program reports the functions that its class replaces; its model is not that of `symplant run`, which has no code.
# usage: own_functions.sh PLANT SYMPLANT EXAMPLE
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
binary=$1 tool=$2 example=$3

"$binary" --until 1s >"$work/plant.log" || fail "the program"
grep -qxF 'behavior `MyAgv` replaces d_ext, l_enter, l_leave of 1 device' "$work/plant.log" || fail "what is replaced is not reported"
"$tool" run "$example/plant.json" --until 1s >"$work/interpreted.log" || fail "symplant run"
grep -q '^behavior `MyAgv` of 1 device has no code' "$work/interpreted.log" || fail "no line says that it has no code"
[[ $(grep -o 'model [0-9a-f]\{16\}' "$work/plant.log") != $(grep -o 'model [0-9a-f]\{16\}' "$work/interpreted.log") ]] ||
  fail "the model's hashes are equal"
