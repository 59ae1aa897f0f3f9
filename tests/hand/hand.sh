#!/usr/bin/env bash
# A plant runs as computed by hand: the trace without its header, `act` and `instant` lines is want.jsonl.
# README of the folder: a line that says what it shows, `until TIME`, `exit CODE`. With findings.jsonl the findings are these (t, finding, of).
# usage: hand.sh SYMPLANT FOLDER
set -euo pipefail
symplant=$1 folder=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { # WHAT
  printf 'FAILED: %s: %s\n' "$(head -n 1 "$folder/README")" "$1"
  tail -n 20 "$work/run.log"
  exit 1
}

value_of() { # KEY
  awk -v key="$1" '$1 == key && !found++ { print $2 }' "$folder/README"
}

changes() { # FILE
  sed -n '/^{"t":/{/"act":\|"instant":/!p}' "$1"
}

findings() { # FILE
  sed -n 's/^\({"t":[0-9]*,"finding":"[^"]*"\).*\(,"of":"[^"]*"\).*/\1\2/p' "$1"
}

code=0
"$symplant" run "$folder/plant.json" --scenario "$folder/scenario.json" --until "$(value_of until)" --trace "$work/trace.jsonl" \
  --findings "$work/findings.jsonl" >"$work/run.log" 2>&1 || code=$?
((code == $(value_of exit))) || fail "exit code $code"
if ((code != 2)); then
  diff "$folder/want.jsonl" <(changes "$work/trace.jsonl") || fail "< want.jsonl, > the trace"
fi
if [[ -f $folder/findings.jsonl ]]; then
  diff <(findings "$folder/findings.jsonl") <(findings "$work/findings.jsonl") || fail "< findings.jsonl, > the findings"
fi
