#!/usr/bin/env bash
# A list that is long enough for several threads, for the thread sanitizer: every rule looks at it, and many report.
# usage: long_list.sh SYMPLANT
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
program=$1

# Devices of four symbols; of every seventh name a level is missing, of every ninth the address is used twice.
awk 'BEGIN {
  print "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment"
  for (i = 0; i < 30000; ++i) {
    unit = int(i / 4); event = i % 4 > 1
    name = "LINE" unit % 7 "_ST" unit % 50 (i % 7 == 3 ? "" : "_CLAMP" unit) "_" (event ? "I" : "O") "_" (i % 2 ? "CLOSE" : "OPEN")
    printf "VAR_GLOBAL,%s,,%%%sX%d,BOOL,FALSE,clamp %d\n", name, event ? "I" : "Q", i % 9 ? i : 9, unit
  }
}' >"$work/list.csv"
code=0
"$program" check --format json --output "$work/found.json" "$work/list.csv" 2>"$work/log" || code=$?
if grep -q ThreadSanitizer "$work/log"; then fail "a race: $(head -n 40 "$work/log")"; fi
((code == 0 || code == 1)) || fail "exit code $code: $(cat "$work/log")"
(($(grep -o '"SP[0-9]*"' "$work/found.json" | sort -u | wc -l) >= 2)) || fail "the list has no findings"
