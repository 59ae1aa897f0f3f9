#!/usr/bin/env bash
# Grades test suites by mutants of the programs: how many are killed by (a) requirements alone, (b) the reference trace of
# one case, (c) cases proposed by `--new`, (d) these on the normal, the fast and the slow plant. A mutant is killed if a
# case that passes with the right program does not pass with it.
# usage: mutants.sh SOURCE SYMPLANT CC INCLUDE [EVERY]     EVERY: take each N-th mutant only
set -euo pipefail
source=$1 symplant=$2 cc=$3 include=$4 every=${5:-1}
here=$source/tests/mutants
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

compile() { # C_FILE LIBRARY
  "$cc" -std=c99 -O1 -w -shared -fPIC -I"$include" "$1" -o "$2"
}
passed() { # SUITE PROGRAM [OPTION...]: the names of the cases that pass
  { timeout 300 "$symplant" test "$@" 2>&1 || true; } | sed -n 's/^passed \([^:]*\).*/\1/p' | sort
}
suite() { # NAME PLANT END: a suite with the base case only
  mkdir "$work/$1"
  printf '{ "symplant-suite": 1, "plant": "%s", "align": "follow", "limit": "20min" }\n' "$2" >"$work/$1/suite.json"
  printf '{ "symplant-scenario": 1, "steps": [ { "at": "%s" } ] }\n' "$3" >"$work/$1/base.json"
}

make_mutant() { # LINE PROGRAM.c: its library; sets `equivalent`, `operator` and `mutant`
  local line=$1
  equivalent=no
  [[ $line != =* ]] || equivalent=yes line=${line#=}
  line=${line%% # *}
  operator=${line%% *} line=${line#* }
  mutant=${line%% *}
  sed "${line#* }" "$2" >"$work/mutant.c"
  ! cmp -s "$2" "$work/mutant.c" || { echo "$mutant changes nothing"; exit 1; }
  compile "$work/mutant.c" "$work/mutant.so"
}

grade() { # NAME PROGRAM.c PLANT END
  local name=$1 program=$2 plant=$3 end=$4 kind
  compile "$program" "$work/right.so"
  for kind in a b c; do suite "$name-$kind" "$plant" "$end"; done
  "$symplant" test --new "$work/$name-c" --base base --program "$work/right.so" --most 40 >"$work/log" || { cat "$work/log"; exit 1; }
  cp -r "$work/$name-c" "$work/$name-d"
  "$symplant" test "$work/$name-b" --program "$work/right.so" --update >/dev/null || true
  "$symplant" test "$work/$name-c" --program "$work/right.so" --update >/dev/null || true
  "$symplant" test "$work/$name-d" --program "$work/right.so" --plants normal,fast,slow --update >/dev/null || true
  for kind in a b c; do passed "$work/$name-$kind" --program "$work/right.so" >"$work/$name-$kind.right"; done
  passed "$work/$name-d" --program "$work/right.so" --plants normal,fast,slow >"$work/$name-d.right"
  local line number=0 plants row
  while IFS= read -r line; do
    [[ $line != '#'* ]] || continue
    number=$((number + 1))
    ((number % every == 0)) || continue
    make_mutant "$line" "$program"
    row="$name $operator $mutant $equivalent"
    for kind in a b c d; do
      plants=normal
      [[ $kind != d ]] || plants=normal,fast,slow
      passed "$work/$name-$kind" --program "$work/mutant.so" --plants "$plants" >"$work/now"
      if cmp -s "$work/$name-$kind.right" "$work/now"; then row+=" -"; else row+=" killed"; fi
    done
    echo "$row" >>"$work/rows"
  done <"$here/$name.txt"
}
grade cell "$source/examples/excell/program/cell.c" "$here/cell/plant.json" 34s
grade sorting "$source/examples/sorting/program/sorting.c" "$here/sorting/plant.json" 60s

# The 16 mutants and 8 of timers in open loop, the 4 and 2 in closed loop: each by one case and its reference trace.
again() { # open|closed PLANT CASE
  local kind=$1 program=$source/examples/excell/program/cell.c name number=0 killed=0 count=0
  suite "$kind" "$2" 0s
  cp "$3" "$work/$kind/base.json"
  compile "$program" "$work/right.so"
  "$symplant" test "$work/$kind" --program "$work/right.so" --update >/dev/null
  while read -r name; do
    number=$((number + 1))
    ((number % every == 0)) || continue
    make_mutant "$(grep -E "^[a-z]+ $name " "$here/cell.txt")" "$program"
    count=$((count + 1))
    if [[ $(passed "$work/$kind" --program "$work/mutant.so") == "" ]]; then
      killed=$((killed + 1))
    else
      echo "survives in $kind loop: $name"
    fi
  done < <(sed -n "s/^$kind //p" "$here/paper.txt")
  echo "$killed of $count are killed in $kind loop"
  ((killed == count))
}
again open "$here/open/plant.json" "$here/open/cycle.json"
again closed "$here/cell/plant.json" "$work/cell-b/base.json"

grep ' - *$' "$work/rows" | awk '$4 == "no" { print "survives:", $1, $2, $3 }' || true
awk '$4 == "yes" && $8 == "killed" { print "named equivalent, but killed: " $1, $3; bad = 1 } END { exit bad }' "$work/rows"
awk -v every="$every" '
  $4 == "no" { for (k = 1; k <= 4; ++k) { killed[$1, $2, k] += $(4 + k) == "killed"; killed[$1, "all", k] += $(4 + k) == "killed" }
               ++n[$1, $2]; ++n[$1, "all"]; operators[$2] = 1; programs[$1] = 1 }
  END {
    print "| program | operator | mutants | a | b | c | d |\n|---|---|---|---|---|---|---|"
    split("value relational arithmetic logical negation omission initialization timer all", order)
    for (p = 1; p <= 2; ++p) {
      program = p == 1 ? "cell" : "sorting"
      for (o = 1; o in order; ++o) {
        if (!((program, order[o]) in n)) continue
        row = "| " program " | " order[o] " | " n[program, order[o]]
        for (k = 1; k <= 4; ++k) row = row " | " killed[program, order[o], k]
        print row " |"
      }
      all += n[program, "all"]; good += killed[program, "all", 4]
      timers += n[program, "timer"]; good_timers += killed[program, "timer", 4]
    }
    printf "%d of %d mutants are killed (%.0f %%), %d of %d of timers\n", good, all, 100 * good / all, good_timers, timers
    if (every > 1) exit good < 0.75 * all  # a few of them
    exit good < 0.9 * all || good_timers < 0.8 * timers
  }' "$work/rows"
