#!/usr/bin/env bash
# What a second build does: nothing; after touching a list: generates; after a change: compiles. usage: as consumer.sh
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cmake=$1 source=$2
shift 2

cp -r "$source" "$work/source"
list="$work/source/symbol lists/press_line.csv"
"$cmake" -S "$work/source" -B "$work/build" "$@" >"$work/configure.log" 2>&1 || fail "configuring" "$work/configure.log"
build "$cmake" "$work/first.log"

must_do() { # LOG WHAT...
  local what
  for what in "${@:2}"; do grep -q "$what" "$1" || fail "the build shows nothing of: $what" "$1"; done
}
must_do_nothing() { # LOG
  if grep -E 'Building|Linking|Generating' "$1"; then fail "a build without a change does something" "$1"; fi
}

must_do "$work/first.log" Generating Building Linking
build "$cmake" "$work/second.log"
must_do_nothing "$work/second.log"

touch "$list"
build "$cmake" "$work/touched.log"
must_do "$work/touched.log" Generating
build "$cmake" "$work/after_touched.log"
must_do_nothing "$work/after_touched.log"

echo 'VAR_GLOBAL,HALL2_PRESS_DOOR_I_CLOSED,X2,%IX2,BOOL,FALSE' >>"$list"
build "$cmake" "$work/changed.log"
must_do "$work/changed.log" Generating Building Linking
"$work/build/press" --until 1s >"$work/press.log" || fail "the plant does not run" "$work/press.log"
grep -q '^plant .*: 5 I/O symbols' "$work/press.log" || fail "the new symbol is not in the plant" "$work/press.log"
build "$cmake" "$work/last.log"
must_do_nothing "$work/last.log"

echo 'VAR_GLOBAL,"HALL2_PRESS_DOOR_I_OPEN,X3,%IX3,BOOL,FALSE' >>"$list"
if "$cmake" --build "$work/build" >"$work/bad.log" 2>&1; then fail "a list that cannot be read passes" "$work/bad.log"; fi
