#!/usr/bin/env bash
# The status line: drawn each second, but only on a capable terminal. usage: status_line.sh SYMPLANT LIST
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
command -v script >/dev/null || skip "script, which gives a program a terminal, is not installed"
run="$1 run $2 --link modbus-tcp-server://127.0.0.1:0 --until 2200ms"
line=$'\r\033\\[K[0-9]* cycles, late by [0-9.]* us (p99), [0-9]* overruns; link waiting'

TERM=xterm script -qec "$run" /dev/null >"$work/terminal" </dev/null
(($(grep -o "$line" "$work/terminal" | wc -l) >= 2)) || fail "no status line each second"
tail -n 9 "$work/terminal" | grep $'\033\\[Kended at 2.2 s' >/dev/null || fail "the line is not taken away at the end"
$run >"$work/file"
TERM=dumb script -qec "$run" /dev/null >"$work/dumb" </dev/null
if grep -q $'\033' "$work/file" "$work/dumb"; then fail "a line is drawn where there is no terminal for it"; fi
