#!/usr/bin/env bash
# The scenario of the scales passes with their code, with the golden trace and a clean guard; without the code the
# plant reports it, and the scenario fails. Without the guard if a sanitizer breaks what it checks.
# usage: weigh.sh PLANT SYMPLANT EXAMPLE GOLDEN [SANITIZER]
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
binary=$1 tool=$2 example=$3 golden=$4

"$binary" --scenario "$example/weigh.json" --trace "$work/trace.jsonl" >"$work/plant.log" || fail "the scenario"
if [[ -n ${SYMPLANT_UPDATE_GOLDENS-} ]]; then cp "$work/trace.jsonl" "$golden"; fi
cmp "$golden" "$work/trace.jsonl" || fail "the trace is not $golden"
grep -q "has no code" "$work/plant.log" && fail "the behavior has no code"
grep -q '^not driven: 0 of ' "$work/plant.log" || fail "the scales' numbers are reported as not driven"

"$tool" run "$example/plant.json" --scenario "$example/weigh.json" >"$work/interpreted.log" && fail "it weighs without code"
grep -q '^behavior `WeighingScale` of 2 devices has no code' "$work/interpreted.log" || fail "no line says that it has no code"
[[ $(grep -o 'model [0-9a-f]\{16\}' "$work/plant.log") == $(grep -o 'model [0-9a-f]\{16\}' "$work/interpreted.log") ]] ||
  fail "the model's hashes differ"

if [[ -z ${5-} ]]; then
  "$binary" --scenario "$example/weigh.json" --rt-check 600 >"$work/guard.log" || fail "the guard"
  grep -q '^rt-check: 600 cycles, nothing found' "$work/guard.log" || fail "the guard found something"
fi
"$tool" generate "$example/plant.json" -o "$work/out" --behaviours "$example/behaviours" >"$work/generate.log"
grep -q written "$work/generate.log" && fail "it writes over what is there"
exit 0
